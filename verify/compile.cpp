#include "verify/compile.h"

#include "verify/clocks.h"
#include "verify/observe.h"
#include "verify/paths.h"
#include "verify/unsupported.h"
#include "verify/watch.h"

#include <algorithm>

namespace proskill::verify {

namespace {

constexpr std::size_t kMostTransitions = 1'000'000;

/// Whether some number lies in it; an empty interval would stop time for ever.
void requireSound(const fiacre::Interval& interval, fiacre::OriginId origin) {
  constexpr std::int64_t kLargest = 100'000'000;
  bool empty = interval.upper &&
               (*interval.upper < interval.lower ||
                (*interval.upper == interval.lower && (interval.lowerOpen || interval.upperOpen)));
  if (interval.lower < 0 || empty) unsupported("an empty interval", origin);
  if (std::max(interval.lower, interval.upper.value_or(0)) > kLargest)
    unsupported("a bound of time beyond 10^8 units", origin);
}

/// What the code of a path reads and writes, and whether it may fail.
void summarise(const System& system, Path& path) {
  addReads(system, path.guard, path.guardReads);
  path.guardReads.insert(system.instances[path.instance].location);
  path.mayFail = mayFail(system, path.guard);
  const auto reads = [&](NodeId node) {
    addReads(system, node, path.reads);
    path.mayFail = path.mayFail || mayFail(system, node);
  };
  for (const auto& instruction : path.code)
    if (instruction.kind == InstructionKind::On || instruction.kind == InstructionKind::JumpUnless)
      reads(instruction.node);
  for (const auto& assignment : path.assignments) {
    reads(assignment.value);
    path.writes.insert(assignment.target);
    path.mayFail = path.mayFail || assignment.checked;
  }
  if (path.tentative) path.guardReads |= path.reads;
}

class Assembler {
public:
  Assembler(const fiacre::Program& of, const Elaboration& from, Expressions& in,
            const Events& known, System& to)
      : program(of), model(from), expressions(in), events(known), system(to) {}

  void run() {
    for (std::uint32_t port = 0; port < system.ports.size(); ++port) {
      const auto& interval = model.component->ports[port].interval;
      if (interval) requireSound(*interval, 0);
      timed.push_back(interval && isClocked(*interval));
    }
    for (InstanceId i = 0; i < system.instances.size(); ++i) addPaths(i);
    for (PathId i = 0; i < system.paths.size(); ++i)
      if (system.paths[i].port == kNone) addTransition({i});
    for (std::uint32_t port = 0; port < system.ports.size(); ++port) synchronise(port);
  }

private:
  void addPaths(InstanceId id) {
    const auto& process = *model.processes[id];
    PathContext context{.instance = id,
                        .process = &process,
                        .location = system.instances[id].location,
                        .scope = &model.scopes[id],
                        .ports = {},
                        .portIsTimed = timed,
                        .tag = [this, id](const auto& name) { return events.askedTag(id, name); },
                        .entering = [this, id](auto at) { return events.askedEntering(id, at); }};
    for (std::size_t i = 0; i < process.ports.size(); ++i)
      context.ports[process.ports[i].name] = model.portsOf[id][i];
    for (const auto& from : process.transitions) {
      auto state = std::ranges::find(process.states, from.state, &fiacre::State::name);
      if (state == process.states.end())
        unsupported("`from " + from.state + "` is no state of `" + process.name + "`");
      auto location = static_cast<std::uint32_t>(state - process.states.begin());
      for (auto& path : pathsOf(from, location, context, expressions)) {
        if (path.wait) requireSound(*path.wait, path.origin);
        summarise(system, path);
        system.paths.push_back(std::move(path));
      }
    }
  }

  void addTransition(std::vector<PathId> parts) {
    if (system.transitions.size() >= kMostTransitions) unsupported("too many synchronisations");
    auto& nodes = expressions.nodes();
    Transition made;
    made.guard = nodes.number(1);
    for (auto id : parts) {
      const Path& path = system.paths[id];
      const Instance& instance = system.instances[path.instance];
      NodeId here = nodes.equal(nodes.cell(instance.location), nodes.number(path.location));
      made.guard = nodes.both(made.guard, nodes.both(here, path.guard));
      made.tentative = made.tentative || path.tentative;
      if (!path.loops) made.consumed.insert(path.instance);
      if (made.writes.meets(path.writes))
        unsupported("two parts of a synchronisation write the same variable", path.origin);
      made.apart = made.apart || made.writes.meets(path.reads) || path.writes.meets(made.reads);
      made.guardReads |= path.guardReads;
      made.reads |= path.reads;
      made.writes |= path.writes;
    }
    const Path& first = system.paths[parts[0]];
    made.port = first.port;
    if (made.port != kNone) {
      made.interval = model.component->ports[made.port].interval.value_or(fiacre::Interval{});
      made.event = events.askedPort(made.port);
    } else if (first.wait) {
      made.interval = *first.wait;
    }
    made.urgent = isImmediate(made.interval);
    made.parts = std::move(parts);
    system.transitions.push_back(std::move(made));
  }

  /// One transition for each choice of a path of every instance that has the port.
  void synchronise(std::uint32_t port) {
    std::vector<std::vector<PathId>> choices{{}};
    for (auto member : model.members[port]) {
      std::vector<std::vector<PathId>> longer;
      for (const auto& choice : choices) {
        for (PathId i = 0; i < system.paths.size(); ++i) {
          if (system.paths[i].instance != member || system.paths[i].port != port) continue;
          longer.push_back(choice);
          longer.back().push_back(i);
        }
      }
      if (longer.size() > kMostTransitions) unsupported("too many synchronisations");
      choices = std::move(longer);
    }
    if (model.members[port].empty()) return;
    for (auto& choice : choices) addTransition(std::move(choice));
  }

  const fiacre::Program& program;
  const Elaboration& model;
  Expressions& expressions;
  const Events& events;
  System& system;
  std::vector<bool> timed;
};

} // namespace

std::expected<Compiled, Unsupported> compile(const fiacre::Program& program,
                                             const fiacre::Provenance& provenance,
                                             const std::vector<Question>& questions) {
  try {
    Compiled made;
    Types types(program);
    Expressions expressions(program, types, made.system);
    Elaboration model = elaborate(program, types, expressions, made.system);
    Events events(made.system);
    Observer observer(model, expressions, events, made.system);
    for (auto question : questions)
      made.goals.push_back(observer.goal(program.properties.at(question.property)));
    Assembler(program, model, expressions, events, made.system).run();
    assignClocks(made.system);
    watch(provenance, model, types, made.system);
    return made;
  } catch (const CompileError& error) {
    return std::unexpected(error.why);
  }
}

} // namespace proskill::verify
