#include "verify/trace/stored_evidence.h"

#include <algorithm>

namespace proskill::verify {

namespace {

/// Whether a stored mark belongs to the monitor and to a run with this number of steps.
bool fits(const MonitorMove& mark, const Monitor& monitor, std::size_t steps) {
  if (mark.location >= monitor.locations.size()) return false;
  const auto& edges = monitor.locations[mark.location].edges;
  return (mark.ticks || mark.edge < edges.size()) && (!mark.atStep || mark.after > 0) &&
         mark.after <= mark.until && mark.until <= steps;
}

} // namespace

bool canBeReplayed(const Evidence& evidence, const Goal& goal, const System& system) {
  const auto& marks = evidence.marks;
  const auto& monitor = goal.monitor;
  const auto exists = [&](ClockId id) { return id == kNone || id < system.clocks.size(); };
  const bool begins = marks.empty() || std::ranges::find(monitor.initial, marks[0].location) !=
                                           monitor.initial.end();
  return begins && (goal.kind == GoalKind::Run || marks.empty()) &&
         std::ranges::all_of(
             marks, [&](const auto& it) { return fits(it, monitor, evidence.steps.size()); }) &&
         std::ranges::all_of(evidence.steps,
                             [&](auto id) { return id < system.transitions.size(); }) &&
         std::ranges::all_of(evidence.clocks,
                             [&](const auto& it) { return it.clock < system.clocks.size(); }) &&
         std::ranges::all_of(evidence.differences,
                             [&](const auto& it) { return exists(it.a) && exists(it.b); }) &&
         evidence.loop.value_or(0) <= evidence.steps.size() &&
         evidence.rest.value_or(0) <= marks.size();
}

} // namespace proskill::verify
