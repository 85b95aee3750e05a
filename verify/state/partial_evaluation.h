#pragma once

#include "verify/model/system.h"

/// Three-valued evaluation (Kleene) of guards in states in which some cells are unknown.
namespace proskill::verify {

enum class PartialTruth : std::uint8_t { False, True, Unknown };

/// A packed state in which some bits are unknown.
struct PartialState {
  const Word* state = nullptr;
  const Word* unknown = nullptr; ///< by word: the unknown bits
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

  /// Evaluates the tests and conditions of a transition's guard for all values of the unknown bits.
  /// Does not run the code of tentative transitions.
  /// \param undecided if the result is Unknown: bits on which it depends
  [[nodiscard]] PartialTruth guard(const System& system, const Transition& transition,
                                   const PartialState& at, BitField& undecided) const;

  /// The same for the tests of a guard.
  [[nodiscard]] PartialTruth tests(const System& system, const Transition& transition,
                                   const PartialState& at, BitField& undecided) const;
  /// The same for one of the conditions of a guard.
  [[nodiscard]] PartialTruth condition(const System& system, NodeId node, const PartialState& at,
                                       BitField& undecided) const;

private:
  /// By node: its evaluation may cause a fault, so its value is known only if all its cells are.
  std::vector<bool> opaque;
};

} // namespace proskill::verify
