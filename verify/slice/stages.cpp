#include "verify/slice/stages.h"

#include <algorithm>

namespace proskill::verify {

std::vector<Stage> stagesOf(const Options& options) {
  const std::uint64_t size = options.classesBeforeSlices;
  const std::uint64_t led = options.classesOfLedSearches;
  return {{.at = {size},
           .slices = {8 * size, 100 * size},
           .led = std::min(2 * size, led),
           .ledEach = size / 2,
           .walks = std::min(4 * size, led)},
          {.at = {30 * size}, .slices = {}, .led = led, .ledEach = 100, .walks = led}};
}

} // namespace proskill::verify
