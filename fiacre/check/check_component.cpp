#include "fiacre/check/check_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace proskill::fiacre {
namespace {

/// The ports and arguments that an instance needs.
struct Interface {
  const std::vector<Port>& ports;
  const std::vector<Parameter>& parameters;
};

std::optional<Interface> interfaceOf(const std::string& name, const Declarations& known) {
  if (const auto* process = lookUp(known.processes, name))
    return Interface{(*process)->ports, (*process)->parameters};
  if (const auto* component = lookUp(known.components, name))
    return Interface{(*component)->interfacePorts, (*component)->parameters};
  return std::nullopt;
}

class InstanceCheck {
public:
  InstanceCheck(const Instance& checked, const Interface& made, const CheckContext& near,
                const Report& to)
      : instance(checked), wanted(made), around(near), report(to) {}

  void run() const {
    if (counts("ports", wanted.ports.size(), instance.ports.size()))
      for (std::size_t i = 0; i < instance.ports.size(); ++i) port(i);
    if (counts("arguments", wanted.parameters.size(), instance.arguments.size()))
      for (std::size_t i = 0; i < instance.arguments.size(); ++i) argument(i);
  }

private:
  [[nodiscard]] bool counts(std::string_view what, std::size_t takes, std::size_t gets) const {
    if (takes == gets) return true;
    report(fmt::format("{} takes {} {}, not {}", instance.process, takes, what, gets));
    return false;
  }

  void port(std::size_t i) const {
    const auto& name = instance.ports[i];
    const auto* given = lookUp(around.ports, name);
    if (!given) return report(fmt::format("the port `{}` is not declared", name));
    const auto same = [&](const Type& a, const Type& b) { return sameType(a, b, around.known); };
    if (!std::ranges::equal((*given)->values, wanted.ports[i].values, same))
      report(fmt::format("the port `{}` carries other values than `{}` of {}", name,
                         wanted.ports[i].name, instance.process));
  }

  void argument(std::size_t i) const {
    const auto& parameter = wanted.parameters[i];
    const auto& given = instance.arguments[i];
    const bool reference = i < instance.references.size() && instance.references[i];
    if (reference != parameter.reference)
      return report(fmt::format("`{}` of {} must be passed by {}, not by {}", parameter.name,
                                instance.process, parameter.reference ? "reference" : "value",
                                reference ? "reference" : "value"));
    const Typing typing(around.known, around.scope, report);
    if (!reference) return typing.expect(given, parameter.type);
    const auto type = typing.target(given);
    if (type && !sameType(*type, parameter.type, around.known))
      report(fmt::format("`{}` of {} refers to a variable of another type", parameter.name,
                         instance.process));
  }

  const Instance& instance;
  const Interface& wanted;
  const CheckContext& around;
  const Report& report;
};

using Order = std::map<std::string_view, std::set<std::string_view>>;

/// Whether one port has priority over the other, directly or by transitivity.
bool comesBefore(std::string_view high, std::string_view low, const Order& below,
                 std::set<std::string_view>& seen) {
  const auto next = below.find(high);
  return next != below.end() && std::ranges::any_of(next->second, [&](std::string_view port) {
           return port == low || (seen.insert(port).second && comesBefore(port, low, below, seen));
         });
}

void checkPriorities(const Component& component, const CheckContext& around, const Report& report) {
  const auto known = [&](const std::string& port) {
    if (!around.ports.contains(port)) report(fmt::format("the port `{}` is not declared", port));
  };
  Order below;
  for (const auto& priority : component.priorities) {
    std::ranges::for_each(priority.higher, known);
    std::ranges::for_each(priority.lower, known);
    for (const auto& high : priority.higher)
      below[high].insert(priority.lower.begin(), priority.lower.end());
  }
  for (const auto& [port, _] : below) {
    std::set<std::string_view> seen;
    if (comesBefore(port, port, below, seen))
      return report(fmt::format("the port `{}` has priority over itself", port));
  }
}

bool contains(const std::vector<Instance>& parts, std::string_view name, const Declarations& known,
              std::set<std::string_view>& seen) {
  const auto holds = [&](const Instance& instance) {
    if (instance.process == name) return true;
    const auto* inner = lookUp(known.components, instance.process);
    return inner && seen.insert(instance.process).second &&
           contains((*inner)->instances, name, known, seen);
  };
  return std::ranges::any_of(parts, [&](const Instance& part) {
    return part.parts.empty() ? holds(part) : contains(part.parts, name, known, seen);
  });
}

void checkInstances(const std::vector<Instance>& parts, const CheckContext& around,
                    const Report& report) {
  for (const auto& part : parts) {
    if (part.synchronised)
      for (const auto& port : *part.synchronised)
        if (!around.ports.contains(port))
          report(fmt::format("the port `{}` is not declared", port));
    if (!part.parts.empty())
      checkInstances(part.parts, around, report);
    else if (const auto made = interfaceOf(part.process, around.known))
      InstanceCheck(part, *made, around, report).run();
    else
      report(fmt::format("there is no process or component `{}`", part.process));
  }
}

/// Checks the main component or an observer, which must need no ports and arguments.
void checkAlone(const std::string& name, std::string_view what, const Declarations& known,
                const Report& report) {
  const auto made = interfaceOf(name, known);
  if (!made)
    report(fmt::format("there is no {} `{}`", what, name));
  else if (!made->ports.empty() || !made->parameters.empty())
    report(fmt::format("the {} `{}` needs ports or arguments", what, name));
}

void checkObservers(const Program& program, const Declarations& known, const Report& report) {
  std::set<std::string_view> seen{program.main};
  for (const auto& [observer, model, origin] : program.observers) {
    const auto here = report.at("observer " + observer, origin);
    if (model != program.main)
      here(fmt::format("`{}` is observed, but the model is `{}`", model, program.main));
    if (!seen.insert(observer).second)
      here(fmt::format("`{}` is already declared as an observer", observer));
    checkAlone(observer, "component", known, here);
  }
}

} // namespace

void checkComponent(const Component& component, const Declarations& known, const Report& report) {
  checkPorts(component.interfacePorts, known, report);
  checkPorts(component.ports, known, report);
  checkVariables(component.parameters, component.variables, known, report);

  CheckContext around{.known = known, .scope = scopeOf(component.parameters, component.variables)};
  for (const auto* ports : {&component.interfacePorts, &component.ports})
    for (const auto& port : *ports)
      if (!around.ports.emplace(port.name, &port).second)
        report(fmt::format("the port `{}` is declared twice", port.name));
  checkPriorities(component, around, report);
  if (component.init) {
    checkNames(*component.init, around, report);
    checkInit(*component.init, report);
  }
  if (component.instances.empty()) report("a component needs an instance");
  checkInstances(component.instances, around, report);
}

void checkStructure(const Program& program, const Declarations& known, const Report& report) {
  for (const auto& component : program.components) {
    std::set<std::string_view> seen;
    if (contains(component.instances, component.name, known, seen))
      report.at("component " + component.name)("the component contains itself");
  }
  const auto model = report.at("model");
  if (program.main.empty())
    return model("its name is missing: the model must end with the name of a component");
  checkAlone(program.main, "main component", known, model);
  checkObservers(program, known, report);
}

} // namespace proskill::fiacre
