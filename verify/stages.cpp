#include "verify/stages.h"

#include <algorithm>

namespace proskill::verify {

std::vector<Stage> stagesOf(const Options& options) {
  const std::uint64_t size = options.classesBeforeSlices;
  const std::uint64_t led = options.classesOfLedSearches;
  const std::uint64_t unit = std::max<std::uint64_t>(size, 100);
  return {{.at = {size},
           .slices = {8 * size, 100 * size},
           .sampled = std::min(20 * size, led),
           .newest = std::min(4 * size, led),
           .led = std::min(2 * size, led),
           .ledEach = size / 2,
           .walks = std::min(4 * size, led)},
          {.at = {5 * size}, .refined = {.together = 2 * unit, .each = unit / 2}},
          {.at = {30 * size},
           .slices = SearchSize{},
           .refined = {.together = 200 * unit, .each = 4 * unit},
           .sampled = std::min(120 * size, 4 * led),
           .samplesTraces = true,
           .newest = led,
           .led = led,
           .ledEach = 100,
           .walks = led},
          {.at = {200 * size},
           .refined = {.together = 2'000 * unit, .each = 60 * unit},
           .sampled = std::min(300 * size, 10 * led),
           .samplesTraces = true,
           .led = 10 * led,
           .ledEach = 2 * led},
          {.at = {1'000 * size}, .refined = {.together = 10'000 * unit, .each = 600 * unit}}};
}

} // namespace proskill::verify
