#include "lsp/workspace/notebooks.h"

#include "lsp/protocol/convert.h"

#include <algorithm>

namespace proskill::lsp {

namespace {

const Json& listAt(const Json& json, std::initializer_list<const char*> path) {
  static const Json none = Json::array();
  const auto& found = rpc::memberAt(json, path);
  return found.is_array() ? found : none;
}

/// \return nullopt, and a problem, if the member is not a URI
std::optional<std::filesystem::path> pathAt(const Json& json, std::initializer_list<const char*> at,
                                            Notebooks::Outcome& outcome) {
  const auto& uri = rpc::memberAt(json, at);
  if (uri.is_string()) return pathOf(uri.get_ref<const std::string&>());
  std::string name;
  for (const auto* member : at) name += (name.empty() ? "" : ".") + std::string(member);
  outcome.problems.push_back("`" + name + "` is missing");
  return std::nullopt;
}

std::vector<std::filesystem::path> cellsIn(const Json& list, Notebooks::Outcome& outcome) {
  std::vector<std::filesystem::path> result;
  for (const auto& cell : list)
    if (auto path = pathAt(cell, {"document"}, outcome)) result.push_back(std::move(*path));
  return result;
}

/// Whether the client has opened this text by itself; it is then not a cell.
bool isText(const Workspace& workspace, const std::filesystem::path& path,
            Notebooks::Outcome& outcome) {
  const auto& open = workspace.snapshot()->open();
  const auto found = open.find(path);
  const bool isIt = found != open.end() && found->second.kind == ide::TextKind::File;
  if (isIt) outcome.problems.push_back(path.filename().string() + " is already open as a text");
  return isIt;
}

} // namespace

Notebooks::Outcome Notebooks::open(const Json& params, bool hasHalves) {
  Outcome outcome;
  const auto& document = rpc::memberAt(params, {"notebookDocument"});
  const auto path = pathAt(params, {"notebookDocument", "uri"}, outcome);
  if (!path || isText(workspace, *path, outcome)) return outcome;
  drop(*path, outcome);
  auto& notebook = notebooks[*path];
  notebook.uri = document["uri"];
  notebook.cells = cellsIn(listAt(document, {"cells"}), outcome);
  for (const auto& text : listAt(params, {"cellTextDocuments"}))
    openCell(notebook, text, hasHalves, outcome);
  join(*path, outcome);
  return outcome;
}

Notebooks::Outcome Notebooks::change(const Json& params, bool hasHalves) {
  Outcome outcome;
  const auto path = pathAt(params, {"notebookDocument", "uri"}, outcome);
  if (!path) return outcome;
  const auto found = notebooks.find(*path);
  if (found == notebooks.end()) {
    outcome.problems.emplace_back("a change of a notebook that is not open");
    return outcome;
  }
  auto& notebook = found->second;
  const auto& cells = rpc::memberAt(params, {"change", "cells"});
  restructure(notebook, rpc::memberAt(cells, {"structure"}), hasHalves, outcome);
  for (const auto& text : listAt(cells, {"textContent"}))
    changeCell(notebook, text, hasHalves, outcome);
  join(*path, outcome);
  return outcome;
}

Notebooks::Outcome Notebooks::close(const Json& params) {
  Outcome outcome;
  const auto path = pathAt(params, {"notebookDocument", "uri"}, outcome);
  if (!path) return outcome;
  if (!notebooks.contains(*path))
    outcome.problems.emplace_back("a notebook was closed that is not open");
  drop(*path, outcome);
  return outcome;
}

/// A cell that one message both closes and opens is open afterwards.
void Notebooks::restructure(Notebook& notebook, const Json& structure, bool hasHalves,
                            Outcome& outcome) {
  if (!structure.is_object()) return;
  for (const auto& text : listAt(structure, {"didClose"})) closeCell(notebook, text, outcome);
  for (const auto& text : listAt(structure, {"didOpen"}))
    openCell(notebook, text, hasHalves, outcome);
  const auto& start = rpc::memberAt(structure, {"array", "start"});
  const auto& count = rpc::memberAt(structure, {"array", "deleteCount"});
  auto& cells = notebook.cells;
  const bool fits = start.is_number_unsigned() && count.is_number_unsigned() &&
                    start.get<std::size_t>() <= cells.size() &&
                    count.get<std::size_t>() <= cells.size() - start.get<std::size_t>();
  if (!fits) {
    outcome.problems.push_back("a change of a notebook's cells does not fit them" +
                               std::string(kReopenNotebook));
    return;
  }
  const auto at = cells.begin() + start.get<std::ptrdiff_t>();
  const auto rest = cells.erase(at, at + count.get<std::ptrdiff_t>());
  const auto added = cellsIn(listAt(structure, {"array", "cells"}), outcome);
  cells.insert(rest, added.begin(), added.end());
}

void Notebooks::openCell(Notebook& notebook, const Json& text, bool hasHalves, Outcome& outcome) {
  const auto path = pathAt(text, {"uri"}, outcome);
  if (!path) return;
  if (rpc::memberAt(text, {"languageId"}) != "proskill") {
    notebook.unserved.insert(*path);
    return;
  }
  if (isText(workspace, *path, outcome)) return;
  const auto opened = workspace.open({{"textDocument", text}}, ide::TextKind::Cell, hasHalves);
  if (!opened) {
    outcome.problems.push_back(opened.error());
    return;
  }
  notebook.unserved.erase(*path);
  notebook.open.insert(*path);
  outcome.changed.push_back(*path);
}

void Notebooks::changeCell(Notebook& notebook, const Json& change, bool hasHalves,
                           Outcome& outcome) {
  const auto path = pathAt(change, {"document", "uri"}, outcome);
  if (!path || notebook.unserved.contains(*path)) return;
  if (!notebook.open.contains(*path)) {
    outcome.problems.emplace_back("a change of a cell that is not open in its notebook");
    return;
  }
  outcome.changed.push_back(*path);
  const auto changed = workspace.change({{"textDocument", change["document"]},
                                         {"contentChanges", rpc::memberAt(change, {"changes"})}},
                                        hasHalves);
  if (!changed) outcome.problems.push_back(changed.error() + kReopenNotebook);
}

void Notebooks::closeCell(Notebook& notebook, const Json& text, Outcome& outcome) {
  const auto path = pathAt(text, {"uri"}, outcome);
  if (!path || notebook.unserved.erase(*path) > 0) return;
  if (notebook.open.erase(*path) == 0) {
    outcome.problems.emplace_back("a cell was closed that is not open in its notebook");
    return;
  }
  workspace.close(*path);
  outcome.changed.push_back(*path);
}

void Notebooks::join(const Path& path, Outcome& outcome) {
  const auto& notebook = notebooks.at(path);
  std::vector<Path> cells;
  for (const auto& cell : notebook.cells)
    if (notebook.open.contains(cell) && !lostIn(workspace.inexactTexts(), cell))
      cells.push_back(cell);
  if (workspace.join(path, notebook.uri, cells))
    outcome.changed.insert(outcome.changed.begin(), path);
}

/// Removes all cells, whatever the message lists.
void Notebooks::drop(const Path& path, Outcome& outcome) {
  const auto notebook = notebooks.extract(path);
  if (!notebook) return;
  for (const auto& cell : notebook.mapped().open) {
    workspace.close(cell);
    outcome.changed.push_back(cell);
  }
  workspace.close(path);
  outcome.changed.push_back(path);
}

} // namespace proskill::lsp
