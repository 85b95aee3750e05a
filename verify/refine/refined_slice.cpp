#include "verify/refine/refined_slice.h"

#include "verify/laid_out.h"

#include <algorithm>
#include <iterator>

namespace proskill::verify {

namespace {

Slice sliceFor(const Precision& precision, const std::vector<Goal>& goals) {
  SliceSeeds seeds;
  for (const auto& goal : goals) seeds.goals.push_back(&goal);
  return precision.slice(std::move(seeds));
}

} // namespace

RefinedSlice::RefinedSlice(const Precision& precision, const std::vector<Goal>& goals,
                           LimitWatch& watch)
    : slice(sliceFor(precision, goals)),
      contraction(contracted(precision.systemOf(slice), goals, watch)),
      limits(watch) {}

Steps RefinedSlice::inSlice(const Steps& steps) const {
  Steps made = contraction.before;
  for (auto step : steps) std::ranges::copy(contraction.original[step], std::back_inserter(made));
  return made;
}

std::optional<Dating> RefinedSlice::datingOf(const Steps& steps) {
  if (!allCells) enabling.emplace(allCells.emplace(laidOutCopy(slice.system, limits)));
  return dated(*allCells, *enabling, {steps, {}}, limits);
}

} // namespace proskill::verify
