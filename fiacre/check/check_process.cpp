#include "fiacre/check/check_parts.h"

#include <fmt/format.h>

namespace proskill::fiacre {
namespace {

void addPorts(CheckContext& around, const std::vector<Port>& ports) {
  for (const auto& [name, event] : around.known.eventPorts)
    around.ports.emplace(name, &event->port);
  for (const auto& port : ports) around.ports.emplace(port.name, &port);
}

void checkStates(const Process& process, const Report& report) {
  if (process.states.empty()) report("a process needs a state");
  Names declared(report);
  std::set<std::string_view> states;
  for (const auto& state : process.states) {
    declared.add(state.name, "the state");
    states.insert(state.name);
  }
  std::set<std::string_view> described;
  for (const auto& from : process.transitions) {
    if (!states.contains(from.state))
      report(fmt::format("the state `{}` is not declared", from.state));
    if (!described.insert(from.state).second)
      report.from(from.origin)(
          fmt::format("the state `{}` has two `from`: join them with `select`", from.state));
  }
}

OriginId originOf(const Process& process, std::string_view state) {
  for (const auto& each : process.states)
    if (each.name == state) return each.origin;
  return 0;
}

} // namespace

void checkProcess(const Process& process, const Declarations& known, const Report& report) {
  checkPorts(process.ports, known, report);
  checkVariables(process.parameters, process.variables, known, report);
  checkStates(process, report);

  CheckContext around{.known = known, .scope = scopeOf(process.parameters, process.variables)};
  addPorts(around, process.ports);
  for (const auto& state : process.states) around.states.insert(state.name);
  if (process.init) {
    checkNames(*process.init, around, report);
    checkInit(*process.init, report);
  }
  for (const auto& from : process.transitions) {
    const auto here = report.at(fmt::format("process {}, state {}", process.name, from.state),
                                originOf(process, from.state));
    checkNames(from.statement, around, here);
    checkPaths(from.statement, here);
  }
}

void checkFunction(const Function& function, const Declarations& known, const Report& report) {
  checkVariables(function.parameters, function.variables, known, report);
  checkType(function.result, known, report);
  const CheckContext around{.known = known,
                            .scope = scopeOf(function.parameters, function.variables),
                            .result = &function.result};
  checkNames(function.body, around, report);
  checkReturns(function.body, report);
}

} // namespace proskill::fiacre
