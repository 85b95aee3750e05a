#pragma once

#include "analysis/flow/engine/interference.h"
#include "analysis/flow/engine/system.h"
#include "analysis/flow/engine/worklist.h"

#include <set>
#include <utility>
#include <vector>

namespace proskill::analysis::flow {

/// What may be true at each point of a program: the least solution of the equations between the
/// states of all nodes, the exits of what they call, and who interferes.
///
/// Sound for the model of docs/semantics.md with time left out: a step may be delayed or hurried at
/// will, and anybody who may run beside may act between two steps, at the same instant too. What is
/// known from a test is therefore closed under interference before the next step; within a step (a
/// precondition and the start effects, a wait and its effects) it is exact.
class Solver {
public:
  explicit Solver(const System& system);

  [[nodiscard]] const System& system() const { return model; }
  /// When the process has come to the node, before it does what the node says.
  [[nodiscard]] const std::vector<State>& cases(ProcessId process, NodeId node) const {
    return states[process][node].all();
  }
  /// The same in one box.
  [[nodiscard]] State before(ProcessId process, NodeId node) const {
    return states[process][node].hull();
  }
  [[nodiscard]] bool reachable(ProcessId process, NodeId node) const {
    return states[process][node].reachable();
  }
  [[nodiscard]] bool mayHold(ProcessId process, NodeId node, const Condition& condition) const;
  [[nodiscard]] bool mayFail(ProcessId process, NodeId node, const Condition& condition) const;
  /// All that a variable may ever be.
  [[nodiscard]] ValueSet ever(VariableId variable) const { return everything[variable]; }
  /// The values that one step of anybody may change it to.
  [[nodiscard]] ValueSet mayMove(VariableId variable, unsigned from) const {
    return byAnyone[variable]->from(from);
  }
  /// It is called, or starts with the program.
  [[nodiscard]] bool started(ProcessId process) const {
    return !states[process].empty() && states[process].front().reachable();
  }
  /// `(x.interrupt)` or the world outside may interrupt it while its caller goes on.
  [[nodiscard]] bool mayBeInterrupted(ProcessId process) const { return interrupted[process]; }
  /// Its caller may stop it because it is stopped itself.
  [[nodiscard]] bool mayBeStopped(ProcessId process) const { return stopped[process]; }
  /// What the callee of a call may find, over its own slots.
  [[nodiscard]] std::vector<State> atCallee(ProcessId caller, NodeId call) const;
  /// While the node waits for what it has called, if it has.
  [[nodiscard]] State during(ProcessId process, NodeId node) const;
  /// After the effects of a node that the text states: where a postcondition is tested.
  [[nodiscard]] State afterEffects(State before, const Process& process, NodeId node) const;
  /// After all that the node sets, in the same step.
  [[nodiscard]] State after(State before, const Process& process, NodeId node) const;

private:
  /// The moves that close a state.
  struct Closing {
    std::vector<const Relation*> relations; ///< by slot
    std::vector<Slot> moving;               ///< those whose relation is not empty
    std::vector<Slot> stale;                ///< outcomes that may be older: from none at all on
  };
  /// The same for what a node calls, of the few slots that this may change.
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
  /// \return the edge can be taken
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
  /// All that the variable may be, as far as is known.
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
  std::vector<Cases> stoppedEnds;                 ///< of each skill, when its caller was stopped
  std::vector<Closing> rely;                      ///< of each process
  std::vector<Closing> relyInside;                ///< of each skill while it is running
  std::vector<std::vector<Changes>> whileCalling; ///< of each node that calls or forks
  std::vector<std::set<NodeId>> pending;          ///< nodes to step
  std::vector<std::set<Slot>> grown;              ///< slots that are to be closed again
  std::vector<bool> interrupted;
  std::vector<bool> stopped;
  Worklist queue;
  std::size_t mostCases = 0;
  std::vector<ValueSet> everything;
  std::vector<const Relation*> byAnyone; ///< of each variable
};

} // namespace proskill::analysis::flow
