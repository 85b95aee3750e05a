#pragma once

#include "verify/compile/expressions.h"
#include "verify/model/system.h"

namespace proskill::verify {

/// The value of a node in the initial state.
/// \throw CompileError if evaluation causes a fault
[[nodiscard]] std::int64_t firstValue(const System& system, NodeId node);

/// Executes the `init` statement of a component or a process and stores the results as the cells'
/// initial values.
class InitRunner {
public:
  InitRunner(Expressions& expressions, const Scope& scope, System& system)
      : expressions(expressions), scope(scope), system(system) {}

  /// \param process its `to` sets the initial location; null for a component
  /// \throw CompileError if a value is out of range or a loop does not terminate
  void run(const fiacre::Statement& init, const fiacre::Process* process, InstanceId instance);

private:
  void step(const fiacre::Statement& statement);
  void enter(const fiacre::Statement& statement);
  void assign(const fiacre::Statement& statement);
  void set(const std::vector<Assignment>& assignments);
  void chooseArm(const fiacre::Statement& statement);
  void chooseCase(const fiacre::Statement& statement);
  void repeat(const fiacre::Statement& statement);
  void forEachValue(const fiacre::Statement& statement);

  Expressions& expressions;
  const Scope& scope;
  System& system;
  const fiacre::Process* process = nullptr;
  InstanceId instance = 0;
};

} // namespace proskill::verify
