#include "verify/explore/arrivals.h"

namespace proskill::verify {

Arrival Arrivals::at(Walk walk) const {
  Arrival made;
  made.chain.push_back(walker.signature(walk.state, walk.enabled, timing));
  walker.followAlone(walk.state, walk.enabled, [&](TransitionId next) {
    limits.check();
    walker.choose(walk, next, 0);
    if (!walker.take(walk, next)) return false;
    made.alone.push_back(next);
    made.chain.push_back(walker.signature(walk.state, walk.enabled, timing));
    return true;
  });
  made.state = std::move(walk.state);
  return made;
}

Dbm Arrivals::through(const Arrival& arrival, Dbm zone, std::uint32_t own) const {
  for (std::size_t i = 0; i < arrival.alone.size(); ++i) {
    auto from = timing.kept(arrival.chain[i], arrival.alone[i], arrival.chain[i + 1]);
    for (std::uint32_t back = own; back > 0; --back) from.push_back(zone.dimension() - back);
    zone = zone.over(from);
  }
  return zone;
}

} // namespace proskill::verify
