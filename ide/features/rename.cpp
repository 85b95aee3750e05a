#include "ide/features/rename.h"

#include "ide/features/navigation.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace proskill::ide {

namespace {

namespace fs = std::filesystem;
using analysis::Occurrence;
using analysis::SymbolKind;

bool isName(std::string_view text) {
  auto begins = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  auto goesOn = [&](char c) { return begins(c) || (c >= '0' && c <= '9'); };
  return !text.empty() && begins(text.front()) && std::ranges::all_of(text, goesOn);
}

std::string placeText(const analysis::Program& program, analysis::Location at) {
  const auto& file = program.files[at.file];
  const auto line = file.document.lines().position(at.range.begin).line + 1;
  return fmt::format("{}:{}", file.path.filename().string(), line);
}

/// The texts of a program with the new name, under whatever names it includes them.
class Renamed : public analysis::FileSystem {
public:
  Renamed(const Snapshot& snapshot, const analysis::Program& program, const RenamePlan& plan)
      : snapshot(snapshot) {
    for (const auto& file : program.files) {
      auto text = file.document.text();
      if (auto found = plan.places.find(file.path); found != plan.places.end())
        for (const auto& range : found->second | std::views::reverse)
          text.replace(range.begin, range.length(), plan.text);
      texts.emplace(file.path, std::move(text));
    }
  }

  [[nodiscard]] std::expected<std::string, std::string> read(const fs::path& path) const override {
    auto found = texts.find(nameOf(path));
    if (found == texts.end()) return std::unexpected("not a file of the program");
    return found->second;
  }
  [[nodiscard]] fs::path canonical(const fs::path& path) const override {
    return snapshot.canonical(path);
  }
  [[nodiscard]] fs::path nameOf(const fs::path& path) const override {
    return snapshot.nameOf(path);
  }

private:
  const Snapshot& snapshot;
  std::map<fs::path, std::string> texts;
};

/// The first occurrence whose meaning changes, at its old place; nullopt if there is none.
std::optional<Occurrence> changedMeaning(std::span<const Occurrence> before,
                                         std::span<const Occurrence> after) {
  auto differs = [](const Occurrence& a, const Occurrence& b) {
    return a.symbol != b.symbol || a.role != b.role || a.at.file != b.at.file;
  };
  const auto [old, fresh] = std::ranges::mismatch(
      before, after, [&](const Occurrence& a, const Occurrence& b) { return !differs(a, b); });
  if (old != before.end()) return *old;
  if (fresh != after.end()) return before.empty() ? Occurrence{} : before.back();
  return std::nullopt;
}

std::size_t errorsOf(const analysis::Analysis& analysis) {
  return static_cast<std::size_t>(
      std::ranges::count(analysis.diagnostics, syntax::Severity::Error,
                         [](const syntax::Diagnostic& it) { return it.severity; }));
}

/// Why the renaming would break the program; empty if it does not.
std::string captured(const Snapshot& snapshot, const AnalysedProgram& before,
                     const RenamePlan& plan) {
  const Renamed files(snapshot, before.program, plan);
  const auto program =
      analysis::load(files, before.program.files.front().path, before.program.extent);
  const auto analysis = analysis::analyse(program);
  const auto changed =
      changedMeaning(before.analysis.index.occurrences(), analysis.index.occurrences());
  if (changed)
    return fmt::format("`{}` would get another meaning at {}", plan.text,
                       placeText(before.program, changed->at));
  if (errorsOf(analysis) > errorsOf(before.analysis))
    return fmt::format("with the name `{}` the program would have an error", plan.text);
  return {};
}

/// Tags that `skill.res` can be compared with share a namespace.
std::vector<SymbolKind> rivals(SymbolKind kind) {
  switch (kind) {
  case SymbolKind::SuccessTag:
  case SymbolKind::FailureTag:
  case SymbolKind::InvariantTag:
    return {SymbolKind::SuccessTag, SymbolKind::FailureTag, SymbolKind::InvariantTag};
  default: return {kind};
  }
}

/// The meaning of the name in one program.
struct Meaning {
  View view;
  analysis::SymbolId symbol;
};

std::string takenBy(const Meaning& meaning, std::string_view name) {
  const auto& symbols = meaning.view.index().symbols();
  const auto& symbol = symbols[meaning.symbol];
  for (auto kind : rivals(symbol.kind)) {
    const auto other = symbols.find(kind, name, symbol.owner);
    if (other != analysis::kNoSymbol)
      return fmt::format("there is already a {} `{}`, at {}", analysis::words(kind), name,
                         placeText(meaning.view.program(), symbols[other].at));
  }
  return {};
}

/// Positions of the name, by file. A file may belong to several programs, with the same positions.
using Places = std::map<fs::path, std::set<syntax::Offset>>;

/// Adds the positions in one program.
void collect(Places& places, const Meaning& meaning) {
  const auto& files = meaning.view.program().files;
  for (const auto& place : meaning.view.index().occurrencesOf(meaning.symbol))
    places[files[place.at.file].path].insert(place.at.range.begin);
}

/// Identifies a program, which may have been analysed more than once.
const fs::path& rootOf(const View& view) { return view.program().files.front().path; }

/// Adds the other programs that contain an occurrence of the name.
/// \param looked roots of the programs already examined
void addPrograms(std::vector<Meaning>& known, std::set<fs::path>& looked, const Snapshot& snapshot,
                 const Meaning& meaning) {
  auto isLooked = [&](const fs::path& root) { return looked.contains(root); };
  std::set<analysis::FileId> seen;
  for (const auto& place : meaning.view.index().occurrencesOf(meaning.symbol)) {
    if (!seen.insert(place.at.file).second) continue;
    const auto& path = meaning.view.program().files[place.at.file].path;
    if (std::ranges::all_of(snapshot.includes()->rootsOf(path), isLooked)) continue;
    snapshot.eachView(path, [&](const View& view) {
      if (isLooked(rootOf(view))) return;
      const auto there = occurrenceAt(view, place.at.range.begin);
      if (!there) return;
      looked.insert(rootOf(view));
      known.push_back({view, there->symbol});
    });
  }
}

/// All programs that must change together: if two of them share a file that uses the name, each may
/// define the name itself.
std::vector<Meaning> meaningsOf(const Snapshot& snapshot, Meaning first, Places& places) {
  std::set<fs::path> looked{rootOf(first.view)};
  std::vector<Meaning> known{std::move(first)};
  for (std::size_t i = 0; i < known.size(); ++i) {
    const auto meaning = known[i];
    collect(places, meaning);
    addPrograms(known, looked, snapshot, meaning);
  }
  return known;
}

RenamePlan planOf(const Places& places, std::size_t length, std::string_view newName) {
  RenamePlan plan{std::string(newName), {}};
  for (const auto& [path, offsets] : places)
    for (auto begin : offsets)
      plan.places[path].push_back({begin, begin + static_cast<syntax::Offset>(length)});
  return plan;
}

} // namespace

std::expected<Occurrence, std::string> renameable(const View& view, syntax::Offset at) {
  auto occurrence = occurrenceAt(view, at);
  if (!occurrence) return std::unexpected("not a name of the program");
  return *occurrence;
}

std::expected<RenamePlan, std::string> rename(const Snapshot& snapshot, const View& view,
                                              syntax::Offset at, std::string_view newName) {
  auto occurrence = renameable(view, at);
  if (!occurrence) return std::unexpected(occurrence.error());
  const auto& symbol = view.index().symbols()[occurrence->symbol];
  if (symbol.kind == SymbolKind::Parameter && newName.starts_with('$')) newName.remove_prefix(1);
  if (!isName(newName))
    return std::unexpected(
        fmt::format("`{}` is not a name: a name consists of letters, digits and `_`, "
                    "and does not begin with a digit",
                    newName));
  if (newName == symbol.name) return RenamePlan{std::string(newName), {}};

  Places places;
  const auto programs = meaningsOf(snapshot, {view, occurrence->symbol}, places);
  for (const auto& each : programs)
    if (auto why = takenBy(each, newName); !why.empty()) return std::unexpected(why);
  auto plan = planOf(places, symbol.name.size(), newName);
  for (const auto& each : programs)
    if (auto why = captured(snapshot, *each.view.owner, plan); !why.empty())
      return std::unexpected(why);
  return plan;
}

std::vector<syntax::Range> linkedPlaces(const View& view, syntax::Offset at) {
  auto occurrence = occurrenceAt(view, at);
  if (!occurrence) return {};
  const auto kind = view.index().symbols()[occurrence->symbol].kind;
  if (kind < SymbolKind::PreconditionTag) return {};
  std::vector<syntax::Range> result;
  for (const auto& place : view.index().occurrencesOf(occurrence->symbol)) {
    if (place.at.file != view.file) return {};
    result.push_back(place.at.range);
  }
  return result;
}

} // namespace proskill::ide
