#include "verify/space/zone_graph.h"

#include <algorithm>

namespace proskill::verify {

namespace {

constexpr std::size_t kManyNodes = 16; ///< nodes of a state

std::uint64_t hashOf(StateId state, ZoneId zone) {
  const auto hash = mix(0, std::uint64_t{state} << 32 | zone);
  return mix(hash, hash >> 32);
}

} // namespace

ZoneGraph::ZoneGraph(const System& system, const Bits& dropped, Extrapolation extrapolation)
    : enabling(system, dropped),
      timing(system, extrapolation),
      states(system),
      keepsSteps(!system.clocks.empty()) {}

void ZoneGraph::addState(SignatureId signature) {
  signatures.push(signature);
  coverOf.push(0);
}

void ZoneGraph::addNode(StateId state, ZoneId zone, TransitionId step, bool replaces) {
  const NodeIndex node = size();
  const bool isFirst = state == heads.size();
  NodeIndex next = isFirst ? kNone : headOf(state);
  if (!isFirst && replaces) next = removeSubsumed(state, zone);
  lags.push(node - state);
  zones.push(zone);
  links.push(next == kNone ? 0 : node - next);
  steps.push(keepsSteps ? step + 1 : 0);
  parents.addChild();
  if (isFirst)
    heads.push(node - state);
  else
    heads.set(state, node - state);
  if (!isFirst && !replaces) addToIndex(state, node);
}

/// Keeps the nodes of a state with many nodes by their zones.
/// \param node the newest one of the state
void ZoneGraph::addToIndex(StateId state, NodeIndex node) {
  if (indexed.contains(state)) return addToIndex(node);
  if (!hasMany(state)) return;
  if (!index) index.emplace();
  indexed.insert(state);
  for (NodeIndex i = node; i != kNone; i = nextOf(i)) addToIndex(i);
}

bool ZoneGraph::hasMany(StateId state) const {
  std::size_t count = 0;
  for (NodeIndex i = headOf(state); i != kNone && count < kManyNodes; i = nextOf(i)) ++count;
  return count == kManyNodes;
}

void ZoneGraph::addToIndex(NodeIndex node) {
  const auto isNever = [](NodeIndex) { return false; }; // no zone of a state is added twice
  index->findOrAdd(hashOf(stateOf(node), zoneOf(node)), node, isNever);
}

bool ZoneGraph::isInIndex(StateId state, std::span<const Bound> zone) const {
  const ZoneId id = timing.zones().find(zone);
  const auto isSame = [&](NodeIndex i) { return stateOf(i) == state && zoneOf(i) == id; };
  return id != kNone && index->find(hashOf(state, id), isSame) != kNone;
}

bool ZoneGraph::covers(StateId state, std::span<const Bound> zone, bool inclusion) const {
  const auto& all = timing.zones();
  if (state == RootTable::kStored) return true; // without clocks, all zones are the same
  if (const auto cover = coverOf.at(state); cover != 0) return unions[cover - 1].includesZone(zone);
  if (indexed.contains(state)) return isInIndex(state, zone);
  for (NodeIndex i = headOf(state); i != kNone; i = nextOf(i)) {
    const auto known = all.matrix(zones.at(i));
    if (inclusion ? includes(known, zone) : std::ranges::equal(known, zone)) return true;
  }
  return false;
}

ZoneId ZoneGraph::hullWith(StateId state, ZoneId zone, std::uint8_t most) {
  const auto& all = timing.zones();
  const Dbm before = all.zone(zoneOf(headOf(state)));
  Dbm hull = hullOf(before, all.zone(zone));
  if (hulls.size() <= state) hulls.resize(std::size_t{state} + 1);
  if (hulls[state] < most)
    ++hulls[state];
  else
    hull = widened(before, hull, timing.at(signatureOf(state)).invariants);
  return timing.adopt(hull);
}

/// Removes the nodes whose zones a new one includes from the list of a state. If many remain, the
/// state gets a cover. \return the first that remains
NodeIndex ZoneGraph::removeSubsumed(StateId state, ZoneId zone) {
  if (coverOf.at(state) != 0) {
    addToCover(state, kNone, zone);
    return headOf(state);
  }
  const auto outer = timing.zones().matrix(zone);
  std::size_t left = 0;
  NodeIndex first = kNone;
  NodeIndex last = kNone;
  for (NodeIndex i = headOf(state); i != kNone; i = nextOf(i)) {
    if (includes(outer, timing.zones().matrix(zones.at(i)))) {
      subsumed.insert(i);
      continue;
    }
    if (last != kNone) links.set(last, last - i);
    if (last == kNone) first = i;
    last = i;
    ++left;
  }
  if (last != kNone) links.set(last, 0);
  if (left >= kManyNodes) addToCover(state, first, zone);
  return first;
}

/// Adds the zone to the cover of the state; a new cover begins with the nodes of the state.
void ZoneGraph::addToCover(StateId state, NodeIndex first, ZoneId zone) {
  if (coverOf.at(state) == 0) {
    unions.emplace_back();
    coverOf.set(state, static_cast<std::uint32_t>(unions.size()));
    for (NodeIndex i = first; i != kNone; i = nextOf(i))
      unions.back().add(timing.zones().zone(zones.at(i)));
    coverBytes += unions.back().bytes();
  }
  ZoneCover& cover = unions[coverOf.at(state) - 1];
  coverBytes -= cover.bytes();
  cover.add(timing.zones().zone(zone));
  coverBytes += cover.bytes();
}

std::uint64_t ZoneGraph::bytes() const {
  std::uint64_t all = timing.bytes() + states.bytes() + coverBytes + parents.bytes() +
                      hulls.capacity() + subsumed.bytes() + indexed.bytes() +
                      (index ? index->bytes() : 0) + unions.capacity() * sizeof(ZoneCover);
  for (const Column* column : columns()) all += column->bytes();
  return all;
}

std::uint64_t ZoneGraph::growth() const {
  std::uint64_t all = timing.growth() + states.growth() + (index ? index->growth() : 0);
  for (const Column* column : columns()) all += column->growth();
  return all;
}

} // namespace proskill::verify
