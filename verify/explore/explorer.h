#pragma once

#include "verify/explore/walker.h"
#include "verify/explore/zone_cover.h"
#include "verify/guide/frontier.h"
#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/reduce/reductions.h"
#include "verify/state/enabled.h"
#include "verify/verify.h"

#include <functional>
#include <unordered_map>

namespace proskill::verify {

/// The results of an exploration.
struct Explored {
  std::vector<std::optional<Steps>> goals; ///< by goal: the steps that reach it
  Exploration statistics;
  bool paused = false;
  std::string failure; ///< an error of the model, such as a value out of range
  fiacre::OriginId failureOrigin = 0;
};

/// Receives the index of a goal and the steps that reach it.
using OnFound = std::function<void(std::size_t, const Steps&)>;

using NodeIndex = std::uint32_t;

/// A moment at which an exploration that turns out to be long asks whether to go on.
struct Pause {
  NodeIndex after = kNone;      ///< number of classes found
  std::function<bool()> goesOn; ///< called once
};

/// A discrete state with a zone, and how it was reached.
struct ZoneNode {
  StateId state = 0;
  ZoneId zone = 0;
  NodeIndex parent = kNone;
  TransitionId transition = kNone;
  std::uint32_t choice = 0; ///< which values of the open variables were used, from the parent
  NodeIndex next = kNone;   ///< next node in the list of the state's nodes
  bool covered = false;     ///< a later zone includes this one, so it is not expanded
};

/// The explored part of the zone graph.
struct ZoneGraph {
  Enabling enabling;
  Timing timing;
  StateStore states;
  std::vector<SignatureId> signatureOf; ///< by state
  std::vector<NodeIndex> headOf;        ///< by state: the first node of its list
  std::vector<std::uint32_t> coverOf;   ///< by state: index in `covers`, for states with many nodes
  std::vector<ZoneCover> covers;
  std::uint64_t coverBytes = 0;
  std::vector<ZoneNode> nodes;

  ZoneGraph(const System& system, const Reductions& reductions, Extrapolation extrapolation)
      : enabling(system, reductions.dropped),
        timing(system, extrapolation),
        states(system.storedWords) {}
  [[nodiscard]] std::uint64_t bytes() const;
  /// Bytes that the next few steps may allocate at once, because a table is nearly full.
  [[nodiscard]] std::uint64_t growth() const;
};

/// Search of the zone graph: breadth-first, or led by the distance to a goal.
class Explorer {
public:
  /// \pre the arguments outlive this
  /// \param onFound called for each goal as soon as it is reached
  /// \param distance leads the search, if it is not null
  Explorer(const System& system, const std::vector<Goal>& goals, const Reductions& reductions,
           Extrapolation extrapolation, LimitWatch& limits, OnFound onFound = {}, Pause pause = {},
           GoalDistance* distance = nullptr);

  /// Call this once.
  Explored run();
  [[nodiscard]] const ZoneGraph& explored() const { return graph; }
  [[nodiscard]] ZoneGraph& explored() { return graph; }
  /// The transitions from the initial state to a node, including the steps fired alone.
  [[nodiscard]] Steps pathTo(NodeIndex index) const;

private:
  /// A state that is about to be stored.
  struct Current {
    std::vector<Word> state;
    TransitionSet enabled;
    SignatureId signature = 0;
    ZoneId zone = 0;
  };

  void explore();
  void start();
  void load(NodeIndex index);
  void expand(NodeIndex index);
  void expandOpen(NodeIndex index);
  void step(NodeIndex parent, TransitionId transition);
  void stepWith(NodeIndex parent, TransitionId transition, const std::vector<Word>& state,
                std::uint32_t choice);
  void follow(NodeIndex parent, TransitionId transition, std::uint32_t choice);
  bool advance(Current& current, TransitionId transition);
  void chooseInputs(Current& current, TransitionId transition);
  void runAlone(Current& current);
  void add(Current& current, NodeIndex parent, TransitionId transition, std::uint32_t choice);
  bool isCovered(StateId state, ZoneId zone);
  void strike(StateId state, ZoneId zone);
  void noticeStep(const Current& after);
  void noticeState(const Current& current);
  void noticeDeadlock();
  void noticeError();
  [[nodiscard]] bool fails(const TransitionSet& enabled) const;
  void found(std::size_t goal);
  [[nodiscard]] bool allDecided() const { return open == 0 && !goals.empty(); }
  [[nodiscard]] Progress progress() const;
  [[nodiscard]] Walk walkFrom(StateId state) const;
  void walkCalm(Walk& walk) const;
  [[nodiscard]] const Steps& legTo(NodeIndex index) const;

  const System& system;
  const std::vector<Goal>& goals;
  const Reductions& reductions;
  LimitWatch& limits;
  OnFound onFound;
  Pause pause;
  ZoneGraph graph;
  Walker walker;
  Explored result;
  Frontier frontier;

  bool hasErrors = false; ///< some transition is an error
  std::size_t open = 0;   ///< number of undecided goals
  std::vector<std::vector<std::size_t>> goalsOfEvent;
  std::vector<std::size_t> stateGoals; ///< goals that are conditions on states
  std::vector<std::size_t> stepGoals;  ///< goals that also read steps

  NodeIndex expanding = kNone;
  StateId loadedState = kNone;
  Current loaded;           ///< the node that is being expanded
  Current work;             ///< its successor
  std::vector<Word> before; ///< the state before the last step
  std::vector<Word> trial;  ///< a state with other values of open variables
  Steps passed;             ///< from the node being expanded to `work`
  StepLog log;
  mutable std::unordered_map<NodeIndex, Steps> legs; ///< the last steps to a node, from its parent
};

} // namespace proskill::verify
