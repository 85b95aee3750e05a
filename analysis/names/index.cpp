#include "analysis/names/index.h"

#include <algorithm>
#include <tuple>

namespace proskill::analysis {

namespace {

auto placeOf(const Occurrence& it) {
  return std::tuple(it.at.file, it.at.range.begin, it.at.range.end);
}

} // namespace

Index::Index(SymbolTable symbols, std::vector<Occurrence> occurrences)
    : table(std::move(symbols)), places(std::move(occurrences)) {
  const auto& all = table.all();
  for (SymbolId id = 0; id < all.size(); ++id)
    if (!all[id].name.empty()) places.push_back({id, all[id].at, Role::Definition});
  std::ranges::stable_sort(places, {}, placeOf);
}

Index::Index(SymbolTable symbols, std::vector<Occurrence> kept, std::vector<Occurrence> noted,
             const Scope& scope)
    : table(std::move(symbols)), places(std::move(kept)) {
  const auto& all = table.all();
  for (SymbolId id = 0; id < all.size(); ++id)
    if (!all[id].name.empty() && scope.holds(all[id].at.file, all[id].at.range.begin))
      noted.push_back({id, all[id].at, Role::Definition});
  std::ranges::stable_sort(noted, {}, placeOf);
  const auto middle = static_cast<std::ptrdiff_t>(places.size());
  places.insert(places.end(), noted.begin(), noted.end());
  std::ranges::inplace_merge(places, places.begin() + middle, {}, placeOf);
}

void Index::makeGroups() const {
  auto& [made, bySymbol, starts] = *groups;
  starts.assign(table.all().size() + 1, 0);
  for (const Occurrence& it : places) ++starts[it.symbol + 1];
  for (std::size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
  bySymbol.resize(places.size());
  auto next = starts;
  for (std::uint32_t i = 0; i < places.size(); ++i) bySymbol[next[places[i].symbol]++] = i;
}

std::span<const std::uint32_t> Index::group(SymbolId symbol) const {
  groups->made([this] { makeGroups(); });
  const auto begin = groups->starts[symbol], end = groups->starts[symbol + 1];
  return std::span(groups->bySymbol).subspan(begin, end - begin);
}

std::span<const Occurrence> Index::occurrences(Location within) const {
  const auto from = [&](syntax::Offset at) {
    return std::ranges::lower_bound(
        places, std::pair(within.file, at), {},
        [](const Occurrence& it) { return std::pair(it.at.file, it.at.range.begin); });
  };
  return {from(within.range.begin), from(within.range.end)};
}

const Occurrence* Index::at(FileId file, syntax::Offset offset) const {
  auto after =
      std::ranges::upper_bound(places, std::tuple(file, offset), {}, [](const Occurrence& it) {
        return std::tuple(it.at.file, it.at.range.begin);
      });
  if (after == places.begin()) return nullptr;
  const Occurrence& before = *std::prev(after);
  const bool touches = before.at.file == file && offset <= before.at.range.end;
  return touches ? &before : nullptr;
}

std::vector<Occurrence> Index::occurrencesOf(SymbolId symbol) const {
  std::vector<Occurrence> found;
  for (const std::uint32_t place : group(symbol)) found.push_back(places[place]);
  return found;
}

} // namespace proskill::analysis
