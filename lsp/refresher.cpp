#include "lsp/refresher.h"

#include <algorithm>

namespace proskill::lsp {

namespace {

bool shareProgram(const ide::IncludeGraph& graph, const std::filesystem::path& one,
                  const std::filesystem::path& other) {
  const auto roots = graph.rootsOf(one);
  return std::ranges::any_of(graph.rootsOf(other), [&](const auto& root) {
    return std::ranges::binary_search(roots, root);
  });
}

} // namespace

void Refresher::changed(const Path& file, const ide::Snapshot& then,
                        std::chrono::milliseconds delay) {
  if (!before) before = then.includes();
  files.insert(file);
  delayBy(delay);
}

void Refresher::allChanged(std::chrono::milliseconds delay) {
  all = true;
  delayBy(delay);
}

void Refresher::findingsChanged(std::chrono::milliseconds delay) {
  findings = true;
  delayBy(delay);
}

void Refresher::delayBy(std::chrono::milliseconds delay) {
  if (!client.refreshes.empty()) dueAt = std::chrono::steady_clock::now() + delay;
}

/// An edit may separate what was one program, or join what was two.
bool Refresher::concernsOthers(const ide::Snapshot& now) const {
  const auto& after = now.includes();
  for (const auto& file : files)
    for (const auto& [path, text] : now.open())
      if (path != file && text.kind != ide::TextKind::Notebook &&
          (shareProgram(*after, file, path) ||
           (before != after && shareProgram(*before, file, path))))
        return true;
  return false;
}

void Refresher::refresh(const ide::Snapshot& now) {
  dueAt.reset();
  const bool wanted = all ? !now.open().empty() : concernsOthers(now);
  if (wanted)
    ask({"workspace/semanticTokens/refresh", "workspace/inlayHint/refresh",
         "workspace/inlineValue/refresh", "workspace/codeLens/refresh"});
  if (wanted || findings) ask({"workspace/diagnostic/refresh"});
  all = findings = false;
  files.clear();
  before.reset();
}

void Refresher::ask(std::initializer_list<const char*> methods) {
  for (const auto* method : methods)
    if (client.refreshes.contains(method)) peer.ask(method, nullptr);
}

} // namespace proskill::lsp
