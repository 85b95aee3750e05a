#include "verify/model/clocks.h"

#include <map>

namespace proskill::verify {

namespace {

/// Finds out which instances write which cells.
class Writers {
public:
  explicit Writers(const System& system) : only(system.cells.size(), kNone) {
    for (const auto& path : system.paths)
      path.writes.each([&](CellId cell) {
        const bool first = only[cell] == kNone;
        if (path.loops || (!first && only[cell] != path.instance)) many.insert(cell);
        only[cell] = path.instance;
      });
  }

  /// Whether one of the cells may change while the instance stays in its location: by others, or on
  /// a path of its own that ends in `loop`.
  [[nodiscard]] bool changeAround(InstanceId instance, const Bits& cells) const {
    bool change = cells.meets(many);
    cells.each(
        [&](CellId cell) { change = change || (only[cell] != kNone && only[cell] != instance); });
    return change;
  }

private:
  std::vector<InstanceId> only; ///< by cell: an instance that writes it
  Bits many; ///< cells written by several instances, or by one that stays in its location
};

} // namespace

void assignClocks(System& system) {
  std::map<InstanceId, ClockId> shared;
  const Writers writers(system);
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    Transition& transition = system.transitions[i];
    if (!isClocked(transition.interval)) continue;
    if (transition.unseen != kNone) { // after the transition that it equals
      transition.clock = system.transitions[transition.unseen].clock;
      continue;
    }
    const Path& path = system.paths[transition.parts[0]];
    Bits others = transition.guardReads;
    others.erase(system.instances[path.instance].location);
    bool steady = transition.port == kNone && !path.loops && !path.tentative &&
                  !writers.changeAround(path.instance, others);
    const auto next = static_cast<ClockId>(system.clocks.size());
    transition.clock = steady ? shared.try_emplace(path.instance, next).first->second : next;
    if (transition.clock == next)
      system.clocks.push_back(steady ? Clock{path.instance, kNone} : Clock{kNone, i});
  }
}

} // namespace proskill::verify
