#include "verify/refine/precision.h"

#include "verify/refine/omitted_conditions.h"

#include <algorithm>
#include <utility>

namespace proskill::verify {

namespace {

System withoutTime(System system) {
  for (auto& transition : system.transitions) {
    if (transition.fails) continue;
    transition.urgent = false;
    transition.interval = {};
    transition.clock = kNone;
  }
  return system;
}

} // namespace

Slice Precision::slice(SliceSeeds seeds) const {
  seeds.cells = known;
  return slicer->slice(seeds);
}

System Precision::systemOf(const Slice& slice) const {
  return isTimed ? slice.system : withoutTime(slice.system);
}

bool Precision::growBy(const Slice& slice, const Steps& steps) {
  OmittedConditions omitted(*slicer, known);
  for (auto step : slice.inWhole(steps)) omitted.follow(step);
  Bits wanted = omitted.wanted();
  if (wanted.empty() && !isTimed) return isTimed = true;
  if (wanted.empty()) wanted = readByLate(slice);
  if (wanted.isWithin(known)) return false;
  known |= wanted;
  return true;
}

Precision Precision::widened(const AlikeCells& alike) const {
  Precision wide = *this;
  wide.known = alike.with(known);
  return wide;
}

bool Precision::isLike(const Precision& other) const {
  Bits both = known;
  both |= other.known;
  const auto fewer = std::min(known.count(), other.known.count());
  return isTimed == other.isTimed && 4 * both.count() <= 5 * fewer;
}

/// What decides since when steps are due that the slice may take later.
Bits Precision::readByLate(const Slice& slice) const {
  Bits cells;
  const SliceFacts& facts = slicer->known();
  slice.late.each([&](TransitionId late) {
    for (auto conjunct : facts.transitions[slice.original[late]].guard)
      cells |= facts.conjuncts[conjunct].whole.cells;
  });
  return cells;
}

} // namespace proskill::verify
