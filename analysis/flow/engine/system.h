#pragma once

#include "analysis/flow/domain/resolve.h"
#include "analysis/flow/engine/call_order.h"
#include "analysis/flow/engine/graph.h"

#include <deque>
#include <optional>
#include <vector>

namespace proskill::analysis::flow {

constexpr ProcessId kNoProcess = ~ProcessId{0};

enum class ProcessKind : std::uint8_t { Skill, Branch, Environment, Events };

/// The effects of a node's transitions over the slots of its process.
struct Action {
  std::vector<Condition> conditions;
  std::vector<Assignment> assignments;
  ProcessId target = kNoProcess;   ///< Call: what is called; Interrupt: what is interrupted
  std::vector<ProcessId> branches; ///< Fork
  ProcessId leaver = kNoProcess;   ///< Outcome chosen by a branch: this branch
  NodeId leave = kNoNode;          ///< Outcome chosen by a branch: its node in the branch
};

/// A thread of the model. Its steps interleave with those of other processes.
struct Process {
  ProcessKind kind = ProcessKind::Skill;
  /// Index in the program's table of skills (also for branches) or environments.
  std::size_t definition = 0;
  /// Null for events: each event is a step that may happen at any time.
  const Graph* graph = nullptr;
  ProcessId parent = kNoProcess; ///< of a branch: the process that forks it
  bool root = false;             ///< starts with the program
  bool repeats = false;          ///< a skill of a library, or a monitor that is always armed
  bool analysed = false;         ///< a root starts it, directly or indirectly
  Slots slots;
  std::vector<Action> actions; ///< by node, or by event
};

/// A call: the caller and the place.
struct Site {
  ProcessId caller = kNoProcess;
  NodeId node = kNoNode;
};

/// A program as processes that share variables; the input of the solver. It refers to the program.
class System {
public:
  explicit System(const Program& program);

  [[nodiscard]] const Program& program() const { return source; }
  [[nodiscard]] const Variables& variables() const { return shared; }
  [[nodiscard]] const Resolver& resolver() const { return names; }
  [[nodiscard]] std::size_t size() const { return processes.size(); }
  [[nodiscard]] const Process& operator[](ProcessId id) const { return processes[id]; }
  [[nodiscard]] const std::vector<Process>& all() const { return processes; }
  [[nodiscard]] ProcessId ofSkill(std::size_t skill) const { return skillProcess[skill]; }
  /// The process of all events. They happen one after the other, in any order.
  [[nodiscard]] ProcessId ofEvents() const { return eventProcess; }
  /// The calls of a skill's process.
  [[nodiscard]] const std::vector<Site>& callers(ProcessId id) const { return sites[id]; }
  /// A process, its branches, their callees, and so on.
  [[nodiscard]] const IdSet& activity(ProcessId id) const { return activities[id]; }
  /// Callees come before their callers.
  [[nodiscard]] std::size_t rank(ProcessId id) const { return calls->rank(id); }
  /// The variables that the process's activity sets.
  [[nodiscard]] const IdSet& writes(ProcessId id) const { return written[id]; }
  [[nodiscard]] const IdSet& everybody() const { return allProcesses; }
  /// The processes that may act between two steps of a process, except those that it calls.
  [[nodiscard]] const IdSet& concurrent(ProcessId id) const { return others[id]; }
  /// Whether a thread may read an outcome from before this run. The variable is the status or
  /// result of a skill that the body and another process call, and the thread may read it before it
  /// calls the skill. It then reads the outcome of the body's own last call, whatever others have
  /// called since.
  [[nodiscard]] bool mayReadStale(ProcessId reader, VariableId variable) const;
  /// Whether a variable has two meanings in a process. It is the status or result of a skill that
  /// the body calls and that something called by the body calls too. The body reads the outcome of
  /// its own last call; its guards read the outcome of the last call by anybody. One set of values
  /// cannot represent both, so the process does not track the variable.
  [[nodiscard]] bool hasTwoMeanings(ProcessId reader, VariableId variable) const;
  /// Skills that cannot run while this one runs; includes itself if it is never called while it
  /// runs.
  [[nodiscard]] const IdSet& exclusive(ProcessId id) const { return excluded[id]; }
  /// Whether interrupts from outside and all events may happen at any time: no environment
  /// restricts them.
  [[nodiscard]] bool hasFreeInterrupts() const { return source.environments.all.empty(); }
  /// Whether an event happens by itself: at any time, or as its `:every` says.
  [[nodiscard]] bool isFree(std::size_t event) const {
    return hasFreeInterrupts() || source.events.all[event]->every;
  }
  [[nodiscard]] bool hasFreeEvents() const;

  [[nodiscard]] const syntax::Skill& skill(const Process& process) const {
    return source.skills.all[process.definition].node();
  }
  /// \pre the process has a graph
  [[nodiscard]] Location at(const Process& process, syntax::Range range) const;

private:
  [[nodiscard]] bool readsBeforeCall(const Process& reader, VariableId variable,
                                     ProcessId skill) const;
  void addProcesses();
  void addThreads(const SkillGraph& graph, ProcessKind kind, std::size_t definition);
  void link();
  void linkNode(ProcessId id, NodeId node);
  void chooseRoots();
  void chooseSlots();
  void compile();
  void findActivities();
  void findConcurrency();
  void letRunTogether(const std::vector<ProcessId>& group);
  void letRunBeside(const std::vector<ProcessId>& some, const std::vector<ProcessId>& rest);
  [[nodiscard]] IdSet readsOf(ProcessId id) const;
  [[nodiscard]] std::vector<ProcessId> startedBy(const Process& process) const;

  const Program& source;
  Variables shared;
  Resolver names;
  std::deque<SkillGraph> graphs;
  std::vector<Process> processes;
  std::vector<ProcessId> skillProcess;
  ProcessId eventProcess = 0;        ///< the last process
  std::vector<ProcessId> candidates; ///< one of these is the main skill
  std::vector<std::vector<Site>> sites;
  std::optional<CallOrder> calls;
  std::vector<IdSet> activities;
  std::vector<IdSet> written;
  IdSet allProcesses;
  std::vector<IdSet> others;
  std::vector<IdSet> excluded;
};

} // namespace proskill::analysis::flow
