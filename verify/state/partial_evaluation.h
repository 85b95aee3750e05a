#pragma once

#include "verify/model/system.h"

/// Evaluation of guards where some cells are not known, in three values (Kleene).
namespace proskill::verify {

enum class PartialTruth : std::uint8_t { False, True, Unknown };

/// A packed state of which some bits are unknown.
struct PartialState {
  const Word* state = nullptr;
  const Word* unknown = nullptr; ///< by word: the bits that are not known
};

/// Some bits of a packed state.
struct BitField {
  std::uint32_t word = 0;
  Word mask = 0;
};

/// Evaluates guards of one system.
class PartialEvaluation {
public:
  /// \pre the system has a state layout
  explicit PartialEvaluation(const System& system);

  /// Whether the tests and conditions of the transition's guard hold, whatever the unknown bits
  /// are. A tentative transition's code is not run. \param undecided where it is unknown: bits on
  /// which that depends
  [[nodiscard]] PartialTruth guard(const System& system, const Transition& transition,
                                   const PartialState& at, BitField& undecided) const;

private:
  std::vector<bool> opaque; ///< by node: a fault decides its value, so it is known as a whole only
};

} // namespace proskill::verify
