#include "verify/compile/priorities.h"

#include "verify/unsupported.h"

#include <map>

namespace proskill::verify {

namespace {

class Priorities {
public:
  Priorities(const Elaboration& from, System& to) : model(from), system(to) {}

  void addAll();

private:
  void putObserversBefore();
  /// By port: the ports with priority over it, directly or by transitivity.
  [[nodiscard]] std::vector<Bits> portsBelow() const;
  /// If the transition with priority can fire whenever it is enabled, testing whether it is enabled
  /// suffices; otherwise its clock matters, too.
  void putBefore(TransitionId high, TransitionId low);

  const Elaboration& model;
  System& system;
};

void Priorities::addAll() {
  std::vector<std::vector<TransitionId>> withPort(system.ports.size());
  std::map<std::pair<InstanceId, std::uint32_t>, std::vector<TransitionId>> inSelect;
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    const auto& transition = system.transitions[i];
    const Path& path = system.paths[transition.parts[0]];
    if (transition.port != kNone)
      withPort[transition.port].push_back(i);
    else if (path.select != 0)
      inSelect[{path.instance, path.select}].push_back(i);
  }
  const auto below = portsBelow();
  for (std::uint32_t high = 0; high < below.size(); ++high)
    below[high].each([&](std::uint32_t low) {
      for (auto first : withPort[high])
        for (auto second : withPort[low]) putBefore(first, second);
    });
  const auto group = [&](TransitionId id) {
    return system.paths[system.transitions[id].parts[0]].group;
  };
  for (const auto& [_, all] : inSelect)
    for (auto first : all)
      for (auto second : all)
        if (group(first) > group(second)) putBefore(first, second);
  putObserversBefore();
}

void Priorities::putObserversBefore() {
  for (TransitionId i = 0; i < system.transitions.size(); ++i)
    if (observes(model, system, system.transitions[i]))
      for (TransitionId j = 0; j < system.transitions.size(); ++j)
        if (!observes(model, system, system.transitions[j])) putBefore(i, j);
}

std::vector<Bits> Priorities::portsBelow() const {
  std::vector<Bits> below(system.ports.size());
  for (const auto& each : model.priorities)
    for (auto high : each.higher)
      for (auto low : each.lower) below[high].insert(low);
  for (std::uint32_t middle = 0; middle < below.size(); ++middle)
    for (auto& high : below)
      if (high.contains(middle)) high |= Bits(below[middle]);
  for (std::uint32_t port = 0; port < below.size(); ++port)
    if (below[port].contains(port))
      unsupported("the port `" + system.ports[port] + "` has priority over itself");
  return below;
}

void Priorities::putBefore(TransitionId high, TransitionId low) {
  const auto& interval = system.transitions[high].interval;
  const bool waits = interval.lowerOpen || interval.lower > 0;
  auto& blocked = system.transitions[low];
  (waits ? blocked.laterBlockers : blocked.blockers).push_back(high);
  system.transitions[high].blocksLater = system.transitions[high].blocksLater || waits;
  system.hasPriorities = true;
}

} // namespace

bool observes(const Elaboration& model, const System& system, const Transition& transition) {
  return system.paths[transition.parts[0]].instance >= model.firstObserver;
}

void addPriorities(const Elaboration& model, System& system) { Priorities(model, system).addAll(); }

} // namespace proskill::verify
