#pragma once

#include "verify/explore/search.h"
#include "verify/trace/footprint.h"

#include <string>
#include <vector>

/// Why a run came out as it did: which steps each step depends on, and which of them matter to what
/// the run is a witness of. A dynamic backward slice: Korel and Laski, "Dynamic program slicing",
/// IPL 1988; of a concurrent run, over the interleaving that happened.
///
/// A step needs the cells that its guard and its code looked at, as far as they suffice
/// (footprint.h). For each such cell it depends on the last step before it that *changed* the cell;
/// where a step must wait, it depends on the step that started its clock; where others have
/// priority over it, on what kept them from being enabled. What the goal looks at (the condition
/// that is seen, the event of the last step, each transition's guard where nothing is possible any
/// more, each condition that a monitor reads) depends on steps likewise. Relevant are those, and
/// all that they depend on, again and again.
///
/// Why that is right: the relevant steps alone, taken in their order from the initial state, each
/// find their guard true and do what they did. By induction: a cell that the step needs was last
/// changed by a relevant step, which wrote the same value; no step between them is taken that
/// changes it, for a step that writes a cell without changing it in the run writes the same value
/// here. So the goal's cells have the same values at the end. `reproduces` checks just that.
///
/// What is not claimed: that the relevant steps are a run. Others may have to happen for time to
/// pass, or because they are urgent; they change nothing that matters to what is shown.
///
/// In a run that goes round for ever, a step of the loop may depend on steps of the round before,
/// so the loop is gone through twice. Nothing is left out of runs in which positions count (LTL),
/// and of those that end where time can never pass again: all that might happen then was looked at.
namespace proskill::verify {

struct Causes {
  std::vector<std::vector<std::size_t>> of; ///< by step: those that it depends on, from 0
  std::vector<std::vector<GroundValue>> grounds;
  std::vector<std::optional<Timer>> timers;
  std::vector<bool> relevant;
  std::vector<Support> support; ///< of the condition that the last state shows
};

/// \param enabling of the system, with nothing left out \pre the evidence was replayed
/// \throw LimitMet
[[nodiscard]] Causes causesOf(const System& system, const Enabling& enabling,
                              const fiacre::Provenance& provenance, const Goal& goal,
                              const Evidence& evidence, LimitWatch& limits);

/// Whether the relevant steps alone, without dates, can be taken one after the other, and come to
/// what the goal asks for, as far as one state or step shows it.
[[nodiscard]] bool reproduces(const System& system, const Goal& goal, const Evidence& evidence,
                              const std::vector<bool>& relevant);

} // namespace proskill::verify
