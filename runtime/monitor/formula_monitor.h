#pragma once

#include "verify/model/monitor.h"
#include "verify/state/evaluate.h"

#include <vector>

namespace proskill::runtime {

/// Follows the automaton of a formula of LTL along a run. It reports that no run with this
/// beginning is accepted. Bauer, Leucker, Schallhart, "Runtime verification for LTL and TLTL",
/// TOSEM 2011.
///
/// The verified model takes steps that the executed one does not: those of watchdogs, which no
/// condition reads. A formula may count steps. So the automaton may read the current state, without
/// any event, as often as it likes: a verdict is given only if it is the same with any such steps.
class FormulaMonitor {
public:
  /// \pre the system and the automaton outlive this
  FormulaMonitor(const verify::System& system, const verify::Monitor& automaton);

  void start(const verify::Word* state);
  /// \param moment with the state after the step
  void step(const verify::Moment& moment);
  /// Whether no continuation is accepted.
  [[nodiscard]] bool isDead() const { return dead; }

private:
  void findLive();
  [[nodiscard]] bool reaches(std::uint32_t from, std::uint32_t to) const;
  void arrive(const verify::Word* state);
  [[nodiscard]] bool canGoOn(const verify::Word* state) const;

  const verify::System& system;
  const verify::Monitor& automaton;
  std::vector<bool> live; ///< locations from which some run is accepted, if conditions allow it
  std::vector<bool> current;
  std::vector<bool> next;
  bool dead = false;
};

/// Whether a condition can be true in the next step from a state, whatever happens in it.
[[nodiscard]] bool canHold(const verify::System& system, verify::NodeId condition,
                           const verify::Word* state);

} // namespace proskill::runtime
