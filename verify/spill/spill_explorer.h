#pragma once

#include "verify/explore/explorer.h"
#include "verify/reduce/prepared.h"
#include "verify/spill/item_sorter.h"
#include "verify/spill/node_file.h"
#include "verify/spill/visited_states.h"

namespace proskill::verify {

/// Breadth-first search of the zone graph with the graph on disk: see VisitedStates. Successors of
/// a level are compared with the earlier nodes when the level has been expanded, and then get their
/// numbers in the order in which they were reached first. So without inclusion the nodes, the
/// counts and the paths are those of an Explorer.
class SpillExplorer {
public:
  /// \pre the arguments outlive this
  /// \param found goals that are known to be reached
  SpillExplorer(const Prepared& prepared, Extrapolation extrapolation,
                const std::vector<Goal>& goals, std::vector<bool> found, LimitWatch& limits,
                SpillSpace& space, OnFound onFound);
  SpillExplorer(const SpillExplorer&) = delete;
  SpillExplorer& operator=(const SpillExplorer&) = delete;

  /// Call this once.
  Explored run();
  /// The transitions from the initial state to a node. \throw LimitMet
  [[nodiscard]] Steps pathTo(std::uint64_t node);

  /// Forgets all zones and signatures, to have memory for others.
  void forget();
  [[nodiscard]] const NodeFile& explored() const { return nodes; }
  [[nodiscard]] const Enabling& enabling() const { return graph.enabling; }
  [[nodiscard]] const Walker& walk() const { return walker; }
  [[nodiscard]] Timing& timing() { return graph.timing; }
  [[nodiscard]] Progress progress() const;

private:
  void explore();
  void start();
  void settle();
  void expandLevel();
  void expand(const SpilledNode& node);
  void forgetIfMany();
  void store();
  void found(const Notice& notice);
  [[nodiscard]] bool isOver() const {
    return !result.failure.empty() || (open == 0 && !goals.goals.empty());
  }
  void conclude();
  [[nodiscard]] std::uint64_t countDomains();
  void loadState(const std::vector<Word>& state);
  [[nodiscard]] PathNode placeOf(const SpilledNode& node);

  const System& system;
  const Reductions& reductions;
  LimitWatch& limits;
  SpillSpace& space;
  OnFound onFound;
  ZoneGraph graph; ///< without nodes: what expansions need
  Walker walker;
  OpenGoals goals;
  Expander expander;
  PathSteps pathSteps;
  SpillFormat format;
  CandidateRuns candidates;
  VisitedStates visited;
  ItemSorter reached; ///< new nodes, in the order in which they were reached
  NodeFile nodes;
  std::uint64_t first = 0;     ///< node of the level
  std::uint64_t expanding = 0; ///< 1 + the node; 0: none
  std::uint64_t arrivals = 0;  ///< so far
  std::size_t open = 0;        ///< number of undecided goals
  Explored result;

  Expansion work;
  std::vector<Word> whole; ///< a state with the words that are not stored
  TransitionSet enabled;
  SignatureId signature = 0;
};

} // namespace proskill::verify
