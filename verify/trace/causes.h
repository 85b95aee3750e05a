#pragma once

#include "verify/explore/search.h"
#include "verify/trace/footprint.h"

#include <string>
#include <vector>

/// Explains a run: which steps each step depends on, and which steps matter to what the run shows.
/// This is a dynamic backward slice: Korel and Laski, "Dynamic program slicing", IPL 1988; here of
/// a concurrent run, over the interleaving that happened.
///
/// A step needs a sufficient subset of the cells that its guard and its code read (footprint.h).
/// For each such cell it depends on the last earlier step that *changed* the cell. If the step must
/// wait, it depends on the step that started its clock. If other transitions have priority over it,
/// it depends on what kept them from being enabled. The goal depends on steps in the same way, by
/// what it reads: the condition that holds, the event of the last step, each transition's guard in
/// a deadlock, or each condition that a monitor reads. The relevant steps are those on which the
/// goal depends, directly or indirectly.
///
/// Why this is correct: the relevant steps alone, taken in their order from the initial state, each
/// find their guard true and do what they did in the run. Proof by induction: a cell that a step
/// needs was last changed by a relevant step, which wrote the same value. No relevant step in
/// between changes it, because a step that writes a cell without changing it in the run writes the
/// same value here. So the cells of the goal have the same values at the end. `reproduces` checks
/// exactly this.
///
/// The relevant steps need not form a run. Other steps may be needed for time to pass, or because
/// they are urgent; they change nothing that matters to the goal.
///
/// If a run ends in a loop, a step of the loop may depend on steps of the previous iteration, so
/// two iterations are analysed. All steps are relevant in runs in which positions count (LTL), and
/// in runs that end where time can never pass again, because everything that might happen at their
/// end was examined.
namespace proskill::verify {

struct Causes {
  std::vector<std::vector<std::size_t>> of; ///< by step: the steps on which it depends, from 0
  std::vector<std::vector<GroundValue>> grounds;
  std::vector<std::optional<Timer>> timers;
  std::vector<bool> relevant;
  std::vector<Support> support; ///< of the condition that holds in the last state
};

/// \param enabling of the system, without skipped transitions
/// \pre the evidence was replayed
/// \throw LimitMet
[[nodiscard]] Causes causesOf(const System& system, const Enabling& enabling,
                              const fiacre::Provenance& provenance, const Goal& goal,
                              const Evidence& evidence, LimitWatch& limits);

/// Whether the relevant steps alone, without dates, can be taken in order and reach the goal, as
/// far as one state or step shows it.
[[nodiscard]] bool reproduces(const System& system, const Goal& goal, const Evidence& evidence,
                              const std::vector<bool>& relevant);

} // namespace proskill::verify
