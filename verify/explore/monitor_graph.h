#pragma once

#include "verify/explore/open_waits.h"
#include "verify/explore/search.h"
#include "verify/explore/walker.h"
#include "verify/model/monitor.h"

#include <optional>
#include <vector>

namespace proskill::verify {

/// What a monitor reads or does at a point of a run.
enum class MoveKind : std::uint8_t {
  Start,
  Silent, ///< a move of the monitor alone
  Step,
  Stutter, ///< the run has ended; its last state is read again
  Tick,    ///< at least 1 time unit has passed since the last tick; see MonitorZones
  Rest,    ///< from here on no step is taken
};

struct WatchMove {
  MoveKind kind = MoveKind::Start;
  TransitionId transition = kNone;
  std::uint32_t edge = kNone; ///< of the monitor's current location; kNone: the monitor stays
  std::uint32_t choice = 0;   ///< which values of the open variables the step was fired with
};

/// A state of the model and the monitor's location, with a zone over the clocks of both.
struct WatchNode {
  StateId state = 0;
  ZoneId zone = 0;
  std::uint32_t location = 0;
  bool instant = false; ///< no time passes: the monitor must move on
  bool rests = false;   ///< the model takes no more step
  NodeIndex parent = kNone;
  WatchMove move;
  NodeIndex next = kNone; ///< in the list of the nodes that may cover each other
};

struct WatchArc {
  NodeIndex target = 0;
  WatchMove move;
};

/// Conditions for the cycle of a fair run.
struct FairNeeds {
  bool ticks = false; ///< time must diverge
  const std::vector<OpenWait>& waits;
  std::function<bool(NodeIndex, std::size_t)> isWaiting; ///< in a node, by index in `waits`
};

/// The part of the product graph that a monitor search has found, and its runs.
class MonitorGraph {
public:
  /// \param keepArcs whether cycles are searched for
  /// \param with takes steps as the search does; must outlive this
  MonitorGraph(const Monitor& of, bool keepArcs, const Walker& with)
      : monitor(of), cycles(keepArcs), walker(with) {}

  [[nodiscard]] std::size_t size() const { return nodes.size(); }
  [[nodiscard]] const WatchNode& at(NodeIndex node) const { return nodes[node]; }
  [[nodiscard]] std::uint64_t bytes() const;
  /// Bytes that the next few steps may allocate at once, because a table is nearly full.
  [[nodiscard]] std::uint64_t growth() const { return growthOf(nodes) + growthOf(arcs); }

  void addNode(const WatchNode& node);
  /// Only if cycles are searched for.
  void addArc(NodeIndex from, NodeIndex to, WatchMove move);

  /// The run from the initial node to a node in an error location.
  [[nodiscard]] Evidence evidenceTo(NodeIndex node) const;
  /// A run that reaches a cycle through an accepting location and repeats it; nothing if there is
  /// none. The cycle visits every node and every arc of a strongly connected component.
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
  /// \param loop number of moves before the part that repeats
  [[nodiscard]] Evidence evidenceOf(const Way& way, std::optional<std::size_t> loop) const;

  const Monitor& monitor;
  bool cycles;
  const Walker& walker;
  LargeVector<WatchNode> nodes;
  std::vector<std::vector<WatchArc>> arcs; ///< by node
  std::uint64_t arcCount = 0;
};

} // namespace proskill::verify
