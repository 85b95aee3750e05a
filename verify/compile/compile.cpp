#include "verify/compile/compile.h"

#include "verify/compile/observe.h"
#include "verify/compile/paths.h"
#include "verify/compile/priorities.h"
#include "verify/compile/watch.h"
#include "verify/model/clocks.h"
#include "verify/model/path_events.h"
#include "verify/model/path_summary.h"
#include "verify/model/place_counts.h"
#include "verify/model/value_bounds.h"
#include "verify/unsupported.h"

#include <algorithm>
#include <set>
#include <utility>

namespace proskill::verify {

namespace {

/// Limit, since tables have an entry for each pair of transitions.
constexpr std::size_t kMostTransitions = 30'000;

/// Throws if an interval is empty, which would stop time for ever.
void requireSound(const fiacre::Interval& interval, fiacre::OriginId origin) {
  constexpr std::int64_t kLargest = 100'000'000;
  bool empty = interval.upper &&
               (*interval.upper < interval.lower ||
                (*interval.upper == interval.lower && (interval.lowerOpen || interval.upperOpen)));
  if (interval.lower < 0 || empty) unsupported("an empty interval", origin);
  if (std::max(interval.lower, interval.upper.value_or(0)) > kLargest)
    unsupported("a bound of time beyond 10^8 units", origin);
}

/// By port: the condition of its probe, if it has one.
using Probes = std::vector<std::optional<NodeId>>;

class Assembler {
public:
  Assembler(const Elaboration& from, Probes watched, const Types& all, Expressions& in,
            const Events& known, System& to)
      : model(from),
        probes(std::move(watched)),
        types(all),
        expressions(in),
        events(known),
        system(to) {}

  void run() {
    for (const auto& interval : model.intervals) {
      if (interval) requireSound(*interval, 0);
      timed.push_back(interval && isClocked(*interval));
    }
    for (InstanceId i = 0; i < system.instances.size(); ++i) addPaths(i);
    const auto written = static_cast<PathId>(system.paths.size());
    for (PathId i = 0; i < written; ++i)
      if (system.paths[i].port == kNone) addTransition({i});
    std::vector<std::pair<std::uint32_t, std::vector<std::vector<PathId>>>> watching;
    for (std::uint32_t port = 0; port < system.ports.size(); ++port) {
      pathsWith.assign(system.instances.size(), {});
      for (PathId i = 0; i < written; ++i)
        if (system.paths[i].port == port) pathsWith[system.paths[i].instance].push_back(i);
      auto choices = synchronised(model.composition, port);
      if (isOfSteps(port))
        watching.emplace_back(port, std::move(choices));
      else
        for (auto& parts : choices) join(std::move(parts), probes[port]);
    }
    addPriorities(model, system);
    for (const auto& [port, choices] : watching) addSeen(port, choices);
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
        unsupported("`from " + from.state + "` is not a state of `" + process.name + "`");
      auto location = static_cast<std::uint32_t>(state - process.states.begin());
      types.checkLimits();
      auto all = pathsOf(from, location, context, expressions);
      addErrors(all);
      for (auto& path : all) {
        if (path.wait) requireSound(*path.wait, path.origin);
        summarisePath(system, path);
        system.paths.push_back(std::move(path));
      }
    }
  }

  /// Adds a failing path for each guard that may fail.
  void addErrors(std::vector<Path>& paths) {
    std::vector<Path> errors;
    for (const auto& path : paths)
      for (const auto& risk : path.risks) {
        if (std::ranges::find(errors, risk.node, &Path::guard) != errors.end()) continue;
        Path& made = errors.emplace_back();
        made.instance = path.instance;
        made.location = path.location;
        made.guard = risk.node;
        made.wait = fiacre::Interval{.lower = 0, .upper = 0};
        made.origin = risk.origin;
        if (risk.origin != 0)
          made.code.push_back({.kind = InstructionKind::Origin, .first = risk.origin});
        made.code.push_back({.kind = InstructionKind::Fail, .node = risk.value});
        made.fails = true;
      }
    std::ranges::move(errors, std::back_inserter(paths));
  }

  [[nodiscard]] bool isOfSteps(std::uint32_t port) const {
    return probes[port] && fiacre::watchesSteps(*model.probes[port]);
  }

  /// Adds the variants of a step with its observers; they have priority over the step without.
  void addSeen(std::uint32_t port, const std::vector<std::vector<PathId>>& choices) {
    const auto most = static_cast<TransitionId>(system.transitions.size());
    for (TransitionId i = 0; i < most; ++i)
      for (const auto& parts : choices)
        if (mayBeSeen(system.transitions[i], port, parts)) addSeen(i, port, parts);
  }

  [[nodiscard]] bool mayBeSeen(const Transition& step, std::uint32_t port,
                               const std::vector<PathId>& parts) {
    types.checkLimits();
    if (step.fails || observes(model, system, step)) return false;
    std::set<InstanceId> moving;
    for (auto id : step.parts) moving.insert(system.paths[id].instance);
    if (std::ranges::any_of(parts,
                            [&](PathId id) { return moving.contains(system.paths[id].instance); }))
      return false;
    Bits happening = eventsOf(system, step.parts);
    happening |= eventsOf(system, parts);
    for (auto event : step.events) happening.insert(event);
    if (const auto event = events.askedPort(port); event != kNone) happening.insert(event);
    auto& nodes = expressions.nodes();
    const NodeId seen = nodes.substitute(*probes[port], [&](const Node& leaf) {
      const bool never = leaf.op == NodeOp::Happens && !happening.contains(leaf.a);
      return never ? std::optional(nodes.number(0)) : std::nullopt;
    });
    return nodes.constant(seen) != 0;
  }

  void addSeen(TransitionId step, std::uint32_t port, const std::vector<PathId>& watchers) {
    const Transition base = system.transitions[step];
    auto parts = base.parts;
    parts.insert(parts.end(), watchers.begin(), watchers.end());
    for (auto id : watchers)
      if (system.paths[id].receives || !system.paths[id].sent.empty())
        unsupported("a probe of steps that carries values", system.paths[id].origin);
    addTransition(std::move(parts), base.guard);
    const auto id = static_cast<TransitionId>(system.transitions.size() - 1);
    Transition& made = system.transitions[id];
    made.events = base.events;
    if (const auto event = events.askedPort(port); event != kNone) made.events.push_back(event);
    made.seen = base.seen;
    made.seen.push_back(*probes[port]);
    made.tentative = true;
    made.unseen = base.unseen == kNone ? step : base.unseen;
    addReads(system, *probes[port], made.guardReads);
    made.guardReads |= made.reads; // what the step does determines whether it is observed
    std::ranges::copy_if(base.blockers, std::back_inserter(made.blockers), [&](TransitionId other) {
      return system.transitions[other].unseen == kNone;
    });
    made.laterBlockers = base.laterBlockers;
    putBeforeFewer(id);
  }

  /// Gives the step priority over the same step with fewer observers, since an observer that can
  /// take part does.
  void putBeforeFewer(TransitionId id) {
    const auto& made = system.transitions[id];
    const std::set<PathId> all(made.parts.begin(), made.parts.end());
    for (TransitionId i = made.unseen; i < id; ++i) {
      auto& other = system.transitions[i];
      const bool same = i == made.unseen || other.unseen == made.unseen;
      if (same && std::ranges::all_of(other.parts, [&](PathId part) { return all.contains(part); }))
        other.blockers.push_back(id);
    }
  }

  void addTransition(std::vector<PathId> parts, std::optional<NodeId> agree = {}) {
    if (system.transitions.size() >= kMostTransitions)
      unsupported("too many steps: more than 30000");
    types.checkLimits();
    auto& nodes = expressions.nodes();
    Transition made;
    made.guard = agree.value_or(nodes.number(1));
    addReads(system, made.guard, made.guardReads);
    for (auto id : parts) {
      const Path& path = system.paths[id];
      const Instance& instance = system.instances[path.instance];
      NodeId here = nodes.equal(nodes.cell(instance.location), nodes.number(path.location));
      made.guard = nodes.both(made.guard, nodes.both(here, path.guard));
      made.tentative = made.tentative || path.tentative;
      made.fails = made.fails || path.fails;
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
      made.interval = model.intervals[made.port].value_or(fiacre::Interval{});
      if (const auto event = events.askedPort(made.port); event != kNone)
        made.events.push_back(event);
    } else if (first.wait) {
      made.interval = *first.wait;
    }
    made.urgent = isImmediate(made.interval);
    made.parts = std::move(parts);
    system.transitions.push_back(std::move(made));
  }

  /// All combinations of paths that synchronise on a port: one path of each part that synchronises
  /// with the others, or those of a single part that does not.
  std::vector<std::vector<PathId>> synchronised(const Branch& branch, std::uint32_t port) const {
    std::vector<std::vector<PathId>> together{{}};
    std::vector<std::vector<PathId>> all;
    if (branch.instance != kNone) {
      for (auto path : pathsWith[branch.instance]) all.push_back({path});
      return all;
    }
    bool some = false;
    for (const auto& child : branch.children) {
      if (!child.ports.contains(port)) continue;
      auto choices = synchronised(child, port);
      if (!child.waitsOn(port)) {
        std::ranges::move(choices, std::back_inserter(all));
        continue;
      }
      some = true;
      if (together.size() * choices.size() > kMostTransitions)
        unsupported("too many synchronisations on `" + system.ports[port] + "`");
      std::vector<std::vector<PathId>> longer;
      for (const auto& before : together)
        for (const auto& choice : choices) {
          types.checkLimits();
          longer.push_back(before);
          longer.back().insert(longer.back().end(), choice.begin(), choice.end());
        }
      together = std::move(longer);
    }
    if (some) std::ranges::move(together, std::back_inserter(all));
    return all;
  }

  /// Joins paths on a port, if the condition of its probe is true. The values that one part sends
  /// are received by the others, so a receiver becomes a separate path for each sender.
  void join(std::vector<PathId> parts, std::optional<NodeId> probe) {
    const std::vector<NodeId>* sent = nullptr;
    NodeId agree = probe.value_or(expressions.nodes().number(1));
    bool receives = false;
    for (auto id : parts) {
      const Path& path = system.paths[id];
      receives = receives || path.receives;
      if (path.sent.empty()) continue;
      if (!sent) {
        sent = &path.sent;
        continue;
      }
      if (sent->size() != path.sent.size()) return; // the types differ, so they do not synchronise
      for (std::size_t i = 0; i < sent->size(); ++i)
        agree = expressions.nodes().both(agree, same((*sent)[i], path.sent[i]));
    }
    if (expressions.nodes().constant(agree) == 0) return; // two values that are never equal
    Bits compared;
    addReads(system, agree, compared);
    for (auto id : parts) system.paths[id].guardReads |= compared;
    if (!receives) return addTransition(std::move(parts), agree);
    if (!sent) return; // no part sends
    const std::vector<NodeId> values = *sent;
    for (auto& id : parts)
      if (system.paths[id].receives) id = received(system.paths[id], values);
    addTransition(std::move(parts), agree);
  }

  /// Whether two parts send the same value. If one has no value, the step is taken and fails.
  NodeId same(NodeId a, NodeId b) {
    auto& nodes = expressions.nodes();
    const NodeId equal = nodes.equal(a, b);
    if (!expressions.mayFail(equal)) return equal;
    return nodes.binary(NodeOp::Or, nodes.unary(NodeOp::Fails, equal), equal);
  }

  PathId received(Path path, const std::vector<NodeId>& values) {
    path.receives = false;
    for (auto& assignment : path.assignments) {
      assignment.value = expressions.nodes().substitute(assignment.value, [&](const Node& leaf) {
        return leaf.op == NodeOp::Received ? std::optional(values.at(leaf.a)) : std::nullopt;
      });
      const Cell& cell = system.cells[assignment.target];
      const auto bounds = valueBounds(system, assignment.value);
      assignment.checked = assignment.checked || bounds.low < cell.low || bounds.high > cell.high;
    }
    summarisePath(system, path);
    system.paths.push_back(std::move(path));
    return static_cast<PathId>(system.paths.size() - 1);
  }

  const Elaboration& model;
  Probes probes;
  const Types& types;
  Expressions& expressions;
  const Events& events;
  System& system;
  std::vector<bool> timed;
  std::vector<std::vector<PathId>> pathsWith; ///< by instance: paths with the current port
};

} // namespace

std::expected<Compiled, Unsupported> compile(const fiacre::Program& program,
                                             const fiacre::Provenance& provenance,
                                             const std::vector<Question>& questions,
                                             LimitWatch* limits) {
  try {
    Compiled made;
    Types types(program, limits);
    Expressions expressions(program, types, made.system);
    Elaboration model = elaborate(program, types, expressions, made.system);
    Events events(made.system);
    Observer observer(program, model, expressions, events, made.system);
    for (const auto& question : questions) {
      Goal& goal = made.goals.emplace_back(observer.goal(program.properties.at(question.property)));
      goal.monitor.fair = question.fair && goal.monitor.looksForCycles();
      goal.monitor.exempt = question.exempt;
      goal.monitor.rests = question.rests && goal.monitor.looksForCycles();
    }
    Probes probes;
    for (const auto* probe : model.probes) {
      probes.push_back(probe ? std::optional(observer.node(*probe)) : std::nullopt);
      made.system.hasPriorities = made.system.hasPriorities || probe;
    }
    Assembler(model, std::move(probes), types, expressions, events, made.system).run();
    dropNeedlessChecks(made.system, [&] { types.checkLimits(); });
    assignClocks(made.system);
    watch(provenance, model, types, made.system);
    addGrounds(provenance, model, expressions, made.system);
    return made;
  } catch (const CompileError& error) {
    return std::unexpected(error.why);
  }
}

} // namespace proskill::verify
