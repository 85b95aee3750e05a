#include "tests/support/oracle/interpreter.h"

#include "tests/support/oracle/judge.h"
#include "tests/support/oracle/path_walk.h"

#include <algorithm>
#include <set>

namespace proskill::oracle {

using fiacre::Interval;
using fiacre::Type;
using fiacre::TypeKind;

namespace {

template <class Item> const Item* findNamed(const std::vector<Item>& items, std::string_view name) {
  auto found = std::ranges::find(items, name, &Item::name);
  return found == items.end() ? nullptr : &*found;
}

/// `skill[takeoff].status`: a name, then indices and fields
fiacre::Expr parseLvalue(std::string_view text) {
  std::size_t end = text.find_first_of("[].");
  fiacre::Expr expr{.kind = fiacre::ExprKind::Name, .name = std::string(text.substr(0, end))};
  while (end < text.size()) {
    bool field = text[end] == '.';
    std::size_t begin = end + 1;
    end = std::min(text.find_first_of("[].", begin), text.size());
    std::string word(text.substr(begin, end - begin));
    if (!field) ++end;
    fiacre::Expr whole = std::move(expr);
    if (field) {
      expr = {.kind = fiacre::ExprKind::Field, .name = word, .operands = {whole}};
      continue;
    }
    bool digits = word.find_first_not_of("0123456789") == std::string::npos;
    fiacre::Expr at =
        digits ? fiacre::Expr{.kind = fiacre::ExprKind::Number, .number = std::stoll(word)}
               : fiacre::Expr{.kind = fiacre::ExprKind::Name, .name = word};
    expr = {.kind = fiacre::ExprKind::Index, .operands = {whole, at}};
  }
  return expr;
}

std::uint64_t code(const Interval& interval) {
  auto upper = interval.upper ? *interval.upper + 1 : 0;
  return (static_cast<std::uint64_t>(interval.lower) << 33) +
         (static_cast<std::uint64_t>(upper) << 2) + (interval.lowerOpen ? 2 : 0) +
         (interval.upperOpen ? 1 : 0);
}

} // namespace

const Type& resolveType(const Interpreter& model, const Type& type) { return model.resolve(type); }

Interpreter::Interpreter(const fiacre::Program& of, Reading how) : program(of), reading(how) {
  for (const auto& type : program.types) types[type.name] = &type;
  for (const auto& constant : program.constants) constants[constant.name] = &constant;
  for (const auto& function : program.functions) functions[function.name] = &function;
  const auto& main = componentNamed(program.main);
  countInstances(main.instances);
  for (const auto& each : program.observers)
    countInstances(componentNamed(each.observer).instances);
  first.assign(elaborated.size(), 0);
  elaborated.clear();
  elaborate(main, {}, {}, {});
  firstObserver = elaborated.size();
  for (std::uint32_t k = 1; k <= program.observers.size(); ++k)
    elaborate(componentNamed(program.observers[k - 1].observer), {0, k}, {}, {});
  for (bool more = true; more;) { // priority is transitive
    const auto said = priorities;
    for (const auto& [high, middle] : said)
      for (const auto& [other, low] : said)
        if (middle == other) priorities.insert({high, low});
    more = priorities.size() > said.size();
  }
  for (std::size_t i = 0; i < elaborated.size(); ++i) start(i);
}

const Type& Interpreter::resolve(const Type& type) const {
  if (type.kind != TypeKind::Named) return type;
  auto found = types.find(type.name);
  if (found == types.end()) throw ModelError("unknown type " + type.name);
  return resolve(found->second->type);
}

const fiacre::Component& Interpreter::componentNamed(const std::string& name) const {
  const auto* found = findNamed(program.components, name);
  if (!found) throw ModelError("no component " + name);
  return *found;
}

// The states of all instances precede the variables, so their number has to be known first.
void Interpreter::countInstances(const std::vector<fiacre::Instance>& parts) {
  for (const auto& part : parts) {
    if (!part.parts.empty())
      countInstances(part.parts);
    else if (const auto* inner = findNamed(program.components, part.process))
      countInstances(inner->instances);
    else
      elaborated.emplace_back();
  }
}

std::vector<std::uint32_t> Interpreter::pathOf(const fiacre::Observable& observable) const {
  std::vector<std::uint32_t> path;
  for (std::uint32_t k = 1; k <= program.observers.size(); ++k)
    if (program.observers[k - 1].observer == observable.observer) path = {0, k};
  path.insert(path.end(), observable.path.begin(), observable.path.end());
  return path;
}

void Interpreter::elaborate(const fiacre::Component& component, std::vector<std::uint32_t> path,
                            Scope scope, PortMap ports) {
  declare(component.variables, scope);
  auto addPort = [&](const fiacre::Port& port) {
    if (ports.contains(port.name)) return;
    ports[port.name] = slots.size();
    slots.push_back({port.name, path, &port});
  };
  std::ranges::for_each(component.interfacePorts, addPort);
  std::ranges::for_each(component.ports, addPort);
  for (const auto& priority : component.priorities)
    for (const auto& high : priority.higher)
      for (const auto& low : priority.lower) priorities.insert({ports.at(high), ports.at(low)});
  componentScopes[path] = scope;
  addParts(component.instances, path, scope, ports);
}

// Sets of ports are not known here: all wait for all.
void Interpreter::addParts(const std::vector<fiacre::Instance>& parts,
                           const std::vector<std::uint32_t>& path, const Scope& scope,
                           const PortMap& ports) {
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const auto& instance = parts[i];
    auto innerPath = path;
    innerPath.push_back(i + 1);
    if (!instance.parts.empty()) {
      addParts(instance.parts, innerPath, scope, ports);
      continue;
    }
    if (const auto* process = findNamed(program.processes, instance.process)) {
      addInstance(*process, instance, std::move(innerPath), scope, ports);
      continue;
    }
    const auto* inner = findNamed(program.components, instance.process);
    if (!inner) throw ModelError("unknown process " + instance.process);
    Scope innerScope;
    bindParameters(inner->parameters, instance, scope, innerScope);
    elaborate(*inner, std::move(innerPath), std::move(innerScope),
              bindPorts(inner->interfacePorts, instance, ports));
  }
}

PortMap Interpreter::bindPorts(const std::vector<fiacre::Port>& formal,
                               const fiacre::Instance& instance, const PortMap& outer) {
  PortMap bound;
  for (std::size_t i = 0; i < formal.size(); ++i)
    bound[formal[i].name] = outer.at(instance.ports.at(i));
  return bound;
}

void Interpreter::addInstance(const fiacre::Process& process, const fiacre::Instance& instance,
                              std::vector<std::uint32_t> path, const Scope& outer,
                              const PortMap& outerPorts) {
  Instance added{&process, std::move(path), {}, bindPorts(process.ports, instance, outerPorts)};
  bindParameters(process.parameters, instance, outer, added.scope);
  declare(process.variables, added.scope);
  elaborated.push_back(std::move(added));
}

void Interpreter::bindParameters(const std::vector<fiacre::Parameter>& parameters,
                                 const fiacre::Instance& instance, const Scope& outer,
                                 Scope& scope) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto& parameter = parameters[i];
    const auto& argument = instance.arguments.at(i);
    if (parameter.reference) {
      scope[parameter.name] = outer.at(argument.name);
      continue;
    }
    scope[parameter.name] = allocate(parameter.type);
    Evaluation evaluation(*this, first, outer);
    Store value = evaluation.value(argument, &parameter.type);
    evaluation.assign(scope[parameter.name], value);
  }
}

void Interpreter::declare(const std::vector<fiacre::Variable>& variables, Scope& scope) {
  for (const auto& variable : variables) {
    scope[variable.name] = allocate(variable.type);
    if (!variable.init) continue;
    Evaluation evaluation(*this, first, scope);
    Store value = evaluation.value(*variable.init, &variable.type);
    evaluation.assign(scope[variable.name], value);
  }
}

Place Interpreter::allocate(const Type& type) {
  Place place{first.size(), &type};
  Store value = defaultValue(*this, type);
  first.insert(first.end(), value.begin(), value.end());
  return place;
}

void Interpreter::start(std::size_t instance) {
  const auto& init = elaborated[instance].process->init;
  if (!init) return;
  auto paths = PathWalk(*this, instance).from(*init, first);
  if (paths.size() != 1) throw ModelError("an initial statement with a choice");
  first = paths[0].store;
  if (paths[0].target) first[instance] = static_cast<std::int64_t>(*paths[0].target);
}

std::vector<Path> Interpreter::paths(std::size_t instance, const Store& store) const {
  const auto& process = *elaborated[instance].process;
  const auto& state = stateName(instance, store);
  auto from = std::ranges::find(process.transitions, state, &fiacre::From::state);
  if (from == process.transitions.end()) return {};
  auto all = PathWalk(*this, instance).from(from->statement, store);
  for (const auto& path : all)
    if (!path.target) throw ModelError("a path without an end from " + state);
  return all;
}

const std::vector<Firing>& Interpreter::firings(const Store& store) const {
  const auto found = known.find(store);
  return found != known.end() ? found->second
                              : known.emplace(store, computeFirings(store)).first->second;
}

std::vector<Firing> Interpreter::computeFirings(const Store& store) const {
  std::vector<Firing> result;
  std::vector<std::vector<Path>> all;
  for (std::size_t i = 0; i < elaborated.size(); ++i) {
    all.push_back(paths(i, store));
    for (const auto& path : all.back())
      if (!path.port) result.push_back(combine(std::vector{&path}, store));
  }
  const auto ofSteps = [&](std::size_t port) {
    return slots[port].port->probe && watchesSteps(*slots[port].port->probe);
  };
  for (std::size_t port = 0; port < slots.size(); ++port)
    if (!ofSteps(port) && isProbed(port, store)) synchronise(port, all, store, result);
  for (std::size_t port = 0; port < slots.size(); ++port)
    if (ofSteps(port)) watch(port, all, store, result);
  return result;
}

bool Interpreter::isProbed(std::size_t port, const Store& store) const {
  const auto& probe = slots[port].port->probe;
  return !probe || observed(*this, *probe, {&store, nullptr});
}

bool Interpreter::observes(const Firing& firing) const {
  return firing.participants.front() >= firstObserver;
}

// An observed step is taken with the observers that can take part, and not without them.
void Interpreter::watch(std::size_t port, const std::vector<std::vector<Path>>& all,
                        const Store& store, std::vector<Firing>& result) const {
  std::vector<Firing> made;
  for (const auto& firing : result) {
    bool watched = false;
    const bool seen =
        !observes(firing) && observed(*this, *slots[port].port->probe, {&store, &firing});
    for (const auto& parts : seen ? choices(port, all) : std::vector<std::vector<const Path*>>{}) {
      const Firing own = combine(parts, store);
      std::vector<std::size_t> both;
      std::ranges::set_intersection(own.participants, firing.participants,
                                    std::back_inserter(both));
      if (!both.empty()) continue;
      watched = true;
      Firing& with = made.emplace_back(firing);
      with.watchers.push_back(port);
      with.participants.insert(with.participants.end(), own.participants.begin(),
                               own.participants.end());
      std::ranges::sort(with.participants);
      with.movers.insert(with.movers.end(), own.movers.begin(), own.movers.end());
      with.tags.insert(with.tags.end(), own.tags.begin(), own.tags.end());
      with.origins.insert(with.origins.end(), own.origins.begin(), own.origins.end());
      for (std::size_t i = 0; i < store.size(); ++i)
        if (own.after[i] != store[i]) with.after[i] = own.after[i];
    }
    if (!watched) made.push_back(firing);
  }
  result = std::move(made);
}

void Interpreter::synchronise(std::size_t port, const std::vector<std::vector<Path>>& all,
                              const Store& store, std::vector<Firing>& result) const {
  const auto takes = [](const Path* part) { return part->takes; };
  for (const auto& parts : choices(port, all)) // a value that nobody sends cannot be received
    if (!std::ranges::all_of(parts, takes)) result.push_back(combine(parts, store));
}

// Every instance with the port takes part: the product of their paths with it.
std::vector<std::vector<const Path*>>
Interpreter::choices(std::size_t port, const std::vector<std::vector<Path>>& all) const {
  std::vector<std::vector<const Path*>> together{{}};
  for (std::size_t i = 0; i < elaborated.size(); ++i) {
    bool given = std::ranges::any_of(elaborated[i].ports,
                                     [&](const auto& entry) { return entry.second == port; });
    if (!given) continue;
    std::vector<std::vector<const Path*>> longer;
    for (const auto& parts : together)
      for (const auto& path : all[i]) {
        if (path.port != port) continue;
        if (!parts.empty() && parts.front()->message != path.message) continue;
        longer.push_back(parts);
        longer.back().push_back(&path);
      }
    together = std::move(longer);
  }
  // A port without any instance passes nothing.
  std::erase_if(together, [](const auto& parts) { return parts.empty(); });
  return together;
}

bool Interpreter::goesBefore(const Firing& high, const Firing& low) const {
  if (observes(high) && !observes(low)) return true;
  if (high.port && low.port) return priorities.contains({*high.port, *low.port});
  // observers come last
  return high.rank && low.rank && high.participants.front() == low.participants.front() &&
         high.rank->first == low.rank->first && high.rank->second > low.rank->second;
}

Firing Interpreter::combine(std::span<const Path* const> parts, const Store& store) const {
  Firing firing;
  firing.clock = clockOf(parts);
  firing.interval = parts.front()->wait.value_or(Interval{});
  firing.port = parts.front()->port;
  if (firing.port) firing.interval = slots[*firing.port].port->interval.value_or(Interval{});
  if (!firing.port) firing.rank = parts.front()->rank;
  firing.after = store;
  std::set<std::size_t> written;
  for (const Path* part : parts) {
    firing.participants.push_back(part->instance);
    if (!part->loops) firing.movers.push_back(part->instance);
    for (const auto& tag : part->tags) firing.tags.emplace_back(part->instance, tag);
    firing.origins.insert(firing.origins.end(), part->origins.begin(), part->origins.end());
    for (std::size_t i = 0; i < store.size(); ++i) {
      if (part->store[i] == store[i]) continue;
      if (!written.insert(i).second) throw ModelError("two parts of a step write one variable");
      firing.after[i] = part->store[i];
    }
    firing.after[part->instance] = static_cast<std::int64_t>(*part->target);
  }
  return firing;
}

ClockId Interpreter::clockOf(std::span<const Path* const> parts) const {
  std::vector<std::uint64_t> key;
  std::vector<std::size_t> who;
  for (const Path* part : parts) {
    who.push_back(part->instance);
    key.insert(key.end(), {part->instance, static_cast<std::uint64_t>(part->store[part->instance]),
                           *part->target, part->loops ? 1U : 0U, part->port ? *part->port + 1 : 0,
                           part->wait ? code(*part->wait) + 1 : 0, part->choices.size(),
                           part->branches.size()});
    for (auto choice : part->choices) key.push_back(static_cast<std::uint64_t>(choice));
    for (const auto* branch : part->branches)
      key.push_back(reinterpret_cast<std::uint64_t>(branch));
  }
  auto [entry, added] = clockNumbers.try_emplace(std::move(key), clockParticipants.size());
  if (added) clockParticipants.push_back(std::move(who));
  return entry->second;
}

const std::vector<std::size_t>& Interpreter::participants(ClockId clock) const {
  return clockParticipants.at(clock);
}

const std::string& Interpreter::stateName(std::size_t instance, const Store& store) const {
  return elaborated[instance].process->states[static_cast<std::size_t>(store[instance])].name;
}

std::string Interpreter::show(const std::string& lvalue, const Store& store) const {
  auto found = shown.find(lvalue);
  if (found == shown.end()) {
    Store copy = store;
    Evaluation evaluation(*this, copy, componentScopes.at({}));
    found = shown.emplace(lvalue, evaluation.place(parseLvalue(lvalue)).value()).first;
  }
  return textOf(*this, found->second, store);
}

bool Interpreter::holds(const std::vector<std::uint32_t>& path, const fiacre::Expr& expression,
                        const Store& store) const {
  Store copy = store;
  auto instance = std::ranges::find(elaborated, path, &Instance::path);
  const Scope& scope = instance != elaborated.end() ? instance->scope : componentScopes.at(path);
  return Evaluation(*this, copy, scope).truth(expression);
}

} // namespace proskill::oracle
