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

std::optional<std::int64_t> stepOf(const Assignment& assignment) {
  const auto& [kind, number, spans, slot, domain, operands] = assignment.value;
  const bool isSum = kind == Term::Kind::Add || kind == Term::Kind::Subtract;
  if (!assignment.slot || !isSum || operands.size() != 2) return std::nullopt;
  const auto isItself = [&](const Term& term) {
    return term.kind == Term::Kind::Variable && term.slot == *assignment.slot;
  };
  if (isItself(operands[0]) && operands[1].kind == Term::Kind::Number)
    return kind == Term::Kind::Add ? operands[1].number : -operands[1].number;
  if (kind == Term::Kind::Add && isItself(operands[1]) && operands[0].kind == Term::Kind::Number)
    return operands[0].number;
  return std::nullopt;
}

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
