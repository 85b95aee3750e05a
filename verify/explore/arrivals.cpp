#include "verify/explore/arrivals.h"

namespace proskill::verify {

Arrival Arrivals::at(Walk walk) const {
  Arrival made;
  made.chain.push_back(walker.signature(walk, timing));
  walker.followStubbornSets(walk.state, walk.enabled, [&](TransitionId next) {
    limits.check();
    if (!walker.take(walk, next)) return false;
    made.alone.push_back(next);
    made.chain.push_back(walker.signature(walk, timing));
    return true;
  });
  made.state = std::move(walk.state);
  return made;
}

Dbm Arrivals::through(const Arrival& arrival, Dbm zone, bool own) const {
  for (std::size_t i = 0; i < arrival.alone.size(); ++i) {
    auto from = timing.kept(arrival.chain[i], arrival.alone[i], arrival.chain[i + 1]);
    if (own) from.push_back(zone.dimension() - 1);
    zone = zone.over(from);
  }
  return zone;
}

} // namespace proskill::verify
