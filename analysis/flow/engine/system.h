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

/// What the transitions of a node do, over the slots of its process.
struct Action {
  std::vector<Condition> conditions;
  std::vector<Assignment> assignments;
  ProcessId target = kNoProcess;   ///< Call: what is called; Interrupt: what is interrupted
  std::vector<ProcessId> branches; ///< Fork
  ProcessId leaver = kNoProcess;   ///< Outcome that a branch chose: the branch
  NodeId leave = kNoNode;          ///< … and its node there
};

/// A thread of the model: it does one step at a time, in between of those of others.
struct Process {
  ProcessKind kind = ProcessKind::Skill;
  std::size_t definition = 0; ///< in the program's table: the skill (of a branch too), environment
  const Graph* graph = nullptr;  ///< null for the events: each is a step at any time
  ProcessId parent = kNoProcess; ///< of a branch: where it was forked
  bool root = false;             ///< starts with the program
  bool repeats = false;          ///< called again and again by whoever uses the library
  bool analysed = false;         ///< some root starts it, directly or not
  Slots slots;
  std::vector<Action> actions; ///< one a node, or an event
};

/// Who calls whom, and where.
struct Site {
  ProcessId caller = kNoProcess;
  NodeId node = kNoNode;
};

/// A program as processes that share variables: what the analysis runs on. Looks into the program.
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
  /// The process of all events: they come one after the other, in any order.
  [[nodiscard]] ProcessId ofEvents() const { return eventProcess; }
  /// The calls of a skill's process.
  [[nodiscard]] const std::vector<Site>& callers(ProcessId id) const { return sites[id]; }
  /// A process, its branches, all that these call, and so on.
  [[nodiscard]] const IdSet& activity(ProcessId id) const { return activities[id]; }
  /// What calls comes after what it calls.
  [[nodiscard]] std::size_t rank(ProcessId id) const { return calls->rank(id); }
  /// The variables that these set.
  [[nodiscard]] const IdSet& writes(ProcessId id) const { return written[id]; }
  [[nodiscard]] const IdSet& everybody() const { return allProcesses; }
  /// Those that may act between two steps of a process and are not called by it.
  [[nodiscard]] const IdSet& concurrent(ProcessId id) const { return others[id]; }
  /// The variable is the status or result of a skill that the body calls, and another one, too, and
  /// the thread may read it before it calls the skill: what it reads is the outcome of the body's
  /// own last call, which lies before this run, whatever others have called since.
  [[nodiscard]] bool mayReadStale(ProcessId reader, VariableId variable) const;
  /// The variable is the status or result of a skill that the body calls, and that something called
  /// by the body calls, too: the body reads the outcome of its own last call, and its guards that
  /// of the last call of all. One set of values cannot stand for both, so the process does not
  /// follow the variable.
  [[nodiscard]] bool hasTwoMeanings(ProcessId reader, VariableId variable) const;
  /// Skills that cannot be running while this one is; itself, where it is never called while it is.
  [[nodiscard]] const IdSet& exclusive(ProcessId id) const { return excluded[id]; }
  /// Interrupts from outside happen at any time, and so do all events: no environment restricts
  /// them.
  [[nodiscard]] bool hasFreeInterrupts() const { return source.environments.all.empty(); }
  /// An event happens by itself: nothing says when, or its `:every` does.
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
  ProcessId eventProcess = 0;        ///< the last
  std::vector<ProcessId> candidates; ///< each may be the main skill, one is
  std::vector<std::vector<Site>> sites;
  std::optional<CallOrder> calls;
  std::vector<IdSet> activities;
  std::vector<IdSet> written;
  IdSet allProcesses;
  std::vector<IdSet> others;
  std::vector<IdSet> excluded;
};

} // namespace proskill::analysis::flow
