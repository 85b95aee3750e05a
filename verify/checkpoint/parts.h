#pragma once

#include "verify/checkpoint/reader.h"
#include "verify/checkpoint/writer.h"
#include "verify/model/system.h"
#include "verify/state/timing.h"
#include "verify/verify.h"

#include <cstdint>
#include <optional>
#include <vector>

/// Parts of a checkpoint that several searches have.
namespace proskill::verify {

/// A set of zones, each of which gets a number: how many of the set have a smaller one.
class ZoneRanks {
public:
  explicit ZoneRanks(std::uint32_t zones) : words(zones / 64 + 1) {}
  void insert(ZoneId zone) { words[zone / 64] |= std::uint64_t{1} << zone % 64; }
  /// Call this when all are inserted.
  void count();
  [[nodiscard]] bool contains(ZoneId zone) const {
    return (words[zone / 64] >> zone % 64 & 1) != 0;
  }
  [[nodiscard]] std::uint32_t rank(ZoneId zone) const;
  [[nodiscard]] std::uint32_t size() const { return total; }

private:
  std::vector<std::uint64_t> words;
  std::vector<std::uint32_t> before; ///< by word: number of zones in earlier words
  std::uint32_t total = 0;
};

/// A packed state, as its difference from another one.
void writeState(CheckpointWriter& to, const Word* from, const Word* state, std::uint32_t words);
/// Reads a difference, and changes the state accordingly.
void readState(CheckpointReader& from, Word* state, std::uint32_t words);
/// Whether every variable of a stored state has one of its values.
[[nodiscard]] bool isState(const System& system, const Word* state);

void writeZone(CheckpointWriter& to, std::uint32_t dimension, std::span<const Bound> matrix);
/// Nothing after an error. \param most its greatest dimension
[[nodiscard]] std::optional<Dbm> readZone(CheckpointReader& from, std::uint32_t most);

void writeSteps(CheckpointWriter& to, std::span<const TransitionId> steps);
[[nodiscard]] std::vector<TransitionId> readSteps(CheckpointReader& from, std::size_t transitions);

void writeCounts(CheckpointWriter& to, const Exploration& counts);
[[nodiscard]] Exploration readCounts(CheckpointReader& from);

} // namespace proskill::verify
