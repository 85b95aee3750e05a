#include "fiacre/check/check_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace proskill::fiacre {
namespace {

/// Constants, constructors and functions share one namespace.
void checkValueNames(const Program& program, const Report& report) {
  Names values(report);
  for (const auto& constant : program.constants) values.add(constant.name, "the constant");
  for (const auto& type : program.types)
    if (type.type.kind == TypeKind::Union)
      for (const auto& member : type.type.members) values.add(member.name, "the constructor");
  for (const auto& external : program.externs) values.add(external.name, "the extern");
  for (const auto& function : program.functions) values.add(function.name, "the function");
}

void checkOtherNames(const Program& program, const Report& report) {
  Names types(report);
  for (const auto& type : program.types) types.add(type.name, "the type");
  Names actions(report);
  for (const auto& event : program.eventPorts) actions.add(event.port.name, "the event port");
  for (const auto& task : program.tasks) actions.add(task.name, "the task");
  Names processes(report);
  for (const auto& process : program.processes) processes.add(process.name, "the process");
  for (const auto& component : program.components) processes.add(component.name, "the component");
  Names properties(report);
  for (const auto& property : program.properties) properties.add(property.name, "the property");
}

/// Whether a type refers to the type `name`, directly or not.
bool uses(const Type& type, std::string_view name, const Declarations& known,
          std::set<std::string_view>& seen) {
  const auto within = [&](const Type& inner) { return uses(inner, name, known, seen); };
  if (type.kind == TypeKind::Named) {
    if (type.name == name) return true;
    const auto* declaration = lookUp(known.types, type.name);
    return declaration && seen.insert(type.name).second && within((*declaration)->type);
  }
  return std::ranges::any_of(type.element, within) ||
         std::ranges::any_of(type.members,
                             [&](const Member& m) { return std::ranges::any_of(m.type, within); });
}

void checkTypeDeclaration(const TypeDeclaration& declaration, const Declarations& known,
                          const Report& report) {
  checkType(declaration.type, known, report);
  std::set<std::string_view> seen;
  if (uses(declaration.type, declaration.name, known, seen)) report("the type contains itself");
}

void checkFunctionTypes(const std::vector<Type>& parameters, const Type& result,
                        const Declarations& known, const Report& report) {
  for (const auto& type : parameters) checkType(type, known, report);
  checkType(result, known, report);
}

} // namespace

void checkDeclarations(const Program& program, const Declarations& known, const Report& report) {
  checkValueNames(program, report);
  checkOtherNames(program, report);
  const Scope nothing;
  for (const auto& constant : program.constants) {
    const auto here = report.at("const " + constant.name);
    checkType(constant.type, known, here);
    Typing(known, nothing, here).expect(constant.value, constant.type);
  }
  for (const auto& type : program.types)
    checkTypeDeclaration(type, known, report.at("type " + type.name));
  for (const auto& event : program.eventPorts)
    checkFunctionTypes(event.port.values, {}, known, report.at("event " + event.port.name));
  for (const auto& task : program.tasks)
    checkFunctionTypes(task.parameters, task.result, known, report.at("task " + task.name));
  for (const auto& external : program.externs)
    checkFunctionTypes(external.parameters, external.result, known,
                       report.at("extern " + external.name));
}

void checkInterval(const Interval& interval, const Report& report) {
  if (interval.lower < 0) report("a time must not be negative");
  if (!interval.upper) return;
  const bool point =
      interval.lower == *interval.upper && !interval.lowerOpen && !interval.upperOpen;
  if (!point && interval.lower >= *interval.upper) report("empty interval");
}

Scope scopeOf(const std::vector<Parameter>& parameters, const std::vector<Variable>& variables) {
  Scope scope;
  for (const auto& parameter : parameters)
    scope.emplace(parameter.name, Symbol{parameter.type, parameter.reference});
  for (const auto& variable : variables) scope.emplace(variable.name, Symbol{variable.type, true});
  return scope;
}

void checkVariables(const std::vector<Parameter>& parameters,
                    const std::vector<Variable>& variables, const Declarations& known,
                    const Report& report) {
  Names names(report);
  const auto checkOne = [&](const std::string& name, const Type& type, std::string_view what) {
    names.add(name, what);
    checkType(type, known, report);
    if (lookUp(known.constants, name) || lookUp(known.constructors, name))
      report(fmt::format("{} `{}` hides a constant or a constructor", what, name));
  };
  for (const auto& parameter : parameters)
    checkOne(parameter.name, parameter.type, "the parameter");
  const auto scope = scopeOf(parameters, {});
  for (const auto& variable : variables) {
    checkOne(variable.name, variable.type, "the variable");
    if (variable.init) Typing(known, scope, report).expect(*variable.init, variable.type);
  }
}

void checkPorts(const std::vector<Port>& ports, const Declarations& known, const Report& report) {
  Names names(report);
  for (const auto& port : ports) {
    names.add(port.name, "the port");
    if (lookUp(known.eventPorts, port.name))
      report(fmt::format("the port `{}` hides an event port", port.name));
    for (const auto& type : port.values) checkType(type, known, report);
    if (port.interval) checkInterval(*port.interval, report);
  }
}

} // namespace proskill::fiacre
