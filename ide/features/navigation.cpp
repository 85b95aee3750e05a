#include "ide/features/navigation.h"

#include "ide/snapshot/uses.h"

#include <algorithm>

namespace proskill::ide {

namespace {

using analysis::Occurrence;
using analysis::Role;
using analysis::SymbolKind;

const analysis::Symbol& symbolOf(const View& view, const Occurrence& occurrence) {
  return view.index().symbols()[occurrence.symbol];
}

/// The symbol that is the type of another, or none.
analysis::SymbolId typeOf(const View& view, const analysis::Symbol& symbol) {
  if (symbol.kind == SymbolKind::Value) return symbol.owner;
  if (symbol.kind != SymbolKind::Parameter) return analysis::kNoSymbol;
  const auto& skill = view.program().skills.all[view.index().symbols()[symbol.owner].definition];
  auto input = std::ranges::find_if(skill->inputs, [&](const syntax::Input& candidate) {
    return analysis::withoutDollar(candidate.name).text == symbol.name;
  });
  if (input == skill->inputs.end()) return analysis::kNoSymbol;
  return view.index().symbols().find(SymbolKind::StateVariable, input->type.text);
}

} // namespace

std::optional<Occurrence> occurrenceAt(const View& view, syntax::Offset at) {
  const auto* found = view.index().at(view.file, at);
  return found ? std::optional(*found) : std::nullopt;
}

std::optional<analysis::Location> definition(const View& view, syntax::Offset at) {
  auto occurrence = occurrenceAt(view, at);
  if (!occurrence) return std::nullopt;
  return symbolOf(view, *occurrence).at;
}

std::optional<analysis::Location> typeDefinition(const View& view, syntax::Offset at) {
  auto occurrence = occurrenceAt(view, at);
  if (!occurrence) return std::nullopt;
  auto type = typeOf(view, symbolOf(view, *occurrence));
  if (type == analysis::kNoSymbol) return std::nullopt;
  return view.index().symbols()[type].at;
}

std::vector<analysis::Location> implementations(const View& view, syntax::Offset at) {
  std::vector<analysis::Location> result;
  auto occurrence = occurrenceAt(view, at);
  if (!occurrence) return result;
  for (const auto& place : view.index().occurrencesOf(occurrence->symbol))
    if (isSetting(view, place)) result.push_back(place.at);
  return result;
}

std::vector<analysis::Location> references(const View& view, syntax::Offset at,
                                           bool withDefinition) {
  std::vector<analysis::Location> result;
  auto occurrence = occurrenceAt(view, at);
  if (!occurrence) return result;
  for (const auto& place : view.index().occurrencesOf(occurrence->symbol))
    if (withDefinition || place.role != Role::Definition) result.push_back(place.at);
  return result;
}

std::vector<Occurrence> highlights(const View& view, syntax::Offset at) {
  auto occurrence = occurrenceAt(view, at);
  if (!occurrence) return {};
  auto result = view.index().occurrencesOf(occurrence->symbol);
  std::erase_if(result, [&](const Occurrence& place) { return place.at.file != view.file; });
  return result;
}

} // namespace proskill::ide
