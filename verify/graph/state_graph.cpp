#include "verify/graph/class_graph.h"

#include "verify/compile/compile.h"
#include "verify/graph/spilled_classes.h"
#include "verify/limits.h"
#include "verify/state/state_layout.h"

#include <algorithm>

namespace proskill::verify {

namespace {

/// The system in which every step may wait and none has to happen.
System untimed(System system) {
  for (auto& transition : system.transitions) {
    transition.interval = {};
    transition.urgent = false;
    transition.clock = kNone;
    transition.blocksLater = false;
    auto& blockers = transition.blockers;
    blockers.insert(blockers.end(), transition.laterBlockers.begin(),
                    transition.laterBlockers.end());
    transition.laterBlockers.clear();
  }
  return system;
}

/// State classes contain how long each step may still wait, not since when it has been waiting. So
/// they do not show whether a step with priority has waited long enough. \return why there are no
/// classes
std::optional<Unsupported> withoutClasses(const System& system) {
  const auto late = std::ranges::find_if(system.transitions, &Transition::blocksLater);
  if (late == system.transitions.end()) return std::nullopt;
  return Unsupported{"there are no state classes where what goes first has to wait for its time; "
                     "`--graph-of untimed` has the markings without time",
                     system.paths[late->parts[0]].origin};
}

} // namespace

std::expected<StateGraph, Unsupported> stateGraph(const fiacre::Program& program, GraphKind kind,
                                                  const Options& options) try {
  LimitWatch limits(options);
  auto compiled = compile(program, {}, {}, &limits);
  if (!compiled) return std::unexpected(compiled.error());
  const bool timed = kind != GraphKind::Untimed;
  const System system =
      withStateLayout(timed ? std::move(compiled->system) : untimed(std::move(compiled->system)));
  if (auto why = withoutClasses(system)) return std::unexpected(*why);
  GraphRecorder recorder(system, program.main, kind);
  ClassGraph classes(system, limits, &recorder);
  auto counted = classes.run();
  if (!counted) return std::unexpected(counted.error());
  StateGraph graph;
  if (counted->complete) graph = classes.recorded();
  graph.counts = *counted;
  return graph;
} catch (const LimitMet& limit) {
  StateGraph nothing;
  nothing.counts.stopped = limit.which;
  return nothing;
}

std::expected<Exploration, Unsupported> countClasses(const fiacre::Program& program,
                                                     const Options& options) try {
  LimitWatch limits(options);
  // a rank that gave up here would leave the others waiting
  auto compiled = compile(program, {}, {}, options.ranks ? nullptr : &limits);
  if (!compiled) return std::unexpected(compiled.error());
  const System system = withStateLayout(std::move(compiled->system));
  if (auto why = withoutClasses(system)) return std::unexpected(*why);
  if (options.spill) return countWithSpill(system, limits, options);
  if (!options.checkpoint) return ClassGraph(system, limits, nullptr, nullptr, options.ranks).run();
  Checkpoint checkpoint(*options.checkpoint, limits);
  return ClassGraph(system, limits, nullptr, &checkpoint).run();
} catch (const LimitMet& limit) {
  return Exploration{.stopped = limit.which};
}

} // namespace proskill::verify
