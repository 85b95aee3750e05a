#include "codegen/term/linear.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace proskill::codegen {
namespace {

using fiacre::Op;
using syntax::ExprKind;

/// Saturating sum in 64 bits; domains are smaller.
std::int64_t addUp(std::int64_t a, std::int64_t b) {
  std::int64_t sum = 0;
  if (!__builtin_add_overflow(a, b, &sum)) return sum;
  return b > 0 ? std::numeric_limits<std::int64_t>::max()
               : std::numeric_limits<std::int64_t>::min() + 1;
}

std::int64_t times(std::int64_t a, std::int64_t b) {
  std::int64_t product = 0;
  if (!__builtin_mul_overflow(a, b, &product)) return product;
  return (a > 0) == (b > 0) ? std::numeric_limits<std::int64_t>::max()
                            : std::numeric_limits<std::int64_t>::min() + 1;
}

bool holds(Op op, std::int64_t a, std::int64_t b) {
  if (op == Op::Less) return a < b;
  if (op == Op::LessEqual) return a <= b;
  if (op == Op::Greater) return a > b;
  if (op == Op::GreaterEqual) return a >= b;
  assert(op == Op::Equal);
  return a == b;
}

} // namespace

std::pair<std::int64_t, std::int64_t> domainOf(const syntax::StateVariable& natural) {
  const auto bound = [](const std::optional<syntax::Expr>& expr) {
    return expr ? expr->number.numerator : 0;
  };
  return {bound(natural.min), bound(natural.max)};
}

Linear::Linear(Context& context, const syntax::Expr& expr) { add(context, expr, 1); }

void Linear::add(Context& context, const syntax::Expr& expr, std::int64_t sign) {
  if (expr.kind == ExprKind::Number) {
    constant = addUp(constant, times(sign, expr.number.numerator));
    return;
  }
  if (const auto operand = context.operand(expr)) {
    const auto [low, high] = domainOf(*operand->type);
    return addTerm({operand->variable, sign, low, high});
  }
  assert(expr.kind == ExprKind::Add || expr.kind == ExprKind::Subtract);
  for (std::size_t i = 0; i < expr.operands.size(); ++i) {
    const bool taken = expr.kind == ExprKind::Subtract && (i > 0 || expr.operands.size() == 1);
    add(context, expr.operands[i], taken ? -sign : sign);
  }
}

void Linear::addTerm(const Term& term) {
  const auto same = std::ranges::find(terms, term.variable, &Term::variable);
  if (same == terms.end())
    terms.push_back(term);
  else if ((same->factor += term.factor) == 0)
    terms.erase(same);
}

Linear Linear::minus(const Linear& other) const {
  auto difference = *this;
  difference.constant = addUp(constant, -other.constant);
  for (auto term : other.terms) {
    term.factor = -term.factor;
    difference.addTerm(term);
  }
  return difference;
}

std::pair<std::int64_t, std::int64_t> Linear::range() const {
  std::pair<std::int64_t, std::int64_t> result{constant, constant};
  for (const auto& term : terms) {
    const bool grows = term.factor > 0;
    result.first = addUp(result.first, times(term.factor, grows ? term.low : term.high));
    result.second = addUp(result.second, times(term.factor, grows ? term.high : term.low));
  }
  return result;
}

/// The sum of the positive terms, or the negated sum of the negative ones.
fiacre::Expr Linear::part(bool positive) const {
  const std::int64_t sign = positive ? 1 : -1;
  std::vector<fiacre::Expr> summands;
  for (const auto& term : terms) {
    const auto factor = sign * term.factor;
    if (factor == 1) summands.push_back(name(term.variable));
    if (factor > 1) summands.push_back(binary(Op::Multiply, number(factor), name(term.variable)));
  }
  if (sign * constant > 0) summands.push_back(number(sign * constant));
  if (summands.empty()) return number(0);
  auto sum = std::move(summands[0]);
  for (std::size_t i = 1; i < summands.size(); ++i)
    sum = binary(Op::Add, std::move(sum), std::move(summands[i]));
  return sum;
}

fiacre::Expr Linear::expr() const {
  auto negative = part(false);
  if (negative == number(0)) return part(true);
  return binary(Op::Subtract, part(true), std::move(negative));
}

fiacre::Expr Linear::compare(Op op, const Linear& left, const Linear& right) {
  const auto difference = left.minus(right);
  const auto [low, high] = difference.range();
  const bool always = holds(op, low, 0) && holds(op, high, 0) && (op != Op::Equal || low == high);
  if (always) return boolean(true);
  const bool never =
      op == Op::Equal ? low > 0 || high < 0 : !holds(op, low, 0) && !holds(op, high, 0);
  if (never) return boolean(false);
  return binary(op, difference.part(true), difference.part(false));
}

} // namespace proskill::codegen
