#include "verify/guide/novelty.h"

#include "verify/state/evaluate.h"

#include <algorithm>

namespace proskill::verify {

namespace {

constexpr std::int64_t kMostOfNumber = 256;  ///< values of a cell that is not a location
constexpr std::size_t kMostInPairs = 32'768; ///< values of all cells: half a byte for each pair
constexpr unsigned kMostLevel = 15;          ///< of how often a pair was seen

Bits locationsOf(const System& system) {
  Bits cells;
  for (const auto& instance : system.instances) cells.insert(instance.location);
  return cells;
}

} // namespace

Novelty::Novelty(const System& laidOut) : system(laidOut) {
  const Bits locations = locationsOf(system);
  for (CellId i = 0; i < system.cells.size(); ++i) {
    const Cell& cell = system.cells[i];
    const auto size = cell.high - cell.low + 1;
    if (cell.mask == 0 || size < 2 || (size > kMostOfNumber && !locations.contains(i))) continue;
    tracked.push_back({i, count});
    count += static_cast<std::uint32_t>(size);
  }
  values.resize(tracked.size());
  if (count <= kMostInPairs) pairs.resize(count);
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
  const auto isChanged = [&](std::size_t i) { return before.empty() || values[i] != before[i]; };
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!isChanged(i)) continue;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const bool isSeen = k <= i && isChanged(k); // or no pair
      if (!isSeen) degree = std::min(degree, see(values[i], values[k]));
    }
  }
  return degree;
}

/// Notes a pair. \return how often it was seen before: a level for each doubling, which is counted
/// at random
Novelty::Degree Novelty::see(std::uint32_t one, std::uint32_t other) {
  const auto [less, more] = std::minmax(one, other);
  auto& row = pairs[more];
  row.resize(more / 2 + std::size_t{1});
  std::uint8_t& both = row[less / 2];
  const unsigned shift = less % 2 * 4;
  const unsigned level = both >> shift & 15U;
  if (level < kMostLevel && (random() & ((1U << level) - 1)) == 0)
    both = static_cast<std::uint8_t>(both + (1U << shift));
  return static_cast<Degree>(Pair + level);
}

} // namespace proskill::verify
