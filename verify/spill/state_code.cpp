#include "verify/spill/state_code.h"

#include <numeric>

namespace proskill::verify {

namespace {

std::int64_t sizeOf(std::span<const Bound> zone) {
  return std::accumulate(zone.begin(), zone.end(), std::int64_t{0});
}

Bound boundOf(std::uint32_t code) {
  if (code == 0) return kInfinite;
  const std::uint32_t word = code - 1;
  return static_cast<Bound>((word >> 1) ^ ((word & 1) != 0 ? UINT32_MAX : 0U));
}

} // namespace

void readZone(PageReader& from, std::uint32_t dimension, std::vector<Bound>& to) {
  const std::size_t entries = std::size_t{dimension} * dimension;
  for (std::size_t i = 0; i < entries; ++i)
    to.push_back(i % (dimension + 1) == 0 ? kZero
                                          : boundOf(static_cast<std::uint32_t>(from.number())));
}

/// Each bound of a zone is at least that of a zone within it, so their sum is greater.
bool precedes(std::span<const Bound> a, std::span<const Bound> b) {
  const auto difference = sizeOf(a) - sizeOf(b);
  return difference != 0 ? difference > 0 : std::ranges::lexicographical_compare(a, b);
}

} // namespace proskill::verify
