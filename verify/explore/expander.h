#pragma once

#include "verify/explore/walker.h"
#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/space/zone_graph.h"
#include "verify/state/constant_steps.h"

namespace proskill::verify {

/// A state and zone that a step leads to, with the steps that are fired alone after it.
struct Successor {
  std::size_t state = 0; ///< index of its first word in Expansion::words
  std::size_t steps = 0; ///< index of the first step to it in Expansion::steps
  std::size_t stepsEnd = 0;
  SignatureId signature = 0;
  ZoneId zone = 0;
  TransitionId transition = kNone;
  std::uint32_t choice = 0;         ///< which values of the open variables the step was fired with
  StateId known = kNone;            ///< the number of the state, if the graph has it already
  RootTable::ClaimId claim = kNone; ///< otherwise, if the state is claimed
};

/// Claims states for the successors of a node.
struct Claimer {
  RootTable& table;
  RootTable::Allotment own;
  NodeIndex node = 0; ///< that is expanded
};

/// A goal that was reached, and the steps to it from the node that was expanded.
struct Notice {
  std::size_t goal = 0;
  Steps steps;
};

/// All that is possible from a node.
struct Expansion {
  std::vector<Successor> successors;
  std::vector<Word> words; ///< of the successors, as they are stored
  bool keepsSteps = false; ///< whether all steps to the successors are kept
  Steps steps;
  std::vector<Notice> notices;
  std::uint64_t transitions = 0; ///< number of steps from the node
  std::string failure;           ///< an error of the model
  fiacre::OriginId failureOrigin = 0;

  void clear();
};

/// Which goals an exploration still has to reach.
struct OpenGoals {
  const std::vector<Goal>& goals;
  std::vector<bool> found; ///< by goal
  std::size_t closed = 0;  ///< how many are found
};

/// Computes what is possible from a node of a graph. Expanders with zones of their own may work at
/// once, while nothing is added to the graph.
class Expander {
public:
  /// \pre the arguments outlive this
  /// \param timing its zones are those of the results; it may be that of the graph
  Expander(const System& system, const OpenGoals& goals, const Reductions& reductions,
           const ZoneGraph& graph, Timing& timing, LimitWatch& limits);

  /// The initial node, as the only successor.
  void start(Expansion& to);
  /// Loads the node to expand.
  /// \param stored the state as it is stored \param signature and \param zone of the own timing
  void load(const Word* stored, SignatureId signature, ZoneId zone);
  /// Call this when signatures and zones have got other numbers.
  void forgetLoaded() { loaded.state.clear(); }
  [[nodiscard]] const Word* loadedState() const { return loaded.state.data(); }
  /// Computes all successors, or only those by one step. \throw LimitMet
  void expand(Expansion& to, TransitionId only = kNone);
  /// Removes the successors that the graph covers; these will be covered for ever. Sets dead
  /// variables of the others to one value. A state that the graph has needs no look at its
  /// variables, since they have been set before.
  /// \param claimer if not null, claims the states that the graph lacks. Without time, this also
  /// removes successors whose states a node before this one has claimed.
  /// \param near the nodes of the state of the node that was expanded
  void reduce(Expansion& to, const StateTree::Path& near, Claimer* claimer = nullptr);

private:
  /// A state on the way to a successor.
  struct Current {
    std::vector<Word> state;
    TransitionSet enabled;
    SignatureId signature = 0;
    ZoneId zone = 0;
  };

  void expandOpen();
  void step(TransitionId transition);
  void beginStep();
  void stepWith(TransitionId transition, const std::vector<Word>& state, std::uint32_t choice);
  void follow(TransitionId transition, std::uint32_t choice);
  bool advance(TransitionId transition);
  [[nodiscard]] Outcome fire(TransitionId transition);
  [[nodiscard]] bool enter(TransitionId transition, Steps& back);
  void chooseInputs(TransitionId transition);
  void runAlone();
  void add(TransitionId transition, std::uint32_t choice);
  void noticeStep();
  void noticeState();
  void noticeDeadlock();
  void noticeError();
  void notice(std::size_t goal);
  void forgetClosedGoals();
  [[nodiscard]] bool isOpen(std::size_t goal) const {
    return !goals.found[goal] && !noticed.contains(static_cast<std::uint32_t>(goal));
  }
  [[nodiscard]] bool isTaken(TransitionId transition) const {
    return made->failure.empty() && (onlyStep == kNone || onlyStep == transition);
  }
  [[nodiscard]] bool fails(const TransitionSet& enabled) const;
  void prefetchStates(const Expansion& of, const StateTree::Path& near);
  bool lookUp(Successor& successor, const SoughtRoot& root, Claimer* claimer) const;
  [[nodiscard]] bool isCovered(const Successor& successor) const;

  const System& system;
  const OpenGoals& goals;
  const Reductions& reductions;
  const ZoneGraph& graph;
  const Enabling& enabling;
  Timing& timing;
  LimitWatch& limits;
  Walker walker;
  ConstantSteps constantSteps;
  /// Whether time or a reduction depends on what is possible in a successor. Otherwise all states
  /// have one signature and one zone.
  bool looksAhead = true;

  bool hasErrors = false; ///< some transition is an error
  std::vector<std::vector<std::size_t>> goalsOfEvent;
  std::vector<std::size_t> stateGoals; ///< goals that are conditions on states
  std::vector<std::size_t> stepGoals;  ///< goals that also read steps
  std::size_t forgotten = 0;           ///< number of closed goals that these lists lack

  Expansion* made = nullptr;
  TransitionId onlyStep = kNone; ///< the only one to take, if any
  StateTree::Path path;          ///< the last state that was looked for alone
  StateTree::Group group;        ///< the successors
  Bits noticed;                  ///< goals, while a node is expanded
  Current loaded;                ///< the node that is being expanded
  Current work;                  ///< its successor
  std::vector<Word> before;      ///< the state before the last step
  std::vector<Word> trial;       ///< a state with other values of open variables
  Steps passed;                  ///< from the node being expanded to `work`
  StepLog log;
};

} // namespace proskill::verify
