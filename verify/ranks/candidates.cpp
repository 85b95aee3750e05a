#include "verify/ranks/candidates.h"

#include <algorithm>
#include <numeric>

namespace proskill::verify {

namespace {

std::int64_t sizeOf(std::span<const Bound> zone) {
  return std::accumulate(zone.begin(), zone.end(), std::int64_t{0});
}

} // namespace

void Candidates::add(const Word* state, Candidate candidate) {
  candidate.state = states.add(state).id;
  const auto next = static_cast<std::uint32_t>(all.size());
  const auto hash = mix(mix(0, candidate.state), candidate.zone);
  const auto found = table.findOrAdd(mix(hash, hash >> 32), next, [&](std::uint32_t i) {
    return all[i].state == candidate.state && all[i].zone == candidate.zone;
  });
  if (found == next) all.push_back(candidate);
}

/// Each bound of a zone is at least that of a zone within it, so their sum is greater.
const std::vector<Candidate>& Candidates::inOrder(const ZoneStore& zones) {
  std::ranges::sort(all, [&](const Candidate& a, const Candidate& b) {
    if (a.state != b.state) return a.state < b.state;
    const auto one = zones.matrix(a.zone);
    const auto other = zones.matrix(b.zone);
    const auto difference = sizeOf(one) - sizeOf(other);
    return difference != 0 ? difference > 0 : std::ranges::lexicographical_compare(one, other);
  });
  return all;
}

} // namespace proskill::verify
