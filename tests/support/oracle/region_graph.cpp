#include "tests/support/oracle/region_graph.h"

#include <algorithm>

namespace proskill::oracle {

using fiacre::Interval;

namespace {

bool isImmediate(const Interval& interval) {
  return interval.upper == 0 && !interval.upperOpen && !interval.lowerOpen;
}

bool isAlways(const Interval& interval) {
  return interval.lower == 0 && !interval.lowerOpen && !interval.upper;
}

bool reachedLower(const Age& age, const Interval& interval) {
  if (age.beyond || age.whole > interval.lower) return true;
  return age.whole == interval.lower && (age.rank > 0 || !interval.lowerOpen);
}

bool withinUpper(const Age& age, const Interval& interval) {
  if (!interval.upper || age.whole < *interval.upper) return true;
  return age.whole == *interval.upper && age.rank == 0 && !interval.upperOpen;
}

/// Whether time cannot pass before it.
bool isDue(const Region& region, const Firing& firing) {
  if (isImmediate(firing.interval)) return true;
  const auto age = std::ranges::find(region, firing.clock, &Age::clock);
  const auto& upper = firing.interval.upper;
  return age != region.end() && upper && !age->beyond && age->whole == *upper && age->rank == 0 &&
         !firing.interval.upperOpen;
}

/// Ranks in the same order without gaps.
void spread(Region& region) {
  std::set<std::uint32_t> used{0};
  for (const auto& age : region) used.insert(age.rank);
  for (auto& age : region)
    age.rank = static_cast<std::uint32_t>(std::distance(used.begin(), used.find(age.rank)));
}

/// The next region when time passes: just after an integer, otherwise the moment at which the
/// greatest fraction becomes an integer.
Region nextRegion(Region region, const std::map<ClockId, Interval>& clocks) {
  std::uint32_t greatest = 0;
  bool atWhole = false;
  for (const auto& age : region) {
    if (age.beyond) continue;
    greatest = std::max(greatest, age.rank);
    atWhole = atWhole || age.rank == 0;
  }
  for (auto& age : region) {
    if (age.beyond) continue;
    if (atWhole) {
      ++age.rank;
    } else if (age.rank == greatest) {
      ++age.whole;
      age.rank = 0;
    }
    const Interval& bounds = clocks.at(age.clock);
    if (!bounds.upper && (age.whole > bounds.lower || (age.whole == bounds.lower && age.rank > 0)))
      age = {age.clock, 0, 0, true};
  }
  spread(region);
  return region;
}

} // namespace

RegionGraph::RegionGraph(const Interpreter& of, std::size_t limit,
                         std::optional<std::int64_t> watched)
    : model(of), watch(watched) {
  std::size_t start = addDiscrete(model.initial());
  Region fresh;
  for (const auto& [clock, _] : states[start].clocks) fresh.push_back({clock, 0, 0, false});
  addNode(start, std::move(fresh));
  std::size_t next = 0;
  for (; next < all.size() && all.size() < limit; ++next) expand(next);
  finished = next == all.size();
}

std::size_t RegionGraph::addDiscrete(const Store& store) {
  auto [entry, added] = stateIndex.try_emplace(store, states.size());
  if (!added) return entry->second;
  DiscreteState state{store, model.firings(store), {}, false};
  for (const auto& firing : state.firings) {
    if (isImmediate(firing.interval))
      state.urgent = true;
    else if (!isAlways(firing.interval))
      state.clocks[firing.clock] = firing.interval;
  }
  if (watch) state.clocks[kWatch] = {.lower = *watch};
  states.push_back(std::move(state));
  return entry->second;
}

std::size_t RegionGraph::addNode(std::size_t discrete, Region region) {
  auto [entry, added] = nodeIndex.try_emplace({discrete, region}, all.size());
  if (added) all.push_back({discrete, std::move(region), {}, std::nullopt, false});
  return entry->second;
}

void RegionGraph::expand(std::size_t index) {
  const std::size_t count = states[all[index].discrete].firings.size();
  std::vector<std::size_t> awaited;
  for (std::size_t i = 0; i < count; ++i)
    if (isDue(all[index].region, states[all[index].discrete].firings[i])) awaited.push_back(i);
  for (std::size_t i = 0; i < count; ++i) {
    Firing firing = states[all[index].discrete].firings[i];
    auto age = std::ranges::find(all[index].region, firing.clock, &Age::clock);
    if (age != all[index].region.end() && !reachedLower(*age, firing.interval)) continue;
    const auto& others = states[all[index].discrete].firings;
    const bool blocked = std::ranges::any_of(others, [&](const Firing& other) {
      if (!model.goesBefore(other, firing)) return false;
      auto its = std::ranges::find(all[index].region, other.clock, &Age::clock);
      return its == all[index].region.end() || reachedLower(*its, other.interval);
    });
    if (blocked) continue;
    const bool due =
        isDue(all[index].region, firing) || std::ranges::any_of(awaited, [&](std::size_t other) {
          return model.goesBefore(firing, others[other]);
        });
    std::size_t discrete = addDiscrete(firing.after);
    std::size_t target = addNode(discrete, after(all[index], firing, states[discrete]));
    all[index].edges.push_back({i, target, due});
  }
  letTimePass(index);
  if (!watch) return;
  Region again = all[index].region;
  for (auto& age : again)
    if (age.clock == kWatch) age = {kWatch, 0, 0, false};
  spread(again);
  const std::size_t restarted = addNode(all[index].discrete, std::move(again));
  all[index].restarted = restarted;
}

// A clock keeps running if its transition was possible before and is possible after the step, and
// its participants did not take part in the step, except with `loop`.
Region RegionGraph::after(const Node& node, const Firing& firing,
                          const DiscreteState& target) const {
  Region region;
  for (const auto& [clock, _] : target.clocks) {
    auto old = std::ranges::find(node.region, clock, &Age::clock);
    if (clock == kWatch) {
      region.push_back(*old);
      continue;
    }
    bool moved = std::ranges::any_of(model.participants(clock), [&](std::size_t instance) {
      return std::ranges::find(firing.movers, instance) != firing.movers.end();
    });
    bool goesOn = old != node.region.end() && !moved && clock != firing.clock;
    region.push_back(goesOn ? *old : Age{clock, 0, 0, false});
  }
  spread(region);
  return region;
}

void RegionGraph::letTimePass(std::size_t index) {
  const DiscreteState& state = states[all[index].discrete];
  if (state.urgent) return;
  bool open = std::ranges::none_of(all[index].region,
                                   [](const Age& age) { return !age.beyond && age.rank == 0; });
  Region next = nextRegion(all[index].region, state.clocks);
  bool allowed = std::ranges::all_of(next, [&](const Age& age) {
    return age.beyond || withinUpper(age, state.clocks.at(age.clock));
  });
  all[index].timePasses = open || allowed;
  if (!allowed) return;
  std::size_t later = addNode(all[index].discrete, std::move(next));
  all[index].later = later;
}

} // namespace proskill::oracle
