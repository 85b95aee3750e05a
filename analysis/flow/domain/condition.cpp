#include "analysis/flow/domain/condition.h"

#include <algorithm>
#include <limits>

namespace proskill::analysis::flow {

Comparison negated(Comparison comparison) {
  switch (comparison) {
  case Comparison::Equal: return Comparison::NotEqual;
  case Comparison::NotEqual: return Comparison::Equal;
  case Comparison::Less: return Comparison::GreaterEqual;
  case Comparison::LessEqual: return Comparison::Greater;
  case Comparison::Greater: return Comparison::LessEqual;
  case Comparison::GreaterEqual: return Comparison::Less;
  }
  return comparison;
}

namespace {

constexpr std::size_t kMostSpans = 64;

std::int64_t addSaturated(std::int64_t a, std::int64_t b) {
  std::int64_t sum = 0;
  if (!__builtin_add_overflow(a, b, &sum)) return sum;
  return a < 0 ? std::numeric_limits<std::int64_t>::min()
               : std::numeric_limits<std::int64_t>::max();
}

std::int64_t negateSaturated(std::int64_t a) {
  return a == std::numeric_limits<std::int64_t>::min() ? std::numeric_limits<std::int64_t>::max()
                                                       : -a;
}

Span hull(const std::vector<Span>& spans) {
  Span all = spans.front();
  for (const Span& span : spans)
    all = {std::min(all.first, span.first), std::max(all.last, span.last)};
  return all;
}

std::vector<Span> combine(std::vector<Span> left, std::vector<Span> right, bool subtract) {
  if (left.size() * right.size() > kMostSpans) {
    left = {hull(left)};
    right = {hull(right)};
  }
  std::vector<Span> sums;
  for (const Span& a : left)
    for (const Span& b : right) {
      Span added = subtract ? Span{negateSaturated(b.last), negateSaturated(b.first)} : b;
      sums.push_back({addSaturated(a.first, added.first), addSaturated(a.last, added.last)});
    }
  return sums;
}

bool mayCompare(Comparison comparison, Span a, Span b) {
  switch (comparison) {
  case Comparison::Equal: return a.first <= b.last && b.first <= a.last;
  case Comparison::NotEqual: return a.first != a.last || a != b;
  case Comparison::Less: return a.first < b.last;
  case Comparison::LessEqual: return a.first <= b.last;
  case Comparison::Greater: return a.last > b.first;
  case Comparison::GreaterEqual: return a.last >= b.first;
  }
  return true;
}

bool mayCompare(const Condition& condition, const State& state, bool holds) {
  auto left = evaluate(condition.terms[0], state);
  auto right = evaluate(condition.terms[1], state);
  if (!left || !right) return true;
  Comparison comparison = holds ? condition.comparison : negated(condition.comparison);
  for (const Span& a : *left)
    for (const Span& b : *right)
      if (mayCompare(comparison, a, b)) return true;
  return false;
}

/// Keeps the classes of values for which the comparison may be true.
void refineCompare(State& state, const Condition& condition, bool holds) {
  for (Slot slot : condition.slots) {
    ValueSet before = state.values[slot];
    ValueSet kept;
    forEach(before, [&](unsigned index) {
      state.values[slot] = ValueSet::of(index);
      if (mayCompare(condition, state, holds)) kept |= ValueSet::of(index);
    });
    state.values[slot] = kept;
    if (kept.empty()) {
      state.reachable = false;
      return;
    }
  }
}

void refineAny(State& state, const std::vector<Condition>& conditions, bool holds) {
  State any;
  for (const Condition& condition : conditions) {
    State one = state;
    refine(one, condition, holds);
    any.join(one);
  }
  state = std::move(any);
}

void refineEach(State& state, const std::vector<Condition>& conditions, bool holds) {
  for (const Condition& condition : conditions) refine(state, condition, holds);
}

} // namespace

bool Term::reads(Slot wanted) const {
  if (kind == Kind::Variable) return slot == wanted;
  return std::ranges::any_of(operands, [wanted](const Term& t) { return t.reads(wanted); });
}

std::optional<std::vector<Span>> evaluate(const Term& term, const State& state) {
  switch (term.kind) {
  case Term::Kind::Unknown: return std::nullopt;
  case Term::Kind::Number: return std::vector<Span>{{term.number, term.number}};
  case Term::Kind::Any: return *term.spans;
  case Term::Kind::Variable: {
    std::vector<Span> spans;
    forEach(state.values[term.slot], [&](unsigned i) { spans.push_back(term.domain->at(i)); });
    return spans;
  }
  case Term::Kind::Add:
  case Term::Kind::Subtract: break;
  }
  if (term.operands.empty()) return std::nullopt;
  auto total = evaluate(term.operands.front(), state);
  for (std::size_t i = 1; total && i < term.operands.size(); ++i) {
    auto next = evaluate(term.operands[i], state);
    if (!next) return std::nullopt;
    total = combine(std::move(*total), std::move(*next), term.kind == Term::Kind::Subtract);
  }
  return total;
}

void refine(State& state, const Condition& condition, bool holds) {
  if (!state.reachable) return;
  switch (condition.kind) {
  case Condition::Kind::Unknown: return;
  case Condition::Kind::Constant: state.reachable = condition.constant == holds; return;
  case Condition::Kind::Member:
    state.values[condition.slot] &= holds ? condition.holds : condition.fails;
    state.reachable = !state.values[condition.slot].empty();
    return;
  case Condition::Kind::Compare:
    if (condition.slots.empty())
      state.reachable = mayCompare(condition, state, holds);
    else
      refineCompare(state, condition, holds);
    return;
  case Condition::Kind::Not: refine(state, condition.operands.front(), !holds); return;
  case Condition::Kind::And:
    (holds ? refineEach : refineAny)(state, condition.operands, holds);
    return;
  case Condition::Kind::Or:
    (holds ? refineAny : refineEach)(state, condition.operands, holds);
    return;
  }
}

void refineAll(State& state, const std::vector<Condition>& conditions, bool holds) {
  if (!state.reachable) return;
  (holds ? refineEach : refineAny)(state, conditions, holds);
}

bool mayHold(const State& state, const Condition& condition) {
  State copy = state;
  refine(copy, condition, true);
  return copy.reachable;
}

bool mayFail(const State& state, const Condition& condition) {
  State copy = state;
  refine(copy, condition, false);
  return copy.reachable;
}

} // namespace proskill::analysis::flow
