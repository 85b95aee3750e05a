#include "verify/refine/omitted_conditions.h"

#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

#include <algorithm>
#include <ranges>

namespace proskill::verify {

namespace {

/// So many cells are added at once, or as many as are known.
constexpr std::uint32_t kFewest = 4;

} // namespace

OmittedConditions::OmittedConditions(const Slicer& of, const Bits& cells)
    : slicer(of),
      system(of.withLayout()),
      known(cells),
      state(initialState(system)),
      writer(system.cells.size(), kNone) {}

void OmittedConditions::follow(TransitionId step) {
  const Transition& transition = system.transitions[step];
  const auto moving = system.paths[transition.parts.front()].instance;
  for (auto conjunct : slicer.known().transitions[step].guard) {
    const auto& condition = slicer.known().conjuncts[conjunct].whole;
    if (!condition.cells.isWithin(slicer.known().transitions[step].ownLocations))
      look(condition, moving);
  }
  isLost = isLost || fire(system, step, state.data(), log) != Outcome::Done;
  transition.writes.each([&](CellId cell) { writer[cell] = moving; });
}

void OmittedConditions::look(const Condition& condition, InstanceId reader) {
  if (isLost || condition.cells.isWithin(known) || holds(system, condition.node, state.data()))
    return;
  ofFalse.push_back(condition.cells);
  if (inConflict.empty() && isWrittenByAnother(condition.cells, reader))
    inConflict = condition.cells;
}

Bits OmittedConditions::wanted() const {
  if (!inConflict.empty()) return inConflict;
  Bits cells;
  for (const auto& condition : ofFalse | std::views::reverse) {
    cells |= condition;
    if (cells.count() >= std::max(known.count(), kFewest)) break;
  }
  return cells;
}

bool OmittedConditions::isWrittenByAnother(const Bits& cells, InstanceId reader) const {
  bool isSo = false;
  cells.each(
      [&](CellId cell) { isSo = isSo || (writer[cell] != kNone && writer[cell] != reader); });
  return isSo;
}

} // namespace proskill::verify
