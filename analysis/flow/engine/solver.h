#pragma once

#include "analysis/flow/domain/satisfy.h"
#include "analysis/flow/engine/interference.h"
#include "analysis/flow/engine/system.h"
#include "analysis/flow/engine/worklist.h"

#include <set>
#include <utility>
#include <vector>

namespace proskill::analysis::flow {

/// Computes what may be true at each point of a program: the least solution of the equations
/// between the states of all nodes, the exits of callees, and interference by other processes.
///
/// Sound for the model of docs/semantics.md without time: a step may be delayed or hurried
/// arbitrarily, and any concurrent process may act between two steps, also at the same instant. So
/// knowledge from a test is closed under interference before the next step. Within a step (a
/// precondition and the start effects, a wait and its effects) it is exact.
class Solver {
public:
  explicit Solver(const System& system);

  [[nodiscard]] const System& system() const { return model; }
  /// The cases in which the process reaches the node, before the node's action.
  [[nodiscard]] const std::vector<State>& cases(ProcessId process, NodeId node) const {
    return states[process][node].all();
  }
  /// The same as one box.
  [[nodiscard]] State before(ProcessId process, NodeId node) const {
    return states[process][node].hull();
  }
  [[nodiscard]] bool reachable(ProcessId process, NodeId node) const {
    return states[process][node].reachable();
  }
  [[nodiscard]] bool mayHold(ProcessId process, NodeId node, const Condition& condition) const;
  [[nodiscard]] bool mayFail(ProcessId process, NodeId node, const Condition& condition) const;
  /// All values that a variable may ever have.
  [[nodiscard]] ValueSet ever(VariableId variable) const { return everything[variable]; }
  /// The values to which one step of any process may change it.
  [[nodiscard]] ValueSet mayMove(VariableId variable, unsigned from) const {
    return byAnyone[variable]->from(from);
  }
  /// Whether it is called or starts with the program.
  [[nodiscard]] bool started(ProcessId process) const {
    return !states[process].empty() && states[process].front().reachable();
  }
  /// Whether `(x.interrupt)` or the outside world may interrupt it while its caller continues.
  [[nodiscard]] bool mayBeInterrupted(ProcessId process) const { return interrupted[process]; }
  /// Whether its caller may stop it because the caller itself is stopped.
  [[nodiscard]] bool mayBeStopped(ProcessId process) const { return stopped[process]; }
  /// The states in which the callee of a call may start, over the callee's slots.
  [[nodiscard]] std::vector<State> atCallee(ProcessId caller, NodeId call) const;
  /// The state while the node waits for its callees; meaningful for nodes that call.
  [[nodiscard]] State during(ProcessId process, NodeId node) const;
  /// After the effects of a node in the text; postconditions are tested in this state.
  [[nodiscard]] State afterEffects(State before, const Process& process, NodeId node) const;
  /// After everything that the node sets, in the same step.
  [[nodiscard]] State after(State before, const Process& process, NodeId node) const;

private:
  /// The moves under which a state is closed.
  struct Closing {
    std::vector<const Relation*> relations; ///< by slot
    std::vector<Slot> moving;               ///< slots with a relation that is not empty
    /// Slots of outcomes that may be older: they may also have any earlier value, or none.
    std::vector<Slot> stale;
  };
  /// The same for a node's callees, limited to the few slots that they may change.
  using Changes = std::vector<std::pair<Slot, const Relation*>>;

  void prepare();
  void prepare(ProcessId process);
  void prepareCall(ProcessId process, NodeId node);
  void prepareEvents();
  void startRoots();
  [[nodiscard]] Closing closingOf(ProcessId process, bool inside);
  static void close(State& state, const Closing& closing);
  void grow(const Reader& reader);
  void closeAgain(ProcessId process);
  [[nodiscard]] bool isClosed(ProcessId process, NodeId node) const;
  void wake(ProcessId process, NodeId node);
  void schedule(ProcessId process) { queue.add(model.rank(process), process); }

  void run(ProcessId process);
  void step(ProcessId process, NodeId node);
  void flow(ProcessId process, NodeId node, const Edge& edge);
  /// \return whether the edge can be taken
  bool stop(ProcessId process, NodeId node, const Edge& edge);
  void stopCall(ProcessId process, NodeId node, NodeId exit);
  void call(ProcessId process, NodeId node, NodeId next);
  void fork(ProcessId process, NodeId node, NodeId next);
  void interrupt(ProcessId process, NodeId node);
  void stopCallees(ProcessId process, NodeId node, bool stops);
  void stopBeforeStart(ProcessId process);
  void set(State& state, ProcessId process, VariableKind kind, unsigned to);

  [[nodiscard]] State during(const State& before, ProcessId process, NodeId node) const;
  [[nodiscard]] bool entersCall(const State& before, ProcessId process, NodeId node) const;
  [[nodiscard]] State returned(const State& before, const State& exit, ProcessId process,
                               NodeId node) const;
  [[nodiscard]] State refused(const State& before, ProcessId process, NodeId node) const;
  [[nodiscard]] Cases endedBranch(const Cases& known, ProcessId process, ProcessId branch) const;
  void stopRivals(ProcessId process, NodeId node);
  [[nodiscard]] Cases joined(const State& before, ProcessId process, NodeId node) const;
  [[nodiscard]] bool mayStop(ProcessId process) const;
  [[nodiscard]] bool isUnstoppable(ProcessId process) const;
  [[nodiscard]] State assigned(State before, const Process& process, NodeId node,
                               bool effectsOnly) const;
  [[nodiscard]] bool isPoint(ProcessId process, NodeId node) const;
  [[nodiscard]] const Closing& relyAt(ProcessId process, NodeId node) const;
  void record(const State& before, ProcessId process, const Assignment& assignment);
  void record(const State& before, ProcessId process, NodeId node);
  void arrive(ProcessId process, NodeId node, State state);
  void enter(ProcessId process, State state);
  void announceEnd(ProcessId process);
  void wakeForks(ProcessId skill);
  /// All values that the variable may have, as far as known.
  [[nodiscard]] ValueSet anything(VariableId variable) const {
    return byAnyone[variable]->closure(model.variables()[variable].initial);
  }
  void mark(std::vector<bool>& flags, ProcessId process);
  [[nodiscard]] State project(const State& state, const Process& from, const Process& to) const;
  [[nodiscard]] State entryOf(const State& before, ProcessId caller, NodeId call) const;
  void summarise();

  const System& model;
  Interference moves;
  std::vector<std::vector<Cases>> states;
  std::vector<Cases> stoppedEnds;                 ///< by skill: when its caller was stopped
  std::vector<Closing> rely;                      ///< by process
  std::vector<Closing> relyInside;                ///< by skill: while it is running
  std::vector<std::vector<Changes>> whileCalling; ///< by node that calls or forks
  std::vector<std::set<NodeId>> pending;          ///< nodes to be processed
  std::vector<std::set<Slot>> grown;              ///< slots to be closed again
  std::vector<bool> interrupted;
  std::vector<bool> stopped;
  Worklist queue;
  std::size_t mostCases = 0;
  std::vector<ValueSet> everything;
  std::vector<const Relation*> byAnyone; ///< by variable
};

} // namespace proskill::analysis::flow
