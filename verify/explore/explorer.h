#pragma once

#include "verify/explore/walker.h"
#include "verify/explore/zone_cover.h"
#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/reduce/reductions.h"
#include "verify/state/enabled.h"
#include "verify/verify.h"

#include <functional>
#include <unordered_map>

namespace proskill::verify {

/// What an exploration found, and how far it went.
struct Explored {
  std::vector<std::optional<Steps>> goals; ///< by goal: a way to what it asks for
  Exploration statistics;
  std::string failure; ///< an error of the model: a value out of range
  fiacre::OriginId failureOrigin = 0;
};

/// Gets a goal, by its place, and the way to what it asks for.
using OnFound = std::function<void(std::size_t, const Steps&)>;

using NodeIndex = std::uint32_t;

/// A discrete state with a zone, and how it was reached.
struct ZoneNode {
  StateId state = 0;
  ZoneId zone = 0;
  NodeIndex parent = kNone;
  TransitionId transition = kNone;
  std::uint32_t choice = 0; ///< of the values of open variables, from the parent
  NodeIndex next = kNone;   ///< in the list of the state's nodes
  bool covered = false;     ///< within a later zone: not expanded any more
};

/// What was explored so far.
struct ZoneGraph {
  Enabling enabling;
  Timing timing;
  StateStore states;
  std::vector<SignatureId> signatureOf; ///< by state
  std::vector<NodeIndex> headOf;        ///< by state: the first of its nodes
  std::vector<std::uint32_t> coverOf;   ///< by state: in `covers`, where it has many nodes
  std::vector<ZoneCover> covers;
  std::uint64_t coverBytes = 0;
  std::vector<ZoneNode> nodes;

  ZoneGraph(const System& system, const Reductions& reductions, Extrapolation extrapolation)
      : enabling(system, reductions.dropped),
        timing(system, extrapolation),
        states(system.storedWords) {}
  [[nodiscard]] std::uint64_t bytes() const;
  /// What the next few steps may add at once, since a table is nearly full.
  [[nodiscard]] std::uint64_t growth() const;
};

/// Breadth-first search of the zone graph.
class Explorer {
public:
  /// \pre the arguments outlive this
  /// \param onFound called with each goal as soon as a way to what it asks for is found
  Explorer(const System& system, const std::vector<Goal>& goals, const Reductions& reductions,
           Extrapolation extrapolation, LimitWatch& limits, OnFound onFound = {});

  /// To be called once.
  Explored run();
  [[nodiscard]] const ZoneGraph& explored() const { return graph; }
  [[nodiscard]] ZoneGraph& explored() { return graph; }
  /// The transitions from the initial state to a node, safe steps included.
  [[nodiscard]] Steps pathTo(NodeIndex index) const;

private:
  /// A state on its way into the store.
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
  ZoneGraph graph;
  Walker walker;
  Explored result;
  NodeIndex next = 0; ///< to be expanded

  bool hasErrors = false; ///< some transition is an error
  std::size_t open = 0;   ///< goals that are not decided
  std::vector<std::vector<std::size_t>> goalsOfEvent;
  std::vector<std::size_t> stateGoals; ///< conditions on states
  std::vector<std::size_t> stepGoals;  ///< those that watch steps, too

  NodeIndex expanding = kNone;
  StateId loadedState = kNone;
  Current loaded;           ///< the node that is expanded
  Current work;             ///< its successor
  std::vector<Word> before; ///< the state before the last step
  std::vector<Word> trial;  ///< a state with other values of open variables
  Steps passed;             ///< from the node that is expanded to `work`
  StepLog log;
  mutable std::unordered_map<NodeIndex, Steps> legs; ///< the last steps to nodes, from the parent
};

} // namespace proskill::verify
