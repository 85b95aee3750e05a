#include "verify/elaborate.h"

#include "verify/evaluate.h"
#include "verify/unsupported.h"

#include <algorithm>
#include <set>

namespace proskill::verify {

using fiacre::Statement;
using fiacre::StatementKind;
using fiacre::Type;
using fiacre::TypeKind;

namespace {

/// The names of the cells of a variable, in the order of Types::flatten.
void cellNames(const Types& types, const Type& named, const std::string& name,
               std::vector<std::string>& all) {
  const Type& type = types.resolve(named);
  if (type.kind == TypeKind::Record) {
    for (const auto& member : type.members)
      cellNames(types, member.type.at(0), name + "." + member.name, all);
  } else if (type.kind == TypeKind::Array) {
    for (std::int64_t i = 0; i < type.size; ++i)
      cellNames(types, type.element.at(0), name + "[" + std::to_string(i) + "]", all);
  } else {
    all.push_back(name);
  }
}

void rootsAssigned(const Statement& statement, std::set<std::string>& roots) {
  for (const auto& target : statement.targets) {
    const fiacre::Expr* root = &target;
    while (!root->operands.empty()) root = &root->operands[0];
    roots.insert(root->name);
  }
  for (const auto& child : statement.children) rootsAssigned(child, roots);
}

class Elaborator {
public:
  Elaborator(const fiacre::Program& of, const Types& known, Expressions& in, System& to)
      : program(of), types(known), expressions(in), system(to) {}

  Elaboration run() {
    auto component = std::ranges::find(program.components, program.main, &fiacre::Component::name);
    if (component == program.components.end())
      unsupported("the component `" + program.main + "` is not declared");
    made.component = &*component;
    if (!component->priorities.empty()) unsupported("priorities are not verified yet");
    if (!component->interfacePorts.empty() || !component->parameters.empty())
      unsupported("the main component has parameters");
    for (const auto& constant : program.constants) addConstant(constant);
    for (const auto& variable : component->variables)
      declare(variable, variable.name, made.componentScope);
    if (component->init) start(*component->init, made.componentScope, nullptr, kNone);
    for (const auto& port : component->ports) addPort(port);
    for (const auto& instance : component->instances) addInstance(instance);
    return std::move(made);
  }

private:
  void addConstant(const fiacre::Constant& constant) {
    const Type& type = types.resolve(constant.type);
    Value value = expressions.value(constant.value, {}, &type);
    if (value.parts.size() == 1) made.constants[constant.name] = initially(value.parts[0]);
  }

  void addPort(const fiacre::Port& port) {
    if (!port.values.empty()) unsupported("values over ports are not verified yet");
    system.ports.push_back(port.name);
    made.members.emplace_back();
  }

  CellId addCell(std::string name, Types::Bounds bounds, std::int64_t initial) {
    if (initial < bounds.low || initial > bounds.high)
      unsupported("`" + name + "` starts outside of its range");
    system.cells.push_back({std::move(name), bounds.low, bounds.high, initial});
    return static_cast<CellId>(system.cells.size() - 1);
  }

  /// A variable's cells, with its first value.
  void declare(const fiacre::Variable& variable, const std::string& name, Scope& scope) {
    const Type& type = types.resolve(variable.type);
    Value initial =
        variable.init ? expressions.value(*variable.init, scope, &type) : expressions.lowest(type);
    allocate(type, name, initial);
    scope[variable.name] = std::move(initial);
  }

  /// Turns a value into cells that start with it.
  void allocate(const Type& type, const std::string& name, Value& value) {
    std::vector<const Type*> scalars;
    std::vector<std::string> names;
    types.flatten(type, scalars);
    cellNames(types, type, name, names);
    if (value.parts.size() != scalars.size())
      unsupported("`" + name + "` starts with a value of another type");
    for (std::size_t i = 0; i < scalars.size(); ++i) {
      auto initial = initially(value.parts[i]);
      value.parts[i] =
          expressions.nodes().cell(addCell(names[i], types.bounds(*scalars[i]), initial));
    }
    value.type = &type;
  }

  std::int64_t initially(NodeId node) {
    std::vector<std::int64_t> first;
    for (const auto& cell : system.cells) first.push_back(cell.initial);
    auto value = evaluateUnpacked(system, node, first);
    if (!value) unsupported("a first value divides by zero");
    return *value;
  }

  void addInstance(const fiacre::Instance& instance) {
    auto process = std::ranges::find(program.processes, instance.process, &fiacre::Process::name);
    if (process == program.processes.end())
      unsupported("`" + instance.process +
                  "` is no process; components within components are not verified yet");
    const auto id = static_cast<InstanceId>(system.instances.size());
    const std::string name = process->name + "_" + std::to_string(++counts[process->name]);
    Instance added{.name = name, .origin = process->origin};
    for (const auto& state : process->states) {
      added.locations.push_back(state.name);
      added.locationOrigins.push_back(state.origin);
    }
    if (added.locations.empty()) unsupported("`" + process->name + "` has no states");
    const auto last = static_cast<std::int64_t>(added.locations.size()) - 1;
    added.location = addCell(name, {0, last}, 0);
    system.instances.push_back(std::move(added));
    made.processes.push_back(&*process);
    made.scopes.push_back(bind(*process, instance, name));
    bindPorts(*process, instance, id);
    Scope& scope = made.scopes.back();
    for (const auto& variable : process->variables)
      declare(variable, name + "." + variable.name, scope);
    if (process->init) start(*process->init, scope, &*process, id);
  }

  Scope bind(const fiacre::Process& process, const fiacre::Instance& instance,
             const std::string& name) {
    if (process.parameters.size() != instance.arguments.size())
      unsupported("`" + process.name + "` gets the wrong number of arguments");
    std::set<std::string> assigned;
    for (const auto& from : process.transitions) rootsAssigned(from.statement, assigned);
    Scope scope;
    for (std::size_t i = 0; i < process.parameters.size(); ++i) {
      const auto& parameter = process.parameters[i];
      const Type& type = types.resolve(parameter.type);
      Value argument = expressions.value(instance.arguments[i], made.componentScope, &type);
      if (!parameter.reference) {
        if (assigned.contains(parameter.name))
          allocate(type, name + "." + parameter.name, argument);
        else
          for (auto& part : argument.parts) part = expressions.nodes().number(initially(part));
      }
      argument.type = &type;
      scope[parameter.name] = std::move(argument);
    }
    return scope;
  }

  void bindPorts(const fiacre::Process& process, const fiacre::Instance& instance, InstanceId id) {
    if (process.ports.size() != instance.ports.size())
      unsupported("`" + process.name + "` gets the wrong number of ports");
    auto& ports = made.portsOf.emplace_back();
    for (const auto& actual : instance.ports) {
      auto found = std::ranges::find(system.ports, actual);
      if (found == system.ports.end()) unsupported("the port `" + actual + "` is not declared");
      ports.push_back(static_cast<std::uint32_t>(found - system.ports.begin()));
      auto& members = made.members[ports.back()];
      if (std::ranges::find(members, id) == members.end()) members.push_back(id);
    }
  }

  /// Runs an `init` on the cells' first values.
  void start(const Statement& statement, const Scope& scope, const fiacre::Process* process,
             InstanceId id) {
    switch (statement.kind) {
    case StatementKind::Null:
    case StatementKind::Comment:
    case StatementKind::Tag: return;
    case StatementKind::Sequence:
      for (const auto& child : statement.children) start(child, scope, process, id);
      return;
    case StatementKind::Assign: return startAssign(statement, scope);
    case StatementKind::If: {
      bool holds = initially(expressions.scalar(statement.values.at(0), scope)) != 0;
      if (holds || statement.children.size() > 1)
        start(statement.children[holds ? 0 : 1], scope, process, id);
      return;
    }
    case StatementKind::To: {
      auto state = std::ranges::find(process->states, statement.name, &fiacre::State::name);
      if (state == process->states.end())
        unsupported("`" + statement.name + "` is no state of this process", statement.origin);
      system.cells[system.instances[id].location].initial = state - process->states.begin();
      return;
    }
    default: unsupported("a statement in `init` that is not verified yet", statement.origin);
    }
  }

  void startAssign(const Statement& statement, const Scope& scope) {
    std::vector<Assignment> assignments;
    for (std::size_t i = 0; i < statement.targets.size(); ++i) {
      const Type& type = expressions.typeOf(statement.targets[i], scope);
      Value source = expressions.value(statement.values.at(i), scope, &type);
      expressions.assign(statement.targets[i], source, scope, assignments);
    }
    std::vector<std::int64_t> values;
    for (const auto& assignment : assignments) values.push_back(initially(assignment.value));
    for (std::size_t i = 0; i < assignments.size(); ++i) {
      Cell& cell = system.cells[assignments[i].target];
      if (values[i] < cell.low || values[i] > cell.high)
        unsupported("`" + cell.name + "` starts outside of its range");
      cell.initial = values[i];
    }
  }

  const fiacre::Program& program;
  const Types& types;
  Expressions& expressions;
  System& system;
  Elaboration made;
  std::map<std::string, int> counts;
};

} // namespace

Elaboration elaborate(const fiacre::Program& program, const Types& types, Expressions& expressions,
                      System& system) {
  return Elaborator(program, types, expressions, system).run();
}

} // namespace proskill::verify
