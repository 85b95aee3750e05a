#pragma once

#include "verify/model/system.h"

#include <map>
#include <utility>

namespace proskill::verify {

/// A system without its paths and transitions.
[[nodiscard]] inline System withoutSteps(System system) {
  system.paths.clear();
  system.transitions.clear();
  return system;
}

/// Adds steps to a system that has the instances and clocks of another, but other steps. Paths are
/// numbered when they are first used.
class StepCopies {
public:
  /// \pre the arguments outlive this
  StepCopies(const System& from, System& to) : whole(from), made(to) {}

  /// Adds a transition that is made of one of the whole. `pathOf` makes the copy of a path.
  template <class PathOf> void add(TransitionId id, Transition transition, PathOf pathOf) {
    for (auto& part : transition.parts) {
      const auto next = static_cast<PathId>(made.paths.size());
      const auto [entry, isNew] = numbers.try_emplace(part, next);
      if (isNew) made.paths.push_back(pathOf(part));
      part = entry->second;
    }
    put(id, std::move(transition));
  }
  /// Adds a transition of the whole as it is.
  void add(TransitionId id) {
    add(id, whole.transitions[id], [&](PathId path) { return whole.paths[path]; });
  }
  /// Adds a transition with a path of its own, for one of a single part.
  void add(TransitionId id, Transition transition, Path path) {
    transition.parts = {static_cast<PathId>(made.paths.size())};
    made.paths.push_back(std::move(path));
    put(id, std::move(transition));
  }

private:
  void put(TransitionId id, Transition transition) {
    const auto clock = transition.clock;
    if (clock != kNone && whole.clocks[clock].transition == id)
      made.clocks[clock].transition = static_cast<TransitionId>(made.transitions.size());
    made.transitions.push_back(std::move(transition));
  }

  const System& whole;
  System& made;
  std::map<PathId, PathId> numbers;
};

} // namespace proskill::verify
