#include "ide/symbols.h"

#include "ide/describe.h"
#include "ide/fuzzy.h"
#include "ide/symbol_key.h"

#include <algorithm>
#include <set>

namespace proskill::ide {

namespace {

using analysis::kNoSymbol;
using analysis::SymbolId;
using analysis::SymbolKind;

constexpr std::size_t kMostFound = 256;

constexpr SymbolKind kInner[] = {
    SymbolKind::Value,        SymbolKind::Parameter,  SymbolKind::PreconditionTag,
    SymbolKind::InvariantTag, SymbolKind::SuccessTag, SymbolKind::FailureTag,
    SymbolKind::Label};

/// A definition that stands within another reaches no further, whatever the text says.
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
  if (symbol.kind == SymbolKind::StateVariable) entry.detail = signature(view, id);
  entry.range = form.range;
  entry.selection = within(symbol.at.range, form.range);
  addChildren(entry, view, id);
  return entry;
}

bool isSearched(SymbolKind kind) {
  switch (kind) {
  case SymbolKind::Parameter:
  case SymbolKind::PreconditionTag:
  case SymbolKind::InvariantTag:
  case SymbolKind::SuccessTag:
  case SymbolKind::FailureTag: return false;
  default: return true;
  }
}

struct Scored {
  int score = 0;
  FoundSymbol found;
};

/// What a file of several programs defines is found once.
class Search {
public:
  explicit Search(std::string_view query) : query(query) {}

  void add(const std::shared_ptr<const AnalysedProgram>& owner) {
    const auto& symbols = owner->analysis.index.symbols();
    for (SymbolId id = 0; id < symbols.all().size(); ++id) add(owner, symbols[id], id);
  }

  std::vector<FoundSymbol> best() && {
    std::ranges::stable_sort(all, std::ranges::greater(), &Scored::score);
    if (all.size() > kMostFound) all.resize(kMostFound);
    std::vector<FoundSymbol> result;
    for (auto& each : all) result.push_back(std::move(each.found));
    return result;
  }

private:
  void add(const std::shared_ptr<const AnalysedProgram>& owner, const analysis::Symbol& symbol,
           SymbolId id) {
    if (symbol.name.empty() || !isSearched(symbol.kind)) return;
    auto score = fuzzyScore(query, symbol.name);
    if (!score) return;
    const auto& path = owner->program.files[symbol.at.file].path;
    const bool isShared = owner->program.files.size() > 1;
    if (isShared && !seen.emplace(path.string(), symbol.at.range.begin).second) return;
    if (symbol.owner != kNoSymbol) *score -= 8;
    all.push_back({*score, {owner, id}});
  }

  std::string_view query;
  std::vector<Scored> all;
  std::set<std::pair<std::string, syntax::Offset>> seen;
};

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

std::vector<FoundSymbol> workspaceSymbols(const Snapshot& snapshot, std::string_view query,
                                          const std::function<bool()>& isCancelled) {
  Search search(query);
  for (const auto& root : snapshot.roots()) {
    if (isCancelled()) break;
    search.add(snapshot.view(root).owner);
  }
  return std::move(search).best();
}

} // namespace proskill::ide
