#include "analysis/names/symbol_change.h"

#include "syntax/text/change.h"

namespace proskill::analysis {

namespace {

using Ids = SymbolTable::Ids;

class Matching {
public:
  Matching(const SymbolTable& before, const SymbolTable& now) : before(before), now(now) {
    change.now.assign(before.all().size(), kNoSymbol);
  }

  SymbolChange matched() && {
    for (const SymbolKind kind :
         {SymbolKind::StateVariable, SymbolKind::Event, SymbolKind::Skill, SymbolKind::Resource,
          SymbolKind::Property, SymbolKind::Environment, SymbolKind::Constant})
      matchDefinitions(before.members(kind, kNoSymbol), now.members(kind, kNoSymbol));
    return std::move(change);
  }

private:
  void matchDefinitions(Ids old, Ids fresh) {
    const auto [front, back] = commonEnds(old, fresh);
    for (std::size_t i = 0; i < front; ++i) matchParts(old[i], fresh[i]);
    for (std::size_t i = 0; i < back; ++i)
      matchParts(old[old.size() - 1 - i], fresh[fresh.size() - 1 - i]);
    for (const SymbolId id : middle(old, front, back)) nameWithLabels(before, id);
    for (const SymbolId id : middle(fresh, front, back)) nameWithLabels(now, id);
  }

  void matchParts(SymbolId old, SymbolId fresh) {
    const Ids oldParts = before.parts(old);
    const Ids freshParts = now.parts(fresh);
    const auto [front, back] = commonEnds(oldParts, freshParts);
    if (front + back == oldParts.size() && front + back == freshParts.size()) return;
    name(before, old);
    nameLabels(before, middle(oldParts, front, back));
    nameLabels(now, middle(freshParts, front, back));
  }

  /// Finds the common beginning and end of the two lists.
  syntax::CommonEnds commonEnds(Ids old, Ids fresh) {
    const auto ends = syntax::commonEnds(old, fresh, [this](SymbolId a, SymbolId b) {
      return before[a].kind == now[b].kind && isSame(before[a].name, now[b].name);
    });
    for (std::size_t i = 0; i < ends.front; ++i) change.now[old[i]] = fresh[i];
    for (std::size_t i = 1; i <= ends.back; ++i)
      change.now[old[old.size() - i]] = fresh[fresh.size() - i];
    return ends;
  }

  /// Usually both are the same memory.
  static bool isSame(std::string_view a, std::string_view b) {
    return a.size() == b.size() && (a.data() == b.data() || a == b);
  }

  static Ids middle(Ids all, std::size_t front, std::size_t back) {
    const SymbolId first = *all.begin();
    return {first + static_cast<SymbolId>(front), first + static_cast<SymbolId>(all.size() - back)};
  }

  void name(const SymbolTable& table, SymbolId id) {
    if (!table[id].name.empty()) change.names.insert(table[id].name);
  }
  void nameWithLabels(const SymbolTable& table, SymbolId id) {
    name(table, id);
    nameLabels(table, table.parts(id));
  }
  void nameLabels(const SymbolTable& table, Ids parts) {
    for (const SymbolId part : parts)
      if (table[part].kind == SymbolKind::Label) name(table, part);
  }

  const SymbolTable& before;
  const SymbolTable& now;
  SymbolChange change;
};

} // namespace

SymbolChange changeBetween(const SymbolTable& before, const SymbolTable& now) {
  return Matching(before, now).matched();
}

} // namespace proskill::analysis
