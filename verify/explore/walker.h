#pragma once

#include "verify/reduce/free_inputs.h"
#include "verify/reduce/private_moves.h"
#include "verify/reduce/reductions.h"
#include "verify/reduce/stubborn_sets.h"
#include "verify/state/enabled.h"

namespace proskill::verify {

/// Transitions from the initial state on.
using Steps = std::vector<TransitionId>;

void append(Steps& to, const Steps& more);

/// A state on a way through the graph, and the steps that were taken.
struct Walk {
  std::vector<Word> state;
  TransitionSet enabled;
  Steps taken;
};

/// Takes the discrete steps of an exploration, those that its reductions add among them.
class Walker {
public:
  /// \pre the arguments outlive this
  Walker(const System& of, const Enabling& with, const Reductions& used)
      : system(of), enabling(with), reductions(used) {}

  /// As the exploration starts, with the values of open variables that stand for all.
  [[nodiscard]] Walk fromStart() const;
  [[nodiscard]] Walk from(std::vector<Word> state) const;
  /// A step, then the setters that lead back to the values that stand for all. False where the step
  /// is not possible.
  bool take(Walk& walk, TransitionId transition) const;
  /// To the values of open variables with which a transition is fired.
  /// \param choice which of the ways of FreeInputs::eachFiring
  void choose(Walk& walk, TransitionId transition, std::uint32_t choice) const;
  /// To values of open variables with which time may pass. \return the state before
  std::vector<Word> becomeCalm(Walk& walk) const;
  /// To the values of open variables that another state has.
  void moveInputs(Walk& walk, const std::vector<Word>& to) const;
  /// Takes the steps that the reductions allow to take alone.
  void runAlone(Walk& walk) const;
  /// The same, and forgets what is dead, as in a state that is stored.
  void arrive(Walk& walk) const;

  /// As long as there is a step that may be taken alone, takes it by `advance`, with the first of
  /// its choices of values of open variables; that says whether to go on. Stops where it comes by a
  /// state again: that state is then stored and expanded fully, so that nothing is put off for
  /// ever.
  template <class Advance>
  void followAlone(const std::vector<Word>& state, const TransitionSet& enabled,
                   Advance advance) const {
    if (!reductions.stubbornSets && !reductions.privateMoves) return;
    std::vector<Word> mark; // Brent: the state at the last power of two
    for (std::size_t length = 1;; ++length) {
      const TransitionId next = pickAlone(state, enabled);
      if (next == kNone || state == mark) return;
      if (std::has_single_bit(length)) mark = state;
      if (!advance(next)) return;
    }
  }

  /// To the values of open variables that stand for all.
  void normalise(Walk& walk) const;

  /// What time needs to know of the state: of all choices of values of open variables, where there
  /// are some.
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
