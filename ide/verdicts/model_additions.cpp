#include "ide/verdicts/model_additions.h"

#include "fiacre/check/check.h"
#include "fiacre/print/print.h"
#include "fiacre/syntax/parse.h"
#include "fiacre/syntax/words.h"
#include "ide/snapshot/fiacre_file.h"
#include "syntax/diagnostics/codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace proskill::ide {

namespace {

using fiacre::NameKind;
using syntax::Code;
using syntax::Diagnostic;
using syntax::Offset;
using syntax::Range;

/// A text that is added to a program: read, its origins among those of the model.
class Addition {
public:
  Addition(codegen::Model& to, analysis::Program& in, const std::filesystem::path& path,
           std::string source, const fiacre::PathSteps& steps)
      : model(to), program(in), file(static_cast<syntax::FileId>(in.files.size())) {
    program.files.push_back({path, syntax::Document::parse(std::move(source))});
    parsed = fiacre::parse(text(), steps);
    for (const auto& problem : parsed.problems)
      diagnostics.push_back(syntax::makeDiagnostic(
          Code::FiacreText, {file, {problem.begin, problem.end}}, problem.message));
    firstOrigin = static_cast<fiacre::OriginId>(model.provenance.origins.size());
    for (std::size_t i = 1; i < parsed.provenance.origins.size(); ++i) {
      model.provenance.origins.push_back(parsed.provenance.origins[i]);
      model.provenance.origins.back().file = file;
    }
    moveOrigins();
  }

  [[nodiscard]] const std::string& text() const { return program.files[file].document.text(); }

  void complain(Range range, std::string_view place, const std::string& message) {
    diagnostics.push_back(syntax::makeDiagnostic(Code::FiacreModel, {file, range}, place, message));
  }

  /// At a name of a kind; at the text's begin where there is none.
  void complainAt(std::string_view name, NameKind kind, std::string_view place,
                  const std::string& message) {
    const auto found = std::ranges::find_if(parsed.mentions, [&](const fiacre::Mention& each) {
      return each.kind == kind &&
             std::string_view(text()).substr(each.begin, each.end - each.begin) == name;
    });
    const bool known = found != parsed.mentions.end();
    complain(known ? Range{found->begin, found->end} : Range{0, 0}, place, message);
  }

  /// What the type checker says of the model with the addition.
  void check() {
    for (const auto& problem : fiacre::check(model.fiacre))
      complain(rangeOf(problem, model.provenance, text()), problem.place, problem.message);
  }

  codegen::Model& model;
  fiacre::Parsed parsed;
  std::vector<Diagnostic> diagnostics;

private:
  void move(fiacre::OriginId& origin) const {
    if (origin != 0) origin += firstOrigin - 1;
  }
  void move(fiacre::Statement& statement) const {
    move(statement.origin);
    for (auto& child : statement.children) move(child);
  }
  void moveOrigins() {
    auto& read = parsed.program;
    for (auto& process : read.processes) {
      move(process.origin);
      for (auto& state : process.states) move(state.origin);
      if (process.init) move(*process.init);
      for (auto& from : process.transitions) move(from.statement);
    }
    for (auto& function : read.functions) move(function.body);
    for (auto& component : read.components)
      if (component.init) move(*component.init);
    for (auto& property : read.properties) move(property.origin);
  }

  analysis::Program& program;
  syntax::FileId file;
  fiacre::OriginId firstOrigin = 0;
};

template <class Element> void append(std::vector<Element>& to, std::vector<Element>& from) {
  std::ranges::move(from, std::back_inserter(to));
  from.clear();
}

// --- The environment

/// The ports and parameters of what takes the environment's place.
struct Interface {
  std::string name;
  std::string place; ///< "process P", as the type checker says it
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

/// Takes part in what the environment has no port for, and never does: without it, that would
/// happen whenever it could.
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

/// What was asked of the states of the environment that is no more.
void dropChecks(codegen::Model& model, std::uint32_t place) {
  for (auto i = model.fiacre.properties.size(); i-- > 0;) {
    if (!isAbout(model.fiacre.properties[i].pattern, place)) continue;
    model.fiacre.properties.erase(model.fiacre.properties.begin() + static_cast<long>(i));
    std::erase_if(model.checks, [&](const codegen::Check& check) { return check.property == i; });
    for (auto& check : model.checks)
      if (check.property > i) --check.property;
  }
}

/// The generator names it by its kind, as no other process; for Tina it is not there where it does
/// nothing.
bool isEnvironment(const fiacre::Process& process) {
  return process.name.starts_with("environment_") || process.name.starts_with("basic_environment_");
}

/// Its process and its instance are the last ones. \return the ports that it took
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

// --- Properties

/// What the parts of a model are called in paths: the processes, and the program's own names for
/// them.
fiacre::PathSteps stepsOf(const codegen::Model& model) {
  fiacre::PathSteps steps;
  const auto& program = model.fiacre;
  const auto main = std::ranges::find(program.components, program.main, &fiacre::Component::name);
  if (main == program.components.end()) return steps;
  std::uint32_t place = 0;
  for (const auto& instance : main->instances) {
    steps.try_emplace(instance.process, ++place);
    const auto process =
        std::ranges::find(program.processes, instance.process, &fiacre::Process::name);
    if (process == program.processes.end()) continue;
    const auto& actor = model.provenance.origins[process->origin].actor;
    if (fiacre::isIdentifier(actor)) steps.try_emplace(actor, place);
  }
  return steps;
}

/// Names of the program in the place of which the model's come.
class Translation {
public:
  explicit Translation(const std::vector<fiacre::Watched>& known) : watched(known) {}

  void translate(fiacre::Expr& expr) const {
    if (const auto* variable = named(fiacre::printExpr(expr))) {
      expr = fiacre::parseExpr(variable->lvalue).value_or(expr);
      return;
    }
    const auto* compared =
        expr.operands.empty() ? nullptr : named(fiacre::printExpr(expr.operands[0]));
    for (auto& operand : expr.operands) translate(operand);
    if (!compared || expr.operands.size() != 2) return;
    auto& value = expr.operands[1];
    for (const auto& [inModel, inProgram] : compared->values)
      if (value.kind == fiacre::ExprKind::Name && value.name == inProgram) value.name = inModel;
  }

  void translate(fiacre::Observable& observable) const {
    if (observable.kind == fiacre::ObservableKind::Value && observable.path.empty())
      translate(observable.value);
    for (auto& operand : observable.operands) translate(operand);
  }

  void translate(fiacre::Ltl& ltl) const {
    translate(ltl.atom);
    for (auto& operand : ltl.operands) translate(operand);
  }

  void translate(fiacre::Pattern& pattern) const {
    for (auto& operand : pattern.operands) translate(operand);
    if (pattern.after) translate(*pattern.after);
    if (pattern.before) translate(*pattern.before);
    translate(pattern.ltl);
  }

private:
  [[nodiscard]] const fiacre::Watched* named(const std::string& text) const {
    const auto found = std::ranges::find_if(watched, [&](const fiacre::Watched& each) {
      return each.display == text || each.lvalue == text;
    });
    return found == watched.end() ? nullptr : &*found;
  }

  const std::vector<fiacre::Watched>& watched;
};

constexpr std::string_view kAnyModel = "model";

/// Paths begin with the model's name; other declarations have no place here.
void checkProperties(Addition& addition) {
  const auto& text = addition.text();
  for (const auto& block : addition.parsed.blocks)
    if (block.kind != NameKind::Property)
      addition.complain({block.begin, block.end}, "properties",
                        "only properties can be added to a model");
  for (const auto& mention : addition.parsed.mentions) {
    const auto name = std::string_view(text).substr(mention.begin, mention.end - mention.begin);
    if (mention.kind == NameKind::Component && name != kAnyModel &&
        name != addition.model.fiacre.main)
      addition.complain({mention.begin, mention.end}, "properties",
                        fmt::format("the model is `{}`: a path begins with that, or with `{}`",
                                    addition.model.fiacre.main, kAnyModel));
  }
}

void addChecked(Addition& addition, fiacre::Property property) {
  auto& model = addition.model;
  const auto same = [&](const fiacre::Property& other) { return other.name == property.name; };
  if (std::ranges::any_of(model.fiacre.properties, same))
    return addition.complainAt(property.name, NameKind::Property, "property " + property.name,
                               "the model has a property of that name");
  Translation(model.provenance.watched).translate(property.pattern);
  if (property.asserted)
    model.checks.push_back(
        {.name = property.name,
         .kind = "property",
         .subject = property.name,
         .description = fiacre::printPattern(property.pattern, model.fiacre.main),
         .property = model.fiacre.properties.size(),
         .origin = property.origin});
  model.fiacre.properties.push_back(std::move(property));
}

/// A formula alone is a property that is called as its file; it stands where it stood.
std::string asProperty(const std::filesystem::path& path, const std::string& formula) {
  auto name = path.stem().string();
  std::ranges::replace_if(
      name, [](char c) { return !fiacre::isIdentifier(std::string("a") + c); }, '_');
  if (!fiacre::isIdentifier(name) || fiacre::isReserved(name)) name = "formula_" + name;
  return fmt::format("property {0} is ltl {1}\nassert {0}\n", name, formula);
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
  const auto offered = removeEnvironment(model);
  checkInterface(addition, *environment, offered, main);
  if (!addition.diagnostics.empty()) return addition.diagnostics;
  main.instances.push_back(instanceOf(*environment));
  // What it says happens when it says so.
  for (auto& port : main.ports)
    if (contains(offered, port.name)) port.interval = fiacre::Interval{.lower = 0, .upper = 0};
  forbidOthers(fiacre, *environment, offered);
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

std::vector<Diagnostic> addProperties(codegen::Model& model, analysis::Program& program,
                                      const std::filesystem::path& path, std::string text) {
  if (path.extension() == ".ltl") text = asProperty(path, text);
  Addition addition(model, program, path, std::move(text), stepsOf(model));
  checkProperties(addition);
  if (!addition.diagnostics.empty()) return addition.diagnostics;
  for (auto& property : addition.parsed.program.properties)
    addChecked(addition, std::move(property));
  if (addition.diagnostics.empty()) addition.check();
  return addition.diagnostics;
}

} // namespace proskill::ide
