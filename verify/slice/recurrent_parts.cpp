#include "verify/slice/recurrent_parts.h"

#include "verify/reduce/recurrent_steps.h"

#include <algorithm>

namespace proskill::verify {

namespace {

/// Steps that may repeat, and what they are about.
struct Group {
  Bits steps;
  Bits instances; ///< that take part in them
  Bits reads;
  Bits writes;
  Bits cone; ///< the instances that have an influence on them
};

class RecurrentParts {
public:
  RecurrentParts(const System& whole, Slicer& of, LimitWatch& watch) : slicer(of), limits(watch) {
    eachIn(recurrentSteps(whole, {}, limits), [&](TransitionId id) { recurrent.insert(id); });
  }

  std::optional<std::vector<SliceSeeds>> run() {
    recurrent.each([&](TransitionId id) { groups.push_back(groupOf(id)); });
    while (joinSome()) limits.check();
    const Bits barrier = omittedBarrier();
    if (!isShared(barrier) || !isDivided(barrier)) return std::nullopt;
    std::vector<SliceSeeds> seeds;
    for (auto& group : groups) seeds.push_back({.goals = {}, .steps = group.steps, .loose = {}});
    return seeds;
  }

private:
  [[nodiscard]] Group groupOf(TransitionId id) {
    const Transition& transition = slicer.system().transitions[id];
    Group made;
    made.steps.insert(id);
    for (auto part : transition.parts) {
      made.instances.insert(slicer.system().paths[part].instance);
      made.reads |= slicer.known().paths[part].tested;
      for (const auto& cells : slicer.known().paths[part].assigned) made.reads |= cells;
    }
    for (auto conjunct : slicer.known().transitions[id].guard)
      for (auto part : slicer.lasting(conjunct)) made.reads |= part->cells;
    made.writes = transition.writes;
    return made;
  }

  [[nodiscard]] static bool influence(const Group& one, const Group& other) {
    return one.instances.meets(other.instances) || one.writes.meets(other.reads) ||
           other.writes.meets(one.reads) || one.cone.meets(other.instances) ||
           other.cone.meets(one.instances);
  }

  /// Joins groups of which one has an influence on another, and determines the cones of the others.
  bool joinSome() {
    const auto before = groups.size();
    for (std::size_t i = 0; i < groups.size(); ++i)
      for (std::size_t k = groups.size(); k-- > i + 1;)
        if (influence(groups[i], groups[k])) join(i, k);
    bool grew = false;
    for (auto& group : groups)
      if (group.cone.empty()) {
        group.cone = slicer.instances({.goals = {}, .steps = group.steps, .loose = {}});
        grew = true;
      }
    return grew || groups.size() < before;
  }

  void join(std::size_t i, std::size_t k) {
    groups[i].steps |= groups[k].steps;
    groups[i].instances |= groups[k].instances;
    groups[i].reads |= groups[k].reads;
    groups[i].writes |= groups[k].writes;
    groups[i].cone = {}; // to be determined anew
    groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(k));
  }

  /// Conditions that are false only for an instant, and that slices omit: their nodes.
  [[nodiscard]] Bits omittedBarrier() {
    Bits omitted;
    for (const auto& group : groups)
      group.steps.each([&](TransitionId id) {
        for (const auto* part : instantsOf(id)) {
          Bits from = writersOf(*part);
          from &= slicer.moving();
          if (!from.isWithin(group.cone)) omitted.insert(part->node);
        }
      });
    return omitted;
  }

  /// Whether each repeating step waits for all of the conditions or for none of them.
  bool isShared(const Bits& barrier) {
    bool all = true;
    recurrent.each([&](TransitionId id) {
      Bits own;
      for (const auto* part : instantsOf(id)) own.insert(part->node);
      all = all && (!own.meets(barrier) || barrier.isWithin(own));
    });
    return all;
  }

  /// Whether each of the conditions is changed either by no repeating step, or in one part only.
  bool isDivided(const Bits& barrier) {
    Bits repeating;
    for (const auto& group : groups) repeating |= group.instances;
    bool all = true;
    recurrent.each([&](TransitionId id) {
      for (const auto* part : instantsOf(id)) {
        const Bits writers = writersOf(*part);
        all = all && (!barrier.contains(part->node) || !writers.meets(repeating) ||
                      std::ranges::any_of(groups, [&](const Group& group) {
                        return writers.isWithin(group.cone);
                      }));
      }
    });
    return all;
  }

  [[nodiscard]] std::vector<const Condition*> instantsOf(TransitionId id) {
    std::vector<const Condition*> found;
    for (auto conjunct : slicer.known().transitions[id].guard)
      for (const auto& part : slicer.known().conjuncts[conjunct].parts)
        if (slicer.instantWaits().isInstant(part.node)) found.push_back(&part);
    return found;
  }

  [[nodiscard]] Bits writersOf(const Condition& condition) const {
    Bits writers;
    condition.cells.each([&](CellId cell) { writers |= slicer.known().writers[cell]; });
    return writers;
  }

  Slicer& slicer;
  LimitWatch& limits;
  Bits recurrent; ///< transitions
  std::vector<Group> groups;
};

} // namespace

std::optional<std::vector<SliceSeeds>> recurrentParts(const System& whole, Slicer& slicer,
                                                      LimitWatch& limits) {
  return RecurrentParts(whole, slicer, limits).run();
}

} // namespace proskill::verify
