#include "analysis/flow/domain/effect.h"

#include <algorithm>

namespace proskill::analysis::flow {

namespace {

Move moveTo(unsigned from, const Domain& domain, const std::optional<std::vector<Span>>& values) {
  Move move{.from = from};
  if (!values) {
    move.to = domain.all();
    return move;
  }
  move.alwaysOutside = true;
  for (const Span& span : *values) {
    move.to |= domain.saturated(span);
    move.mayFallShort |= span.first < domain.min();
    move.mayOvershoot |= span.last > domain.max();
    move.alwaysOutside &= span.last < domain.min() || span.first > domain.max();
  }
  return move;
}

} // namespace

std::vector<Move> moves(const Assignment& assignment, const Domain& domain, const State& before) {
  std::vector<Move> result;
  ValueSet from = assignment.slot ? before.values[*assignment.slot] : domain.all();
  if (!assignment.slot || !assignment.value.reads(*assignment.slot)) {
    Move same = moveTo(0, domain, evaluate(assignment.value, before));
    forEach(from, [&](unsigned index) {
      result.push_back(same);
      result.back().from = index;
    });
  } else {
    State one = before;
    forEach(from, [&](unsigned index) {
      one.values[*assignment.slot] = ValueSet::of(index);
      result.push_back(moveTo(index, domain, evaluate(assignment.value, one)));
    });
  }
  return result;
}

} // namespace proskill::analysis::flow
