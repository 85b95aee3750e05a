#pragma once

#include "verify/model/system.h"

#include <cstdint>
#include <vector>

namespace proskill::verify {

/// What the states of runs have shown so far: the values of each cell, and the pairs of a value
/// with that of a number that the user watches. Where numbers count what has been done, such a pair
/// is new each time a run has come further.
class NewValues {
public:
  enum class Kind : std::uint8_t { None, Pair, Value };

  explicit NewValues(const System& of);

  /// Reads all of a state from which a run goes on.
  void goTo(const Word* state);
  /// What is new after a step, which is seen from now on.
  [[nodiscard]] Kind see(TransitionId step, const Word* state);

private:
  static constexpr std::uint32_t kUntracked = UINT32_MAX;

  /// The number of the value that a cell has.
  [[nodiscard]] std::uint32_t read(CellId cell, const Word* state) const;
  bool seePairs(CellId cell);
  [[nodiscard]] bool seePair(CellId number, CellId other);

  const System& system;
  std::vector<std::uint32_t> first; ///< by cell: the number of its least value, or kUntracked
  std::vector<CellId> tracked;
  std::vector<CellId> numbers;          ///< those that the user watches
  std::vector<bool> isNumber;           ///< by cell
  std::vector<bool> values;             ///< by number of the value
  std::vector<std::vector<bool>> pairs; ///< by value of a number, and by value
  std::vector<std::uint32_t> now;       ///< by cell: the number of its value
};

} // namespace proskill::verify
