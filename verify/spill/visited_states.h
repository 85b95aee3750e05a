#pragma once

#include "verify/spill/candidate_runs.h"
#include "verify/spill/state_zones.h"
#include "verify/spill/visited_run.h"

#include <functional>

namespace proskill::verify {

/// All states and zones that a search has found, on disk. Those of a level are compared with the
/// earlier ones together, in one pass over the files. Stern and Dill, "Using magnetic disk instead
/// of main memory in the Murphi verifier", CAV 1998; Korf, "Best-first frontier search with delayed
/// duplicate detection", AAAI 2004.
///
/// The files are runs, from the oldest to the newest. Each level adds one; small ones are merged,
/// so that there are few. O'Neil, Cheng, Gawlick, O'Neil, "The log-structured merge-tree", Acta
/// Informatica 1996.
class VisitedStates {
public:
  /// Receives a state with a zone that is new: an index in the group.
  using OnNew = std::function<void(const StateGroup&, std::size_t)>;

  /// \pre the argument outlives this
  VisitedStates(SpillSpace& space, const SpillFormat& format);

  /// Adds the candidates of a level, and visits those that are new, in the order of the states.
  /// \return what is new; with inclusion, also the earlier zones of these states \throw LimitMet
  std::shared_ptr<const VisitedRun> add(CandidateRuns& candidates, const OnNew& onNew);
  [[nodiscard]] std::uint64_t nodes() const { return nodeCount; }
  [[nodiscard]] std::uint64_t states() const { return stateCount; }
  [[nodiscard]] std::uint64_t bytes() const;

private:
  using Run = std::shared_ptr<const VisitedRun>;

  void addState(const StateGroup& group, VisitedRun& to, const OnNew& onNew);
  void keepUnknown(const StateGroup& group, const OnNew& onNew);
  void keepUncovered(const StateGroup& group, const OnNew& onNew);
  void noteNew(const StateGroup& group, std::size_t i, const OnNew& onNew);
  void write(const StateGroup& group, bool areMerged, VisitedRun& to);
  void mergeSmall();
  [[nodiscard]] Run merge(const VisitedRun& older, const VisitedRun& newer);

  SpillSpace& space;
  SpillFormat format;
  std::vector<Run> runs;
  std::vector<VisitedRun::Cursor> cursors; ///< of the runs, while a level is added
  std::uint64_t nodeCount = 0;
  std::uint64_t stateCount = 0;

  // of a state that is added:
  StateGroup earlier; ///< its known zones
  std::vector<bool> isKnown;
  StateZones zones;
  StateGroup kept;
  ByteText text;
  VisitedRun::Entry entry;
};

} // namespace proskill::verify
