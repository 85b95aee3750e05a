#pragma once

#include "verify/compile/compile.h"
#include "verify/export/discrete_time.h"
#include "verify/export/faults.h"
#include "verify/export/promela_names.h"

namespace proskill::verify {

/// A question that Spin can answer: an assertion that fails if the goal is reached.
struct PromelaAssertion {
  std::string name;
  std::string question; ///< the name of the property
  const Goal* goal = nullptr;
  NodeId condition = 0; ///< of the goal, without faults
  Bits reads;           ///< cells that the condition reads
};

/// A compiled model, and what its text in Promela needs to know.
class PromelaModel {
public:
  /// \pre the argument outlives this \param propertyNames by goal
  PromelaModel(Compiled& compiled, const std::vector<std::string>& propertyNames);

  System& system;
  Nodes nodes;
  Faults faults;
  PromelaNames names;
  DiscreteTime time;
  bool timed;
  bool mayFail; ///< a step may end the run with an error
  std::vector<PromelaAssertion> assertions;
  Bits events;                  ///< that some assertion reads
  Bits eventsOfSteps;           ///< those that conditions over steps read, after every step
  Bits before;                  ///< cells whose value before a step some assertion reads
  Bits kept;                    ///< these, and those that a part of a step reads so
  std::set<TransitionId> named; ///< transitions whose enabledness is read by others
  std::size_t temporaries = 0;  ///< most values that one assignment computes before it writes them

  [[nodiscard]] bool isOfSteps(const PromelaAssertion& it) const {
    return it.goal->kind == GoalKind::Condition && it.goal->ofSteps;
  }

private:
  void addAssertion(const Goal& goal, const std::string& name);
  void findNamed();
  void findCopies();
};

/// The cells of which a part of the transition reads the value before the step, although another
/// part may have written it.
[[nodiscard]] Bits oldCells(const System& system, const Transition& transition, PathId part);

/// Whether simultaneous assignments have to compute all values first.
[[nodiscard]] bool needTemporaries(const System& system, const Path& path,
                                   const Instruction& instruction);

} // namespace proskill::verify
