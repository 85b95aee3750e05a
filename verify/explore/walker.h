#pragma once

#include "verify/reduce/free_inputs.h"
#include "verify/reduce/private_moves.h"
#include "verify/reduce/reductions.h"
#include "verify/reduce/stubborn_sets.h"
#include "verify/state/enabled.h"

namespace proskill::verify {

/// Transitions, in order, from the initial state unless stated otherwise.
using Steps = std::vector<TransitionId>;

void append(Steps& to, const Steps& more);

/// A state on a way through the graph, and the steps taken so far.
struct Walk {
  std::vector<Word> state;
  TransitionSet enabled;
  Steps taken;
};

/// Takes discrete steps as an exploration does, including the steps that its reductions add.
class Walker {
public:
  /// \pre the arguments outlive this
  Walker(const System& of, const Enabling& with, const Reductions& used)
      : system(of), enabling(with), reductions(used) {}

  /// The initial state, with representative values of the open variables.
  [[nodiscard]] Walk fromStart() const;
  [[nodiscard]] Walk from(std::vector<Word> state) const;
  /// Takes a step, then the setters that restore the representative values. Returns false if the
  /// step is not possible.
  bool take(Walk& walk, TransitionId transition) const;
  /// Sets the open variables to values with which a transition is fired.
  /// \param choice index of the way in FreeInputs::eachFiring
  void choose(Walk& walk, TransitionId transition, std::uint32_t choice) const;
  /// Sets the open variables to values with which time may pass. \return the state before
  std::vector<Word> becomeCalm(Walk& walk) const;
  /// Sets the open variables to their values in another state.
  void moveInputs(Walk& walk, const std::vector<Word>& to) const;
  /// Takes the steps that the reductions fire alone.
  void runAlone(Walk& walk) const;
  /// The same; then resets dead variables, as in stored states.
  void arrive(Walk& walk) const;

  /// While some step may be fired alone, fires it by `advance` with its first choice of values of
  /// the open variables. `advance` returns whether to continue. Stops when a state repeats: that
  /// state is stored and fully expanded, so that no step is postponed for ever.
  template <class Advance>
  void followAlone(const std::vector<Word>& state, const TransitionSet& enabled,
                   Advance advance) const {
    if (!reductions.stubbornSets && !reductions.privateMoves) return;
    std::vector<Word> mark; // Brent's algorithm: the state at the last power of two
    for (std::size_t length = 1;; ++length) {
      const TransitionId next = pickAlone(state, enabled);
      if (next == kNone || state == mark) return;
      if (std::has_single_bit(length)) mark = state;
      if (!advance(next)) return;
    }
  }

  /// Sets the open variables to their representative values.
  void normalise(Walk& walk) const;

  /// The timing signature of a state, over all values of its open variables.
  [[nodiscard]] SignatureId signature(const std::vector<Word>& state, const TransitionSet& enabled,
                                      Timing& timing) const;

private:
  [[nodiscard]] TransitionId pickAlone(const std::vector<Word>& state,
                                       const TransitionSet& enabled) const {
    const TransitionId safe =
        reductions.stubbornSets ? reductions.stubbornSets->pick(state.data(), enabled) : kNone;
    if (safe != kNone || !reductions.privateMoves) return safe;
    return reductions.privateMoves->pick(state.data());
  }

  const System& system;
  const Enabling& enabling;
  const Reductions& reductions;
  mutable std::vector<Word> trial; ///< a state with other values of open variables
};

} // namespace proskill::verify
