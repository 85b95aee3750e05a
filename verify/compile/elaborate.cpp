#include "verify/compile/elaborate.h"

#include "verify/compile/init.h"
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
  types.checkLimits();
  const Type& type = types.resolve(named);
  if (type.kind == TypeKind::Record) {
    for (const auto& member : type.members)
      cellNames(types, member.type.at(0), name + "." + member.name, all);
  } else if (type.kind == TypeKind::Array) {
    for (std::int64_t i = 0; i < type.size; ++i)
      cellNames(types, type.element.at(0), name + "[" + std::to_string(i) + "]", all);
  } else if (type.kind == TypeKind::Queue) {
    all.push_back("length of " + name);
    for (std::int64_t i = 0; i < type.size; ++i)
      cellNames(types, type.element.at(0), name + "[" + std::to_string(i) + "]", all);
  } else {
    all.push_back(name);
    if (type.kind != TypeKind::Union) return;
    for (const auto& member : type.members)
      if (!member.type.empty()) cellNames(types, member.type[0], name + "." + member.name, all);
  }
}

void rootsAssigned(const Statement& statement, std::set<std::string>& roots) {
  for (const auto& target : statement.targets) {
    const fiacre::Expr* root = &target;
    while (!root->operands.empty()) root = &root->operands[0];
    roots.insert(root->name);
  }
  if (statement.kind == StatementKind::Foreach) roots.insert(statement.name);
  if (statement.kind == StatementKind::Case)
    for (std::size_t i = 1; i < statement.values.size(); ++i) { // the value of `frame(x)` for x
      const fiacre::Expr* inner = &statement.values[i];
      const bool binds = !inner->operands.empty();
      while (!inner->operands.empty()) inner = &inner->operands[0];
      if (binds && inner->kind == fiacre::ExprKind::Name) roots.insert(inner->name);
    }
  for (const auto& child : statement.children) rootsAssigned(child, roots);
}

constexpr std::size_t kMostNested = 50;

class Elaborator {
public:
  Elaborator(const fiacre::Program& of, const Types& known, Expressions& in, System& to)
      : program(of), types(known), expressions(in), system(to) {}

  Elaboration run() {
    for (const auto& constant : program.constants) addConstant(constant);
    made.composition = addAlone(program.main, {}, made.componentScope);
    if (!program.observers.empty()) addObservers();
    return std::move(made);
  }

private:
  /// Adds the model or an observer, which is a component or a process.
  Branch addAlone(const std::string& name, const ModelPath& path, Scope& scope) {
    const auto component = find(program.components, name);
    const auto process = find(program.processes, name);
    if (component) {
      if (!component->interfacePorts.empty() || !component->parameters.empty())
        unsupported("the main component has parameters");
      return addComponent(*component, path, scope, {});
    }
    if (process) // a single process: the path to it is empty
      return addProcess(*process, {.process = process->name}, path, {}, {});
    unsupported("the component `" + name + "` is not declared");
  }

  /// Adds observers, which run in parallel with the model and share no port with it or each other.
  void addObservers() {
    Branch all;
    all.children.push_back(std::move(made.composition));
    made.firstObserver = static_cast<InstanceId>(system.instances.size());
    for (std::uint32_t k = 1; k <= program.observers.size(); ++k) {
      Scope scope;
      all.children.push_back(addAlone(program.observers[k - 1].observer, {0, k}, scope));
    }
    for (const auto& child : all.children) all.ports.insert(child.ports.begin(), child.ports.end());
    made.composition = std::move(all);
  }

  void addConstant(const fiacre::Constant& constant) {
    const Type& type = types.resolve(constant.type);
    Value value = expressions.value(constant.value, {}, &type);
    if (value.parts.size() == 1) made.constants[constant.name] = firstValue(system, value.parts[0]);
  }

  /// The names of ports within a component or a process, and their global indices.
  using PortNames = std::map<std::string, std::uint32_t, std::less<>>;

  template <class Item>
  static const Item* find(const std::vector<Item>& all, const std::string& name) {
    auto found = std::ranges::find(all, name, &Item::name);
    return found == all.end() ? nullptr : &*found;
  }

  static std::uint32_t portNamed(const PortNames& ports, const std::string& name) {
    auto found = ports.find(name);
    if (found == ports.end()) unsupported("the port `" + name + "` is not declared");
    return found->second;
  }

  std::uint32_t addPort(const fiacre::Port& port) {
    system.ports.push_back(port.name);
    made.intervals.push_back(port.interval);
    made.probes.push_back(port.probe ? &*port.probe : nullptr);
    return static_cast<std::uint32_t>(system.ports.size() - 1);
  }

  /// Adds a component: its variables and ports, then its parts.
  Branch addComponent(const fiacre::Component& component, const ModelPath& path, Scope& scope,
                      PortNames ports) {
    if (path.size() > kMostNested) unsupported("components contain each other too deeply");
    const std::string prefix =
        path.empty() ? "" : component.name + "_" + std::to_string(++counts[component.name]) + ".";
    for (const auto& variable : component.variables)
      declare(variable, prefix + variable.name, scope);
    if (component.init) InitRunner(expressions, scope, system).run(*component.init, nullptr, kNone);
    for (const auto& port : component.ports) ports[port.name] = addPort(port);
    for (const auto& [name, port] : ports) made.portAt[{path, name}] = port;
    addPriorities(component, ports);
    Branch branch = addParts(component.instances, path, scope, ports);
    if (!path.empty()) made.scopeAt[path] = scope;
    return branch;
  }

  Branch addParts(const std::vector<fiacre::Instance>& parts, const ModelPath& path,
                  const Scope& scope, const PortNames& ports) {
    Branch branch;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      ModelPath below = path;
      below.push_back(static_cast<std::uint32_t>(i + 1));
      branch.children.push_back(addInstance(parts[i], below, scope, ports));
      const auto& added = branch.children.back().ports;
      branch.ports.insert(added.begin(), added.end());
    }
    return branch;
  }

  void addPriorities(const fiacre::Component& component, const PortNames& ports) {
    const auto all = [&](const std::vector<std::string>& names) {
      std::set<std::uint32_t> found;
      for (const auto& name : names) found.insert(portNamed(ports, name));
      return found;
    };
    for (const auto& priority : component.priorities)
      made.priorities.push_back({all(priority.higher), all(priority.lower)});
  }

  Branch addInstance(const fiacre::Instance& instance, const ModelPath& path, const Scope& outer,
                     const PortNames& ports) {
    Branch branch;
    if (!instance.parts.empty()) {
      branch = addParts(instance.parts, path, outer, ports);
    } else if (const auto* process = find(program.processes, instance.process)) {
      branch = addProcess(*process, instance, path, outer, ports);
    } else if (const auto* component = find(program.components, instance.process)) {
      Scope scope = bind(component->parameters, {}, instance, instance.process, outer);
      branch =
          addComponent(*component, path, scope, bound(component->interfacePorts, instance, ports));
    } else {
      unsupported("`" + instance.process + "` is neither a process nor a component");
    }
    if (!instance.synchronised) return branch;
    branch.synchronised.emplace();
    for (const auto& name : *instance.synchronised)
      branch.synchronised->insert(portNamed(ports, name));
    return branch;
  }

  static PortNames bound(const std::vector<fiacre::Port>& formal, const fiacre::Instance& instance,
                         const PortNames& ports) {
    if (formal.size() != instance.ports.size())
      unsupported("`" + instance.process + "` gets the wrong number of ports");
    PortNames names;
    for (std::size_t i = 0; i < formal.size(); ++i)
      names[formal[i].name] = portNamed(ports, instance.ports[i]);
    return names;
  }

  CellId addCell(std::string name, Types::Bounds bounds, std::int64_t initial) {
    if (initial < bounds.low || initial > bounds.high)
      unsupported("`" + name + "` starts outside of its range");
    system.cells.push_back({std::move(name), bounds.low, bounds.high, initial});
    made.cellTypes.push_back(nullptr);
    return static_cast<CellId>(system.cells.size() - 1);
  }

  /// Allocates the cells of a variable, with its initial value.
  void declare(const fiacre::Variable& variable, const std::string& name, Scope& scope) {
    const Type& type = types.resolve(variable.type);
    Value initial =
        variable.init ? expressions.value(*variable.init, scope, &type) : expressions.lowest(type);
    allocate(type, name, initial);
    scope[variable.name] = std::move(initial);
  }

  /// Allocates cells with a value as their initial values.
  void allocate(const Type& type, const std::string& name, Value& value) {
    std::vector<const Type*> scalars;
    std::vector<std::string> names;
    const std::size_t count = value.parts.size();
    types.checkGrowth(count * (sizeof(const Type*) + sizeof(std::string) + sizeof(Cell)));
    scalars.reserve(count);
    names.reserve(count);
    if (count > system.cells.size()) system.cells.reserve(system.cells.size() + count);
    types.flatten(type, scalars);
    cellNames(types, type, name, names);
    if (value.parts.size() != scalars.size())
      unsupported("`" + name + "` starts with a value of another type");
    for (std::size_t i = 0; i < scalars.size(); ++i) {
      types.checkLimits();
      auto initial = firstValue(system, value.parts[i]);
      value.parts[i] =
          expressions.nodes().cell(addCell(names[i], types.bounds(*scalars[i]), initial));
      made.cellTypes.back() = scalars[i];
    }
    value.type = &type;
  }

  Branch addProcess(const fiacre::Process& process, const fiacre::Instance& instance,
                    const ModelPath& path, const Scope& outer, const PortNames& ports) {
    const auto id = static_cast<InstanceId>(system.instances.size());
    const std::string name = process.name + "_" + std::to_string(++counts[process.name]);
    Instance added{.name = name, .origin = process.origin};
    for (const auto& state : process.states) {
      added.locations.push_back(state.name);
      added.locationOrigins.push_back(state.origin);
    }
    if (added.locations.empty()) unsupported("`" + process.name + "` has no states");
    const auto last = static_cast<std::int64_t>(added.locations.size()) - 1;
    added.location = addCell(name, {0, last}, 0);
    system.instances.push_back(std::move(added));
    made.instanceAt[path] = id;
    made.processes.push_back(&process);
    std::set<std::string> assigned;
    for (const auto& from : process.transitions) rootsAssigned(from.statement, assigned);
    made.scopes.push_back(bind(process.parameters, assigned, instance, name, outer));
    const PortNames names = bound(process.ports, instance, ports);
    Branch branch{.instance = id};
    auto& formal = made.portsOf.emplace_back();
    for (const auto& port : process.ports) formal.push_back(names.at(port.name));
    branch.ports.insert(formal.begin(), formal.end());
    Scope& scope = made.scopes.back();
    for (const auto& variable : process.variables)
      declare(variable, name + "." + variable.name, scope);
    if (process.init) InitRunner(expressions, scope, system).run(*process.init, &process, id);
    return branch;
  }

  /// \param assigned parameters that need variables of their own
  Scope bind(const std::vector<fiacre::Parameter>& parameters,
             const std::set<std::string>& assigned, const fiacre::Instance& instance,
             const std::string& name, const Scope& outer) {
    if (parameters.size() != instance.arguments.size())
      unsupported("`" + instance.process + "` gets the wrong number of arguments");
    Scope scope;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      types.checkLimits(); // each instance has a copy of what it refers to
      const auto& parameter = parameters[i];
      const Type& type = types.resolve(parameter.type);
      Value argument = expressions.value(instance.arguments[i], outer, &type);
      if (!parameter.reference) {
        if (assigned.contains(parameter.name))
          allocate(type, name + "." + parameter.name, argument);
        else
          for (auto& part : argument.parts)
            part = expressions.nodes().number(firstValue(system, part));
      }
      argument.type = &type;
      scope[parameter.name] = std::move(argument);
    }
    return scope;
  }

  const fiacre::Program& program;
  const Types& types;
  Expressions& expressions;
  System& system;
  Elaboration made;
  std::map<std::string, int> counts;
};

} // namespace

ModelPath pathOf(const fiacre::Program& program, const fiacre::Observable& observable) {
  if (observable.observer.empty()) return observable.path;
  const auto found =
      std::ranges::find(program.observers, observable.observer, &fiacre::Attachment::observer);
  if (found == program.observers.end())
    unsupported("`" + observable.observer + "` observes nothing");
  ModelPath path{0, static_cast<std::uint32_t>(found - program.observers.begin()) + 1};
  path.insert(path.end(), observable.path.begin(), observable.path.end());
  return path;
}

Elaboration elaborate(const fiacre::Program& program, const Types& types, Expressions& expressions,
                      System& system) {
  return Elaborator(program, types, expressions, system).run();
}

} // namespace proskill::verify
