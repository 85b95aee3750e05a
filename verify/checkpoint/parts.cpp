#include "verify/checkpoint/parts.h"

#include "verify/state/evaluate.h"

#include <bit>

namespace proskill::verify {

namespace {

constexpr std::size_t kLongestReason = 4096; // bytes
constexpr Bound kLargest = INT32_MAX / 2;    // of a finite bound: sums of two have room

} // namespace

void ZoneRanks::count() {
  before.clear();
  total = 0;
  for (const auto word : words) {
    before.push_back(total);
    total += static_cast<std::uint32_t>(std::popcount(word));
  }
}

std::uint32_t ZoneRanks::rank(ZoneId zone) const {
  const std::uint64_t smaller = words[zone / 64] & ((std::uint64_t{1} << zone % 64) - 1);
  return before[zone / 64] + static_cast<std::uint32_t>(std::popcount(smaller));
}

/// Each changed byte: how far it is from the one before, and its changed bits. A 0 ends the list.
void writeState(CheckpointWriter& to, const Word* from, const Word* state, std::uint32_t words) {
  std::size_t last = 0; // 1 + position
  for (std::size_t i = 0; i < words; ++i) {
    Word changed = from[i] ^ state[i];
    for (std::size_t at = 8 * i + 1; changed != 0; changed >>= 8, ++at) {
      if ((changed & 0xFF) == 0) continue;
      to.number(at - last);
      to.byte(static_cast<std::uint8_t>(changed));
      last = at;
    }
  }
  to.number(0);
}

void readState(CheckpointReader& from, Word* state, std::uint32_t words) {
  const std::size_t bytes = std::size_t{8} * words;
  std::size_t at = 0;
  while (const std::uint64_t step = from.numberBelow(bytes - at + 1)) {
    at += step;
    state[(at - 1) / 8] ^= Word{from.byte()} << 8 * ((at - 1) % 8);
  }
}

bool isState(const System& system, const Word* state) {
  for (std::size_t i = 0; i < system.cells.size(); ++i) {
    const Cell& cell = system.cells[i];
    if (cell.mask == 0 || cell.word >= system.storedWords) continue;
    if (readCell(system, static_cast<CellId>(i), state) > cell.high) return false;
  }
  return true;
}

void writeZone(CheckpointWriter& to, std::uint32_t dimension, std::span<const Bound> matrix) {
  to.number(dimension);
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    if (i % (dimension + 1) == 0) continue; // the diagonal
    to.signedNumber(matrix[i] == kInfinite ? 0 : matrix[i] < 0 ? matrix[i] : matrix[i] + 1);
  }
}

std::optional<Dbm> readZone(CheckpointReader& from, std::uint32_t most) {
  const std::uint32_t dimension = from.indexBelow(std::uint64_t{most} + 1);
  if (dimension == 0) return from.fail(), std::nullopt;
  std::vector<Bound> matrix(std::size_t{dimension} * dimension, kZero);
  for (std::size_t i = 0; i < matrix.size() && !from.hasFailed(); ++i) {
    if (i % (dimension + 1) == 0) continue;
    const std::int64_t bound = from.signedNumber();
    if (bound > kLargest || bound < -kLargest) from.fail();
    matrix[i] = bound == 0 ? kInfinite : static_cast<Bound>(bound < 0 ? bound : bound - 1);
  }
  return from.hasFailed() ? std::nullopt : std::optional(Dbm(dimension, matrix));
}

void writeSteps(CheckpointWriter& to, std::span<const TransitionId> steps) {
  to.number(steps.size());
  for (const auto step : steps) to.number(step);
}

std::vector<TransitionId> readSteps(CheckpointReader& from, std::size_t transitions) {
  std::vector<TransitionId> steps;
  for (auto left = from.number(); left > 0 && !from.hasFailed(); --left)
    steps.push_back(from.indexBelow(transitions));
  if (from.hasFailed()) steps.clear();
  return steps;
}

void writeCounts(CheckpointWriter& to, const Exploration& counts) {
  for (const auto number : {counts.classes, counts.markings, counts.domains, counts.transitions,
                            counts.bytes, counts.known, counts.sliced})
    to.number(number);
  to.number(counts.complete ? 1 : 0);
  to.text(counts.stopped);
}

Exploration readCounts(CheckpointReader& from) {
  Exploration counts;
  for (auto* number : {&counts.classes, &counts.markings, &counts.domains, &counts.transitions,
                       &counts.bytes, &counts.known, &counts.sliced})
    *number = from.number();
  counts.complete = from.flag();
  counts.stopped = from.text(kLongestReason);
  return counts;
}

} // namespace proskill::verify
