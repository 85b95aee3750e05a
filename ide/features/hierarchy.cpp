#include "ide/features/hierarchy.h"

#include "ide/features/navigation.h"
#include "ide/snapshot/symbol_key.h"

#include <algorithm>
#include <map>
#include <span>
#include <tuple>

namespace proskill::ide {

namespace {

using analysis::Occurrence;
using analysis::Role;
using analysis::SymbolId;
using analysis::SymbolKind;

using Wanted = bool (*)(const View&, const Occurrence&);

bool isCall(const View&, const Occurrence& place) { return place.role == Role::Call; }

bool isUse(const View& view, const Occurrence& place) {
  return place.role != Role::Definition &&
         view.index().symbols()[place.symbol].kind == SymbolKind::StateVariable;
}

/// Places are sorted, so those in one definition are adjacent.
std::vector<Link> incoming(const View& view, SymbolId symbol, Wanted wanted) {
  std::vector<Link> links;
  for (const auto& place : view.index().occurrencesOf(symbol)) {
    if (!wanted(view, place)) continue;
    const auto user = definitionAround(view, place.at);
    if (user == analysis::kNoSymbol) continue;
    if (links.empty() || links.back().symbol != user) links.push_back({user, {}});
    links.back().places.push_back(place.at);
  }
  return links;
}

/// The occurrences in a definition.
std::span<const Occurrence> occurrencesIn(const View& view, const analysis::Symbol& symbol) {
  return view.index().occurrences({symbol.at.file, symbol.extent});
}

std::vector<Link> outgoing(const View& view, SymbolId symbol, Wanted wanted) {
  std::vector<Link> links;
  std::map<SymbolId, std::size_t> known;
  for (const auto& place : occurrencesIn(view, view.index().symbols()[symbol])) {
    if (!wanted(view, place)) continue;
    const auto [at, isNew] = known.try_emplace(place.symbol, links.size());
    if (isNew) links.push_back({place.symbol, {}});
    links[at->second].places.push_back(place.at);
  }
  return links;
}

std::optional<SymbolId> symbolAt(const View& view, syntax::Offset at, auto&& isWanted) {
  auto occurrence = occurrenceAt(view, at);
  if (!occurrence || !isWanted(view.index().symbols()[occurrence->symbol].kind))
    return std::nullopt;
  return occurrence->symbol;
}

} // namespace

std::optional<SymbolId> skillAt(const View& view, syntax::Offset at) {
  return symbolAt(view, at, [](SymbolKind kind) { return kind == SymbolKind::Skill; });
}

std::vector<Link> incomingCalls(const View& view, SymbolId skill) {
  return incoming(view, skill, isCall);
}

std::vector<Link> outgoingCalls(const View& view, SymbolId skill) {
  return outgoing(view, skill, isCall);
}

std::optional<SymbolId> userOrVariableAt(const View& view, syntax::Offset at) {
  return symbolAt(view, at, [](SymbolKind kind) {
    return kind < SymbolKind::Value && kind != SymbolKind::Resource && kind != SymbolKind::Constant;
  });
}

std::vector<Link> usersOfVariable(const View& view, SymbolId variable) {
  return incoming(view, variable, isUse);
}

std::vector<Link> variablesOf(const View& view, SymbolId user) {
  return outgoing(view, user, isUse);
}

} // namespace proskill::ide
