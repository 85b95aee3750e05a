#pragma once

#include "verify/explore/open_waits.h"
#include "verify/explore/search.h"
#include "verify/explore/walker.h"
#include "verify/model/monitor.h"

#include <optional>
#include <vector>

namespace proskill::verify {

/// What a monitor did at a point of a run.
enum class MoveKind : std::uint8_t {
  Start,
  Silent, ///< of the monitor alone
  Step,
  Stutter, ///< the run has ended; its last state is read again
  Tick,    ///< time has gone on by 1 at least since the last one; see MonitorZones
  Rest,    ///< from here on no step is taken
};

struct WatchMove {
  MoveKind kind = MoveKind::Start;
  TransitionId transition = kNone;
  std::uint32_t edge = kNone; ///< of the location before; kNone: it stays there
  std::uint32_t choice = 0;   ///< of the values of open variables with which the step is fired
};

/// A state of the model and of its monitor, with the zone of the clocks of both.
struct WatchNode {
  StateId state = 0;
  ZoneId zone = 0;
  std::uint32_t location = 0;
  bool instant = false; ///< no time passes: the monitor has to move on
  bool rests = false;   ///< the model takes no more step
  NodeIndex parent = kNone;
  WatchMove move;
  NodeIndex next = kNone; ///< in the list of the nodes of this state
};

struct WatchArc {
  NodeIndex target = 0;
  WatchMove move;
};

/// What the cycle of a fair run needs.
struct FairNeeds {
  bool ticks = false; ///< time has to go on
  const std::vector<OpenWait>& waits;
  std::function<bool(NodeIndex, std::size_t)> isWaiting; ///< in a node, by place in `waits`
};

/// The graph that a search with a monitor has found so far, and the runs in it.
class MonitorGraph {
public:
  /// \param keepArcs whether cycles are looked for
  /// \param with takes the steps as the search does; has to outlive this
  MonitorGraph(const Monitor& of, bool keepArcs, const Walker& with)
      : monitor(of), cycles(keepArcs), walker(with) {}

  [[nodiscard]] std::size_t size() const { return nodes.size(); }
  [[nodiscard]] const WatchNode& at(NodeIndex node) const { return nodes[node]; }
  [[nodiscard]] std::uint64_t bytes() const;
  /// What the next few steps may add at once, since a table is nearly full.
  [[nodiscard]] std::uint64_t growth() const { return growthOf(nodes) + growthOf(arcs); }

  void addNode(const WatchNode& node);
  /// Only where cycles are looked for.
  void addArc(NodeIndex from, NodeIndex to, WatchMove move);

  /// The run from the beginning to a node, in a location that is an error.
  [[nodiscard]] Evidence evidenceTo(NodeIndex node) const;
  /// A run that comes to a cycle through an accepting location, and repeats it; nothing where there
  /// is none. Every node and every arc of a strongly connected component is on one cycle.
  [[nodiscard]] std::optional<Evidence> evidenceOfCycle(const System& system,
                                                        const FairNeeds& needs) const;

private:
  struct Way {
    std::vector<WatchMove> moves;
    std::vector<std::uint32_t> locations; ///< before each move
  };

  class CycleSearch;

  [[nodiscard]] Way wayTo(NodeIndex node) const;
  void append(Way& way, NodeIndex from, const WatchArc& arc) const;
  /// \param loop how many moves are before the part that is repeated
  [[nodiscard]] Evidence evidenceOf(const Way& way, std::optional<std::size_t> loop) const;

  const Monitor& monitor;
  bool cycles;
  const Walker& walker;
  std::vector<WatchNode> nodes;
  std::vector<std::vector<WatchArc>> arcs; ///< by node
  std::uint64_t arcCount = 0;
};

} // namespace proskill::verify
