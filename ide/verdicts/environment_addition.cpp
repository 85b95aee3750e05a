#include "codegen/process/skill_frame.h"
#include "codegen/term/build.h"
#include "ide/verdicts/addition.h"
#include "ide/verdicts/model_additions.h"

#include <fmt/format.h>

namespace proskill::ide {

namespace {

/// Ports and parameters of the process that replaces the environment.
struct Interface {
  std::string name;
  std::string place; ///< "process P", as in messages of the type checker
  std::vector<fiacre::Port> ports;
  std::vector<fiacre::Parameter> parameters;
};

std::optional<Interface> interfaceOf(const fiacre::Program& read, const std::string& name) {
  for (const auto& component : read.components)
    if (component.name == name)
      return Interface{name, "component " + name, component.interfacePorts, component.parameters};
  for (const auto& process : read.processes)
    if (process.name == name)
      return Interface{name, "process " + name, process.ports, process.parameters};
  return std::nullopt;
}

std::optional<Interface> environmentIn(Addition& addition) {
  const auto& read = addition.parsed.program;
  auto name = read.main;
  if (name.empty() && !read.components.empty()) name = read.components.back().name;
  if (name.empty() && read.processes.size() == 1) name = read.processes[0].name;
  auto found = interfaceOf(read, name);
  if (!found)
    addition.complain({0, 0}, "environment",
                      read.processes.empty() && read.components.empty()
                          ? "there is no process in it"
                          : "which process is it? Write its name at the end of the text");
  return found;
}

std::string joined(const std::vector<fiacre::Port>& ports) {
  std::string all;
  for (const auto& port : ports) all += (all.empty() ? "`" : ", `") + port.name + "`";
  return all.empty() ? "none" : all;
}

bool contains(const std::vector<fiacre::Port>& ports, const std::string& name) {
  return std::ranges::find(ports, name, &fiacre::Port::name) != ports.end();
}

void checkInterface(Addition& addition, const Interface& environment,
                    const std::vector<fiacre::Port>& offered, const fiacre::Component& main) {
  for (const auto& port : environment.ports)
    if (!contains(offered, port.name))
      addition.complainAt(
          port.name, NameKind::Port, environment.place,
          contains(main.ports, port.name)
              ? fmt::format("`{}` has `:every` and comes by itself", port.name)
              : fmt::format("the program has no event or interrupt `{}`: there are {}", port.name,
                            joined(offered)));
  for (const auto& parameter : environment.parameters) {
    if (std::ranges::find(main.variables, parameter.name, &fiacre::Variable::name) ==
        main.variables.end())
      addition.complainAt(parameter.name, NameKind::Parameter, environment.place,
                          fmt::format("the model has no variable `{}`", parameter.name));
    else if (!parameter.reference)
      addition.complainAt(
          parameter.name, NameKind::Parameter, environment.place,
          fmt::format("a variable of the model is passed by reference: `&{}`", parameter.name));
  }
}

fiacre::Instance instanceOf(const Interface& environment) {
  fiacre::Instance instance{.process = environment.name};
  for (const auto& port : environment.ports) instance.ports.push_back(port.name);
  for (const auto& parameter : environment.parameters) {
    instance.arguments.push_back({.kind = fiacre::ExprKind::Name, .name = parameter.name});
    instance.references.push_back(true);
  }
  return instance;
}

/// Makes the environment begin together with the program, after initial values have been chosen.
void holdBack(fiacre::Program& model, const Interface& environment, const std::string& begin) {
  std::vector<fiacre::Statement> passed;
  fiacre::Process gate{.name = "environment_begins", .comment = "Nothing happens before."};
  gate.ports.emplace_back().name = begin;
  for (const auto& port : environment.ports) {
    gate.ports.emplace_back().name = port.name;
    passed.push_back(codegen::synchronise(port.name));
  }
  codegen::addState(gate, "before", 0,
                    codegen::sequence({codegen::synchronise(begin), codegen::to("open")}));
  if (passed.empty())
    gate.states.push_back({"open", 0});
  else
    codegen::addState(gate, "open", 0,
                      codegen::sequence({codegen::select(std::move(passed)), codegen::to("open")}));
  fiacre::Instance instance{.process = gate.name};
  for (const auto& port : gate.ports) instance.ports.push_back(port.name);
  model.components.back().instances.push_back(std::move(instance));
  model.processes.push_back(std::move(gate));
}

/// Blocks the events for which the environment has no port. Without this they would happen whenever
/// possible.
void forbidOthers(fiacre::Program& model, const Interface& environment,
                  const std::vector<fiacre::Port>& offered) {
  auto& main = model.components.back();
  fiacre::Process never{.name = "not_in_environment",
                        .comment = "What the environment does not name never happens.",
                        .states = {{"never", 0}}};
  for (const auto& port : offered)
    if (!contains(environment.ports, port.name)) never.ports.push_back(port);
  if (never.ports.empty()) return;
  fiacre::Instance instance{.process = never.name};
  for (const auto& port : never.ports) instance.ports.push_back(port.name);
  main.instances.push_back(std::move(instance));
  model.processes.push_back(std::move(never));
}

bool isAbout(const fiacre::Observable& observable, std::uint32_t place) {
  return (!observable.path.empty() && observable.path[0] == place) ||
         std::ranges::any_of(observable.operands,
                             [&](const auto& operand) { return isAbout(operand, place); });
}

bool isAbout(const fiacre::Ltl& ltl, std::uint32_t place) {
  return isAbout(ltl.atom, place) || std::ranges::any_of(ltl.operands, [&](const auto& operand) {
           return isAbout(operand, place);
         });
}

bool isAbout(const fiacre::Pattern& pattern, std::uint32_t place) {
  return std::ranges::any_of(pattern.operands,
                             [&](const auto& operand) { return isAbout(operand, place); }) ||
         (pattern.after && isAbout(*pattern.after, place)) ||
         (pattern.before && isAbout(*pattern.before, place)) || isAbout(pattern.ltl, place);
}

/// Removes the checks of states of the replaced environment.
void dropChecks(codegen::Model& model, std::uint32_t place) {
  for (auto i = model.fiacre.properties.size(); i-- > 0;) {
    if (!isAbout(model.fiacre.properties[i].pattern, place)) continue;
    model.fiacre.properties.erase(model.fiacre.properties.begin() + static_cast<long>(i));
    std::erase_if(model.checks, [&](const codegen::Check& check) { return check.property == i; });
    for (auto& check : model.checks)
      if (check.property > i) --check.property;
  }
}

/// Whether a process is the generated environment, which has a name of its own kind. The Tina
/// edition has none if the environment does nothing.
bool isEnvironment(const fiacre::Process& process) {
  return process.name.starts_with("environment_") || process.name.starts_with("basic_environment_");
}

/// Removes the environment's process and instance, which are the last ones. \return the ports that
/// it had
std::vector<fiacre::Port> removeEnvironment(codegen::Model& model) {
  auto& processes = model.fiacre.processes;
  if (processes.empty() || !isEnvironment(processes.back())) return {};
  auto& instances = model.fiacre.components.back().instances;
  dropChecks(model, static_cast<std::uint32_t>(instances.size()));
  auto ports = std::move(processes.back().ports);
  instances.pop_back();
  processes.pop_back();
  return ports;
}

} // namespace

std::vector<Diagnostic> replaceEnvironment(codegen::Model& model, analysis::Program& program,
                                           const std::filesystem::path& path, std::string text) {
  Addition addition(model, program, path, std::move(text), {});
  if (!addition.diagnostics.empty()) return addition.diagnostics;
  const auto environment = environmentIn(addition);
  if (!environment) return addition.diagnostics;
  auto& fiacre = model.fiacre;
  auto& main = fiacre.components.back();
  auto offered = removeEnvironment(model);
  std::erase_if(offered, [&](const auto& port) { return port.name == model.beginPort; });
  checkInterface(addition, *environment, offered, main);
  if (!addition.diagnostics.empty()) return addition.diagnostics;
  main.instances.push_back(instanceOf(*environment));
  // events are urgent
  for (auto& port : main.ports)
    if (contains(offered, port.name)) port.interval = fiacre::Interval{.lower = 0, .upper = 0};
  forbidOthers(fiacre, *environment, offered);
  if (!model.beginPort.empty()) holdBack(fiacre, *environment, model.beginPort);
  auto& read = addition.parsed.program;
  append(fiacre.constants, read.constants);
  append(fiacre.types, read.types);
  append(fiacre.functions, read.functions);
  append(fiacre.processes, read.processes);
  fiacre.components.insert(fiacre.components.begin(), read.components.begin(),
                           read.components.end());
  addition.check();
  return addition.diagnostics;
}

} // namespace proskill::ide
