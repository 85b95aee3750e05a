#include "verify/monitor/duration_monitor.h"

#include "verify/monitor/monitor_builder.h"

#include <utility>

namespace proskill::verify {

namespace {

class DurationMonitor : MonitorBuilder {
public:
  explicit DurationMonitor(Nodes& in) : MonitorBuilder(none, in) {}

  Monitor write(NodeId begins, NodeId from, NodeId to) {
    const LocationId fresh = addLocation(nodes.number(0)); // the start, which is left at once
    const LocationId idle = addLocation(yes());
    const LocationId measuring = addLocation(no(to), true);
    const LocationId measured = addLocation(yes(), true);
    start(fresh);
    silent(fresh, idle, yes());
    silent(fresh, measuring, from, {}, true);
    step(idle, measuring, begins, {}, true);
    go(measuring, measured, to);
    return std::move(made);
  }

private:
  fiacre::Pattern none;
};

/// What a step has to show so that a measurement begins with it.
NodeId beginning(const System& system, Nodes& nodes, NodeId from) {
  NodeId happens = nodes.number(0);
  for (const auto atom : stepAtoms(system, from)) happens = nodes.binary(NodeOp::Or, happens, atom);
  return nodes.binary(NodeOp::Or, nodes.unary(NodeOp::Entered, from), nodes.both(happens, from));
}

} // namespace

Monitor durationMonitor(const System& system, Nodes& nodes, NodeId from, NodeId to) {
  return DurationMonitor(nodes).write(beginning(system, nodes, from), from, to);
}

Monitor lasting(Monitor monitor, ClockGuard guard) {
  const NodeId always = monitor.locations[kMeasured].stay;
  const auto lost = static_cast<std::uint32_t>(monitor.locations.size());
  monitor.locations.push_back({.stay = always, .error = true});
  monitor.locations[kMeasuring].edges.push_back({.to = lost, .condition = always, .clock = guard});
  return monitor;
}

Monitor ending(Monitor monitor, ClockGuard guard) {
  for (auto& edge : monitor.locations[kMeasuring].edges)
    if (edge.to == kMeasured) edge.clock = guard;
  monitor.locations[kMeasured].error = true;
  return monitor;
}

Monitor endless(Monitor monitor) {
  monitor.locations[kMeasuring].accepting = true;
  monitor.locations[kMeasuring].timed = false;
  monitor.locations[kMeasured].timed = false;
  monitor.fair = true;
  return monitor;
}

} // namespace proskill::verify
