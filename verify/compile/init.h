#pragma once

#include "verify/compile/expressions.h"
#include "verify/model/system.h"

namespace proskill::verify {

/// The value of a node while all cells have their first values.
/// \throw CompileError where it has none
[[nodiscard]] std::int64_t firstValue(const System& system, NodeId node);

/// Runs the `init` of a component or a process: what it sets are the cells' first values.
class InitRunner {
public:
  InitRunner(Expressions& expressions, const Scope& scope, System& system)
      : expressions(expressions), scope(scope), system(system) {}

  /// \param process whose first state `to` sets; null in a component
  /// \throw CompileError where a value lies outside of its range, or a loop does not end
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
