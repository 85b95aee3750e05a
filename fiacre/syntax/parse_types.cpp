#include "fiacre/syntax/arithmetic.h"
#include "fiacre/syntax/parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace proskill::fiacre {

/// The value of an expression of numbers and of constants declared above.
std::optional<std::int64_t> Parser::value(const Expr& expr) const {
  if (expr.kind == ExprKind::Number) return expr.number;
  if (expr.kind == ExprKind::Name) {
    const auto found = constants.find(expr.name);
    return found == constants.end() ? std::nullopt : std::optional(found->second);
  }
  if (expr.kind == ExprKind::Unary) {
    const auto inner = value(expr.operands[0]);
    if (expr.op == Op::Coerce) return inner;
    return inner && expr.op == Op::Negate ? compute(Op::Subtract, 0, *inner) : std::nullopt;
  }
  if (expr.kind != ExprKind::Binary) return std::nullopt;
  const auto a = value(expr.operands[0]);
  const auto b = value(expr.operands[1]);
  return a && b ? compute(expr.op, *a, *b) : std::nullopt;
}

/// Reads an expression without indices and fields: a `[` here ends an interval.
Expr Parser::constantExpr(std::size_t level) {
  const bool before = std::exchange(constantsOnly, true);
  try {
    Expr result = binary(level);
    constantsOnly = before;
    return result;
  } catch (const CannotRead&) {
    constantsOnly = before;
    throw;
  }
}

std::int64_t Parser::natural(std::string_view what) {
  constexpr std::size_t kSum = 4; // a comparison would consume the `=` that follows
  const Token& first = peek();
  const auto number = value(constantExpr(kSum));
  if (!number) {
    report(fmt::format("{} is not a number known here", what), first);
    throw CannotRead();
  }
  return *number;
}

Type Parser::type() {
  const Deeper deeper(*this);
  if (accept("bool")) return {.kind = TypeKind::Bool};
  if (accept("nat")) return {.kind = TypeKind::Nat};
  if (accept("int")) return {.kind = TypeKind::Int};
  if (accept("record")) return records();
  if (accept("union")) return unions();
  for (auto [word, kind] : {std::pair{"array", TypeKind::Array}, {"queue", TypeKind::Queue}}) {
    if (!accept(word)) continue;
    Type result{.kind = kind, .size = natural("the size")};
    expect("of");
    result.element.push_back(type());
    return result;
  }
  if (isAtName() && !isAt("..", 1) && !constants.contains(peek().text))
    return {.kind = TypeKind::Named, .name = name("a type", NameKind::Type)};
  return range();
}

Type Parser::range() {
  if (peek().kind != TokenKind::Number && !isAt("-") && !isAt("(") && !isAt("$") && !isAtName())
    fail("a type is missing");
  Type result{.kind = TypeKind::Range, .low = natural("the lower bound")};
  expect("..");
  result.high = natural("the upper bound");
  return result;
}

Type Parser::records() {
  Type result{.kind = TypeKind::Record};
  do {
    const auto fields = names("the name of a field", NameKind::Field, true);
    expect(":");
    const Type shared = type();
    for (const auto& field : fields) result.members.push_back({field, {shared}, {}});
  } while (accept(","));
  expect("end");
  accept("record");
  return result;
}

Type Parser::unions() {
  Type result{.kind = TypeKind::Union};
  do {
    const auto constructors = names("the name of a constructor", NameKind::Constructor, true);
    std::vector<Type> shared;
    if (accept("of")) shared.push_back(type());
    for (const auto& each : constructors) result.members.push_back({each, shared, {}});
  } while (accept("|"));
  expect("end");
  accept("union");
  return result;
}

std::int64_t Parser::time() {
  const auto result = natural("the bound of time");
  if (isAt(".")) fail("times must be integers: choose a smaller unit, and name it in a comment");
  return result;
}

Interval Parser::interval() {
  Interval result;
  if (!isAt("[") && !isAt("]")) fail("an interval such as `[0,1]` or `[2,...[` is missing");
  result.lowerOpen = isAt("]");
  ++at;
  result.lower = time();
  expect(",");
  if (accept("...")) {
    expect("[");
    return result;
  }
  result.upper = time();
  result.upperOpen = isAt("[");
  if (!accept("[")) expect("]");
  return result;
}

bool Parser::acceptNoValue() { return accept("sync") || accept("none"); }

/// A direction before the channel's name replaces the channel's own.
bool Parser::acceptChannel(Port& port) {
  const auto channel = channels.find(peek().text);
  if (channel == channels.end()) return false;
  mention(NameKind::Channel);
  ++at;
  port.values = channel->second.values;
  if (port.values.empty()) port.in = port.out = false;
  if (port.in || port.out) return true;
  port.in = channel->second.in;
  port.out = channel->second.out;
  return true;
}

/// Reads `sync`, or the types of the values, with `in` and `out` before them.
void Parser::portType(Port& port) {
  if (acceptNoValue()) return;
  // `in [0,1]` belongs to a component's port without a type
  port.in = accept("in");
  port.out = accept("out");
  if (acceptChannel(port)) return;
  if (acceptNoValue()) {
    port.in = port.out = false; // it carries no value in either direction
    return;
  }
  port.values = list("#", [&] { return type(); });
}

/// \param probed whether probes are allowed among them
std::vector<Port> Parser::ports(bool probed) {
  std::vector<Port> all;
  do {
    const auto declared = names("the name of a port", NameKind::Port, true);
    Port port;
    expect(":");
    portType(port);
    if (accept("in")) port.interval = interval();
    if (isAt("is") && !probed) fail("a probe must be declared after `port` in a component");
    if (const auto begin = peek().begin; accept("is")) {
      port.probe = observable();
      port.origin = origin(begin);
    }
    for (const auto& each : declared) {
      port.name = each;
      all.push_back(port);
    }
  } while (accept(","));
  return all;
}

std::vector<Parameter> Parser::parameters() {
  std::vector<Parameter> all;
  expect("(");
  if (accept(")")) return all;
  do {
    const auto first = all.size();
    do {
      const bool reference = accept("&");
      all.push_back({name("the name of a parameter", NameKind::Parameter, true), {}, reference});
    } while (accept(","));
    expect(":");
    while (accept("read") || accept("write")) {
    }
    const Type shared = type();
    for (auto i = first; i < all.size(); ++i) all[i].type = shared;
  } while (accept(","));
  expect(")");
  return all;
}

std::vector<Variable> Parser::variables() {
  std::vector<Variable> all;
  do {
    const auto declared = names("the name of a variable", NameKind::Variable, true);
    expect(":");
    Variable variable{.type = type()};
    if (accept(":=")) variable.init = expr();
    for (const auto& each : declared) {
      variable.name = each;
      all.push_back(variable);
    }
  } while (accept(","));
  return all;
}

/// Skips `x, y:`, the names of parameters of what is written in C. \return their number
std::size_t Parser::namesBeforeColon() {
  std::size_t ahead = 1;
  while (isAt(",", ahead) && peek(ahead + 1).kind == TokenKind::Name) ahead += 2;
  if (!isAtName() || !isAt(":", ahead)) return 0;
  at += ahead + 1;
  return (ahead + 1) / 2;
}

std::vector<Type> Parser::typesInParentheses() {
  expect("(");
  if (accept(")")) return {};
  std::vector<Type> all;
  do {
    const std::size_t named = namesBeforeColon();
    const Type shared = type();
    all.insert(all.end(), std::max<std::size_t>(named, 1), shared);
  } while (accept(","));
  expect(")");
  return all;
}

} // namespace proskill::fiacre
