#include "verify/explore/open_waits.h"

#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

#include <map>

namespace proskill::verify {

namespace {

/// The process of an instance: `skill_takeoff` of `skill_takeoff_1`.
std::string processOf(const Instance& instance) {
  return instance.name.substr(0, instance.name.rfind('_'));
}

bool isOpen(const System& system, const Transition& transition) {
  if (transition.parts.size() != 1 || transition.port != kNone || transition.interval.upper ||
      transition.tentative || transition.fails)
    return false;
  const Path& path = system.paths[transition.parts[0]];
  if (path.loops) return false; // it changes nothing
  const Node& guard = system.nodes[path.guard];
  return guard.op == NodeOp::Number && guard.number != 0;
}

} // namespace

std::vector<OpenWait> openWaits(const System& system, const std::set<std::string>& processes,
                                const Bits& dropped) {
  std::map<InstanceId, Bits> found;
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    const auto& transition = system.transitions[i];
    if (dropped.contains(i) || !isOpen(system, transition)) continue;
    const Path& path = system.paths[transition.parts[0]];
    if (processes.contains(processOf(system.instances[path.instance])))
      found[path.instance].insert(path.location);
  }
  std::vector<OpenWait> all;
  for (auto& [instance, locations] : found) all.push_back({instance, std::move(locations)});
  return all;
}

bool isWaiting(const System& system, const OpenWait& wait, const Word* state) {
  return wait.locations.contains(static_cast<std::uint32_t>(
      readCell(system, system.instances[wait.instance].location, state)));
}

} // namespace proskill::verify
