#include "fiacre/syntax/formula.h"

#include <utility>

namespace proskill::fiacre {

Ltl negated(Ltl inner) {
  if (!isAtom(inner)) return {.kind = LtlKind::Not, .operands = operandsOf(std::move(inner))};
  return {.kind = LtlKind::Atom,
          .atom = {.kind = ObservableKind::Not, .operands = operandsOf(std::move(inner.atom))}};
}

namespace {

Ltl of(LtlKind kind, std::vector<Ltl> operands) {
  return {.kind = kind, .operands = std::move(operands)};
}

} // namespace

std::optional<Ltl> asFormula(const Pattern& pattern) {
  if (pattern.after || pattern.before || pattern.until || pattern.within || pattern.forInterval ||
      pattern.forDuration || pattern.lasting || pattern.first)
    return std::nullopt;
  const auto atom = [&](std::size_t i) { return Ltl{.atom = pattern.operands[i]}; };
  using enum LtlKind;
  switch (pattern.kind) {
  case PatternKind::Ltl: return pattern.ltl;
  case PatternKind::Present: return of(Finally, {atom(0)});
  case PatternKind::Always: return of(Globally, {atom(0)});
  case PatternKind::Absent: return of(Globally, {negated(atom(0))});
  case PatternKind::InfinitelyOften: return of(Globally, {of(Finally, {atom(0)})});
  case PatternKind::Mortal: return of(Finally, {of(Globally, {negated(atom(0))})});
  case PatternKind::LeadsTo: return of(Globally, {of(Implies, {atom(0), of(Finally, {atom(1)})})});
  case PatternKind::Precedes: // there is no second before the first
    return of(LtlKind::Or,
              {of(Until, {negated(atom(1)), atom(0)}), of(Globally, {negated(atom(1))})});
  case PatternKind::DeadlockFree:
  case PatternKind::Progress:
  case PatternKind::NoError:
  case PatternKind::AlwaysReachable:
  case PatternKind::Longest:
  case PatternKind::Shortest: return std::nullopt;
  }
  std::unreachable();
}

} // namespace proskill::fiacre
