#pragma once

#include "fiacre/check/declarations.h"
#include "fiacre/check/typing.h"

#include <map>
#include <set>
#include <vector>

/// The checker's own pieces, shared by its files.
namespace proskill::fiacre {

void checkDeclarations(const Program& program, const Declarations& known, const Report& report);
void checkFunction(const Function& function, const Declarations& known, const Report& report);
void checkProcess(const Process& process, const Declarations& known, const Report& report);
void checkComponent(const Component& component, const Declarations& known, const Report& report);
/// The main component, its observers, and that no component contains itself.
void checkStructure(const Program& program, const Declarations& known, const Report& report);
/// What a port of a component watches for.
void checkProbe(const Port& port, const Program& program, const Declarations& known,
                const Report& report);
void checkProperty(const Property& property, const Program& program, const Declarations& known,
                   const Report& report);

void checkInterval(const Interval& interval, const Report& report);
/// What variables and parameters are called, and their types.
Scope scopeOf(const std::vector<Parameter>& parameters, const std::vector<Variable>& variables);
/// Their names, types and first values.
void checkVariables(const std::vector<Parameter>& parameters,
                    const std::vector<Variable>& variables, const Declarations& known,
                    const Report& report);
void checkPorts(const std::vector<Port>& ports, const Declarations& known, const Report& report);

/// What the statements of one process, component or function may name.
struct CheckContext {
  const Declarations& known;
  Scope scope;
  std::map<std::string_view, const Port*> ports;
  std::set<std::string_view> states;
  const Type* result = nullptr; ///< of the function that it is
};
/// Names and types in a statement and all within it.
void checkNames(const Statement& statement, const CheckContext& around, const Report& report);
/// Each path through the statements of a `from`: its end, its wait, its communication.
void checkPaths(const Statement& statement, const Report& report);
/// The statement sets variables and nothing else, as `init` must; it may choose the state.
void checkInit(const Statement& statement, const Report& report);
/// Each path through a function's body returns, and does nothing but compute.
void checkReturns(const Statement& body, const Report& report);

} // namespace proskill::fiacre
