#include "verify/model/clocks.h"

#include <map>

namespace proskill::verify {

namespace {

/// Cells that may change while the instance stays where it is: what others write, and what it
/// writes itself on a path that ends in `loop`.
Bits changingAround(const System& system, InstanceId instance) {
  Bits cells;
  for (const auto& path : system.paths)
    if (path.instance != instance || path.loops) cells |= path.writes;
  return cells;
}

} // namespace

void assignClocks(System& system) {
  std::map<InstanceId, ClockId> shared;
  std::vector<Bits> changing;
  for (InstanceId i = 0; i < system.instances.size(); ++i)
    changing.push_back(changingAround(system, i));
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    Transition& transition = system.transitions[i];
    if (!isClocked(transition.interval)) continue;
    if (transition.unseen != kNone) { // behind the one that it is the same as
      transition.clock = system.transitions[transition.unseen].clock;
      continue;
    }
    const Path& path = system.paths[transition.parts[0]];
    Bits others = transition.guardReads;
    others.erase(system.instances[path.instance].location);
    bool steady = transition.port == kNone && !path.loops && !path.tentative &&
                  !others.meets(changing[path.instance]);
    const auto next = static_cast<ClockId>(system.clocks.size());
    transition.clock = steady ? shared.try_emplace(path.instance, next).first->second : next;
    if (transition.clock == next)
      system.clocks.push_back(steady ? Clock{path.instance, kNone} : Clock{kNone, i});
  }
}

} // namespace proskill::verify
