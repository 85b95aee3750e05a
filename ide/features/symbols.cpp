#include "ide/features/symbols.h"

#include "ide/completion/fuzzy.h"
#include "ide/description/describe.h"
#include "ide/snapshot/fiacre_file.h"
#include "ide/snapshot/symbol_key.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

namespace proskill::ide {

namespace {

namespace fs = std::filesystem;

using analysis::kNoSymbol;
using analysis::SymbolId;
using analysis::SymbolKind;

constexpr std::size_t kMostFound = 256;

constexpr SymbolKind kInner[] = {
    SymbolKind::Value,        SymbolKind::Parameter,  SymbolKind::PreconditionTag,
    SymbolKind::InvariantTag, SymbolKind::SuccessTag, SymbolKind::FailureTag,
    SymbolKind::Label};

/// Limits the range of a nested definition to that of the outer one.
syntax::Range within(syntax::Range inner, syntax::Range outer) {
  return {std::clamp(inner.begin, outer.begin, outer.end),
          std::clamp(inner.end, outer.begin, outer.end)};
}

OutlineEntry childOf(const analysis::Symbol& symbol, const OutlineEntry& parent) {
  OutlineEntry child{std::string(symbol.name), std::string(analysis::words(symbol.kind)),
                     symbol.kind};
  child.range = within(symbol.extent, parent.range);
  child.selection = within(symbol.at.range, child.range);
  return child;
}

void addChildren(OutlineEntry& entry, const View& view, SymbolId owner) {
  const auto& symbols = view.index().symbols();
  for (auto kind : kInner)
    for (auto id : symbols.members(kind, owner))
      entry.children.push_back(childOf(symbols[id], entry));
  std::ranges::stable_sort(entry.children, {},
                           [](const OutlineEntry& child) { return child.range.begin; });
}

OutlineEntry ofInclude(const syntax::Include& include, syntax::Range range) {
  OutlineEntry entry{include.path ? std::string(include.path.text) : "include"};
  entry.isFile = true;
  entry.range = range;
  entry.selection = within(include.path.range, range);
  return entry;
}

OutlineEntry ofDefinition(const View& view, const syntax::Form& form, SymbolId id) {
  const auto& symbol = view.index().symbols()[id];
  OutlineEntry entry{std::string(symbol.name), std::string(form.keyword.text), symbol.kind};
  if (symbol.name.empty()) entry.name = form.keyword.text;
  // as written: the entry must not depend on other definitions, such as constants
  if (const auto* variable = form.as<syntax::StateVariable>())
    entry.detail = fmt::format("{}: {}", symbol.name, valuesOf(*variable));
  if (symbol.kind == SymbolKind::Constant) entry.detail = signature(view, id);
  entry.range = form.range;
  entry.selection = within(symbol.at.range, form.range);
  addChildren(entry, view, id);
  return entry;
}

struct Scored {
  int score = 0;
  FoundSymbol found;
};

/// Collects the best matches in the files that are added.
class Search {
public:
  explicit Search(std::string_view query) : query(query) {}

  void add(const fs::path& file, const FileNames& names) {
    for (const auto& name : names.all()) {
      const auto word = names.wordOf(name);
      if (word.empty()) continue;
      if (const auto score = fuzzyScore(query, word)) add(*score, file, names, name);
    }
  }

  std::vector<FoundSymbol> best() && {
    cut();
    std::vector<FoundSymbol> result;
    for (auto& each : all) result.push_back(std::move(each.found));
    return result;
  }

private:
  /// Nested names have a lower score.
  void add(int score, const fs::path& file, const FileNames& names, const FileNames::Name& name) {
    constexpr int kInside = 8;
    if (name.isInner) score -= kInside;
    if (all.size() >= 4 * kMostFound) cut();
    if (worst && score <= *worst) return;
    FoundSymbol found{std::string(names.wordOf(name)), name.kind, file, name.at};
    if (name.isInner) found.owner.emplace(names.ownerOf(name));
    all.push_back({score, std::move(found)});
  }

  /// Among equal scores, the first ones are kept.
  void cut() {
    std::ranges::stable_sort(all, std::ranges::greater(), &Scored::score);
    if (all.size() < kMostFound) return;
    all.resize(kMostFound);
    worst = all.back().score;
  }

  std::string_view query;
  std::vector<Scored> all;
  std::optional<int> worst; ///< others must be better than this
};

/// Files outside the workspace that its files include, directly or not, by canonical name.
std::map<std::string, fs::path> includedFromOutside(const Snapshot& snapshot) {
  std::map<std::string, fs::path> result;
  std::vector<fs::path> pending;
  auto note = [&](const std::string& canonical, const fs::path& path) {
    if (!snapshot.isKnown(canonical) && result.emplace(canonical, path).second)
      pending.push_back(path);
  };
  for (const auto& file : snapshot.knownFiles())
    for (const auto& include : file->includes) note(include.canonical, include.path);
  while (!pending.empty()) {
    const auto file = std::move(pending.back());
    pending.pop_back();
    if (const auto document = snapshot.documentOf(file))
      for (const auto& path : includesOf(file, *document))
        note(snapshot.canonical(path).native(), path);
  }
  return result;
}

} // namespace

std::vector<OutlineEntry> outline(const View& view) {
  return outline(view, {0, static_cast<syntax::Offset>(view.text().size())});
}

std::vector<OutlineEntry> outline(const View& view, syntax::Range within) {
  std::vector<OutlineEntry> result;
  for (const auto& form : view.document().formsIn(within)) {
    if (const auto* include = form.as<syntax::Include>()) {
      result.push_back(ofInclude(*include, form.range));
      continue;
    }
    const auto id = symbolOf(view, view.file, form);
    if (id != kNoSymbol) result.push_back(ofDefinition(view, form, id));
  }
  return result;
}

/// The names in an open text are the current ones.
std::vector<FoundSymbol> workspaceSymbols(const Snapshot& snapshot, std::string_view query,
                                          const std::function<bool()>& isCancelled) {
  Search search(query);
  auto addText = [&](const fs::path& file) {
    const auto document =
        isFiacre(file) ? std::unexpected(std::string()) : snapshot.documentOf(file);
    if (document) search.add(file, FileNames(*document));
  };
  for (const auto& file : snapshot.knownFiles()) {
    if (isCancelled()) return std::move(search).best();
    if (snapshot.open().contains(file->name))
      addText(file->name);
    else
      search.add(file->name, file->names);
  }
  for (const auto& [canonical, file] : includedFromOutside(snapshot))
    if (!isCancelled()) addText(file);
  return std::move(search).best();
}

} // namespace proskill::ide
