#include "verify/guide/novelty.h"

#include "verify/state/evaluate.h"

namespace proskill::verify {

namespace {

constexpr std::int64_t kMostOfCell = 256;  ///< values of a cell
constexpr std::size_t kMostInPairs = 8192; ///< values of all cells: a bit for each pair

} // namespace

Novelty::Novelty(const System& laidOut) : system(laidOut) {
  for (CellId i = 0; i < system.cells.size(); ++i) {
    const Cell& cell = system.cells[i];
    const auto size = cell.high - cell.low + 1;
    if (cell.mask == 0 || size < 2 || size > kMostOfCell) continue;
    tracked.push_back({i, count});
    count += static_cast<std::uint32_t>(size);
  }
  values.resize(tracked.size());
  if (count <= kMostInPairs) pairs.resize(std::size_t{count} * count);
}

void Novelty::readValues(const Word* state) {
  for (std::size_t i = 0; i < tracked.size(); ++i) {
    const auto& [cell, first] = tracked[i];
    const auto value = readCell(system, cell, state) - system.cells[cell].low;
    values[i] = first + static_cast<std::uint32_t>(value);
  }
}

void Novelty::expand(const Word* state) {
  readValues(state);
  before = values;
}

Novelty::Degree Novelty::seeValue(const Word* state, std::uint32_t group) {
  readValues(state);
  auto& known = seen[group];
  known.resize(count);
  auto degree = Degree::None;
  for (auto value : values) {
    if (known[value]) continue;
    known[value] = true;
    degree = Degree::Value;
  }
  return degree;
}

Novelty::Degree Novelty::seePair(const Word* state) {
  auto degree = seeValue(state, UINT32_MAX);
  if (pairs.empty()) return degree;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!before.empty() && values[i] == before[i]) continue;
    for (std::size_t k = 0; k < values.size(); ++k)
      if (isNewPair(values[i], values[k]) && degree == Degree::None) degree = Degree::Pair;
  }
  return degree;
}

bool Novelty::isNewPair(std::size_t one, std::size_t other) {
  const auto at = one < other ? one * count + other : other * count + one;
  if (pairs[at]) return false;
  return pairs[at] = true;
}

} // namespace proskill::verify
