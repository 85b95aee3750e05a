#include "verify/state/firing_domains.h"

#include "verify/state/timing.h"

#include <algorithm>

namespace proskill::verify {

FiringDomains::FiringDomains(const System& of) : system(of) {
  delayOf.assign(system.transitions.size(), kNone);
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    const auto& transition = system.transitions[i];
    if (transition.clock == kNone) continue;
    const auto location = system.paths[transition.parts[0]].location;
    auto mate = std::ranges::find_if(delays, [&](TransitionId other) {
      return system.transitions[other].clock == transition.clock &&
             system.transitions[other].interval == transition.interval &&
             system.paths[system.transitions[other].parts[0]].location == location;
    });
    delayOf[i] = static_cast<Delay>(mate - delays.begin());
    if (mate == delays.end()) delays.push_back(i);
  }
}

std::uint32_t FiringDomains::signature(bool urgent, const std::vector<TransitionId>& enabled) {
  Signature made{.urgent = urgent};
  for (auto id : enabled) made.delays.push_back(delayOf[id]);
  std::ranges::sort(made.delays);
  auto twice = std::ranges::unique(made.delays);
  made.delays.erase(twice.begin(), twice.end());
  return signatureNumber(std::move(made));
}

std::uint32_t FiringDomains::signatureNumber(Signature of) {
  const auto next = static_cast<std::uint32_t>(signatures.size());
  auto id = table.findOrAdd(hashOfAll(of.delays, of.urgent ? 1 : 0), next,
                            [&](std::uint32_t other) { return signatures[other] == of; });
  if (id == next) signatures.push_back(std::move(of));
  return id;
}

std::uint64_t FiringDomains::signatureBytes() const {
  const std::uint64_t each = sizeof(Signature) + delays.size() * sizeof(Delay); // at most
  return table.bytes() + signatures.size() * each;
}

ZoneId FiringDomains::initial(std::uint32_t id) {
  return enter(Dbm(0), std::vector<std::uint32_t>(signatures[id].delays.size()), signatures[id]);
}

bool FiringDomains::fire(Dbm& domain, const Signature& signature, TransitionId transition) {
  const auto size = domain.dimension();
  if (system.transitions[transition].clock != kNone) {
    auto at = std::ranges::lower_bound(signature.delays, delayOf[transition]);
    const auto fired = static_cast<std::uint32_t>(at - signature.delays.begin()) + 1;
    if (signature.urgent && !domain.constrain(fired, 0, kZero)) return false;
    for (std::uint32_t i = 1; i < size; ++i)
      if (!domain.constrain(fired, i, kZero)) return false;
    domain.startAt(fired);
  } else if (!system.transitions[transition].urgent && !signature.urgent) {
    domain.startBefore();
  }
  return true;
}

ZoneId FiringDomains::calculate(ZoneId id, std::uint32_t beforeId, TransitionId transition,
                                std::uint32_t afterId) {
  const Signature& before = signatures[beforeId];
  const Signature& after = signatures[afterId];
  Dbm domain = store.zone(id);
  if (!fire(domain, before, transition)) return kNone;
  std::vector<std::uint32_t> kept;
  for (auto delay : after.delays) {
    auto at = std::ranges::lower_bound(before.delays, delay);
    bool goesOn = at != before.delays.end() && *at == delay &&
                  !resets(system, transition, system.transitions[delays[delay]].clock);
    kept.push_back(goesOn ? static_cast<std::uint32_t>(at - before.delays.begin()) + 1 : 0);
  }
  return enter(domain, kept, after);
}

/// Keeps some delays; the others, for which `kept` is 0, start now.
ZoneId FiringDomains::enter(const Dbm& from, const std::vector<std::uint32_t>& kept,
                            const Signature& signature) {
  Dbm made = from.over(kept);
  for (std::uint32_t i = 1; i < made.dimension(); ++i) {
    if (kept[i - 1] != 0) continue;
    const auto& interval = system.transitions[delays[signature.delays[i - 1]]].interval;
    made.replace(i, lowerBound(interval), upperBound(interval));
  }
  return store.add(made);
}

} // namespace proskill::verify
