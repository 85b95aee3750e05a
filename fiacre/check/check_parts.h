#pragma once

#include "fiacre/check/declarations.h"
#include "fiacre/check/typing.h"

#include <map>
#include <set>
#include <vector>

/// Internals of the checker, shared by its files.
namespace proskill::fiacre {

void checkDeclarations(const Program& program, const Declarations& known, const Report& report);
void checkFunction(const Function& function, const Declarations& known, const Report& report);
void checkProcess(const Process& process, const Declarations& known, const Report& report);
void checkComponent(const Component& component, const Declarations& known, const Report& report);
/// Checks the main component and its observers, and that no component contains itself.
void checkStructure(const Program& program, const Declarations& known, const Report& report);
/// Checks what the probe of a component's port observes.
void checkProbe(const Port& port, const Program& program, const Declarations& known,
                const Report& report);
void checkProperty(const Property& property, const Program& program, const Declarations& known,
                   const Report& report);

void checkInterval(const Interval& interval, const Report& report);
/// The variables and parameters with their types.
Scope scopeOf(const std::vector<Parameter>& parameters, const std::vector<Variable>& variables);
/// Checks their names, types and initial values.
void checkVariables(const std::vector<Parameter>& parameters,
                    const std::vector<Variable>& variables, const Declarations& known,
                    const Report& report);
void checkPorts(const std::vector<Port>& ports, const Declarations& known, const Report& report);

/// The names visible to the statements of one process, component or function.
struct CheckContext {
  const Declarations& known;
  Scope scope;
  std::map<std::string_view, const Port*> ports;
  std::set<std::string_view> states;
  const Type* result = nullptr; ///< of the enclosing function
};
/// Checks names and types in a statement and its parts.
void checkNames(const Statement& statement, const CheckContext& around, const Report& report);
/// Checks each path through a `from`: its end, its wait, its communication.
void checkPaths(const Statement& statement, const Report& report);
/// Checks that the statement only sets variables, as `init` must; it may also set the state.
void checkInit(const Statement& statement, const Report& report);
/// Checks that each path through a function's body returns and only computes.
void checkReturns(const Statement& body, const Report& report);

} // namespace proskill::fiacre
