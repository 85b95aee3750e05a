#include "verify/state/timing.h"

#include "verify/model/release.h"
#include <algorithm>

namespace proskill::verify {

Bound lowerBound(const fiacre::Interval& interval) {
  return bound(-interval.lower, interval.lowerOpen);
}

Bound upperBound(const fiacre::Interval& interval) {
  return interval.upper ? bound(*interval.upper, interval.upperOpen) : kInfinite;
}

Bound notYet(const fiacre::Interval& interval) {
  return bound(interval.lower, !interval.lowerOpen);
}

bool resets(const System& system, TransitionId transition, ClockId id) {
  const Clock& clock = system.clocks[id];
  const Bits& consumed = system.transitions[transition].consumed;
  if (clock.instance != kNone) return consumed.contains(clock.instance);
  if (clock.transition == transition || clock.transition == system.transitions[transition].unseen)
    return true;
  return std::ranges::any_of(system.transitions[clock.transition].parts, [&](PathId part) {
    return consumed.contains(system.paths[part].instance);
  });
}

namespace {

std::uint32_t indexOf(const Signature& signature, ClockId clock) {
  auto at = std::ranges::lower_bound(signature.clocks, clock);
  return static_cast<std::uint32_t>(at - signature.clocks.begin()) + 1;
}

/// Describes the clocks of the enabled transitions.
void describeClocks(const System& system, Extrapolation extrapolation, Signature& signature) {
  for (auto id : signature.enabled) signature.clocks.push_back(system.transitions[id].clock);
  std::ranges::sort(signature.clocks);
  auto twice = std::ranges::unique(signature.clocks);
  signature.clocks.erase(twice.begin(), twice.end());
  signature.invariants.assign(signature.clocks.size(), kInfinite);
  signature.lower.assign(signature.clocks.size() + 1, -1);
  signature.upper.assign(signature.clocks.size() + 1, -1);
  for (auto id : signature.enabled) {
    const auto& transition = system.transitions[id];
    const auto& interval = transition.interval;
    const auto at = indexOf(signature, transition.clock);
    auto& invariant = signature.invariants[at - 1];
    invariant = std::min(invariant, upperBound(interval));
    const auto from = static_cast<std::int32_t>(interval.lower);
    if (from > 0 || interval.lowerOpen) signature.lower[at] = std::max(signature.lower[at], from);
    if (transition.blocksLater) signature.upper[at] = std::max(signature.upper[at], from);
    if (interval.upper)
      signature.upper[at] =
          std::max(signature.upper[at], static_cast<std::int32_t>(*interval.upper));
  }
  if (extrapolation == Extrapolation::LowerUpper) return;
  for (std::size_t i = 1; i <= signature.clocks.size(); ++i) {
    bool keepAll =
        extrapolation == Extrapolation::Least && signature.invariants[i - 1] != kInfinite;
    const auto most = keepAll ? INT32_MAX / 4 : std::max(signature.lower[i], signature.upper[i]);
    signature.lower[i] = signature.upper[i] = most;
  }
}

std::uint64_t bytesOfSignature(const Signature& it) {
  constexpr std::uint64_t kOfAllocations = 5 * 16;
  return sizeof it + kOfAllocations + it.enabled.size() * sizeof(TransitionId) +
         it.clocks.size() * sizeof(ClockId) + it.invariants.size() * sizeof(Bound) +
         (it.lower.size() + it.upper.size()) * sizeof(std::int32_t);
}

} // namespace

SignatureId Timing::signature(bool urgent, const TransitionSet& enabled,
                              const TransitionSet& clocked) {
  std::uint64_t hash = mix(0, urgent);
  for (std::size_t k = 0; k < enabled.size(); ++k) hash = mix(hash, enabled[k] & clocked[k]);
  const auto next = static_cast<SignatureId>(signatures.size());
  auto id = table.findOrAdd(mix(hash, hash >> 32), next, [&](SignatureId other) {
    bool same = signatures[other].urgent == urgent;
    for (std::size_t k = 0; k < enabled.size() && same; ++k)
      same = sets[other][k] == (enabled[k] & clocked[k]);
    return same;
  });
  if (id != next) return id;
  Signature made{.urgent = urgent};
  TransitionSet set = enabled;
  for (std::size_t k = 0; k < set.size(); ++k) set[k] &= clocked[k];
  eachIn(set, [&](TransitionId transition) { made.enabled.push_back(transition); });
  describeClocks(system, extrapolation, made);
  ofSignatures += bytesOfSignature(made) + sizeof(TransitionSet) + set.size() * sizeof(Word);
  signatures.push_back(std::move(made));
  sets.push_back(std::move(set));
  return id;
}

void Timing::forget() {
  release(signatures);
  release(sets);
  ofSignatures = 0;
  table = {};
  store = {};
  memo = {};
}

SignatureId Timing::adopt(const Timing& from, SignatureId id) {
  return signature(from.signatures[id].urgent, from.sets[id], from.sets[id]);
}

ZoneId Timing::settle(Dbm zone, const Signature& signature) {
  if (!signature.urgent) zone.up();
  if (!zone.constrainAll(signature.invariants, between)) return kNone;
  zone.extrapolate(signature.lower, signature.upper, between);
  if (!zone.constrainAll(signature.invariants, between)) return kNone;
  if (between && zone.dimension() >= kManyClocks) between(); // the zone is large, too
  return store.add(zone);
}

ZoneId Timing::initial(SignatureId id) {
  const Signature& signature = signatures[id];
  return settle(Dbm(static_cast<std::uint32_t>(signature.clocks.size())), signature);
}

bool Timing::isFirable(ZoneId zone, SignatureId id, TransitionId transition) const {
  const auto& of = system.transitions[transition];
  if (!of.laterBlockers.empty()) {
    Dbm allowed = store.zone(zone);
    return allow(allowed, id, transition);
  }
  if (of.clock == kNone) return true;
  const auto at = indexOf(signatures[id], of.clock);
  return plus(store.at(zone, at, 0), lowerBound(of.interval)) >= kZero;
}

bool Timing::allow(Dbm& zone, SignatureId id, TransitionId transition) const {
  const Signature& signature = signatures[id];
  const auto& fired = system.transitions[transition];
  if (fired.clock != kNone) {
    const auto at = indexOf(signature, fired.clock);
    if (!zone.constrain(0, at, lowerBound(fired.interval))) return false;
    if (!zone.constrain(at, 0, upperBound(fired.interval))) return false;
  }
  return std::ranges::all_of(fired.laterBlockers, [&](TransitionId blocker) {
    if (!std::ranges::binary_search(signature.enabled, blocker)) return true;
    const auto& first = system.transitions[blocker];
    return zone.constrain(indexOf(signature, first.clock), 0, notYet(first.interval));
  });
}

std::vector<std::uint32_t> Timing::kept(SignatureId before, TransitionId transition,
                                        SignatureId after) const {
  std::vector<std::uint32_t> made;
  findKept(before, transition, after, made);
  return made;
}

void Timing::findKept(SignatureId before, TransitionId transition, SignatureId after,
                      std::vector<std::uint32_t>& to) const {
  const auto& old = signatures[before].clocks;
  to.clear();
  for (auto clock : signatures[after].clocks) {
    const auto at = std::ranges::lower_bound(old, clock);
    const bool goesOn = at != old.end() && *at == clock && !resets(system, transition, clock);
    to.push_back(goesOn ? static_cast<std::uint32_t>(at - old.begin()) + 1 : 0);
  }
}

ZoneId Timing::after(ZoneId zone, SignatureId before, TransitionId transition, SignatureId next) {
  return memo.get({zone, before, transition, next},
                  [&] { return calculate(zone, before, transition, next); });
}

ZoneId Timing::calculate(ZoneId id, SignatureId before, TransitionId transition,
                         SignatureId after) {
  Dbm zone = store.zone(id);
  if (!allow(zone, before, transition)) return kNone;
  findKept(before, transition, after, carried);
  return settle(zone.over(carried), signatures[after]);
}

} // namespace proskill::verify
