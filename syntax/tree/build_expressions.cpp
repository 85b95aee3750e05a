#include "syntax/diagnostics/codes.h"
#include "syntax/tree/build.h"

#include <algorithm>
#include <limits>

namespace proskill::syntax {
namespace {

constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();

struct Arity {
  std::size_t least;
  std::size_t most;
  std::string_view words;
};

Arity arityOf(ExprKind kind) {
  switch (kind) {
  case ExprKind::Test:
  case ExprKind::Value: return {1, 1, "one value"};
  case ExprKind::And:
  case ExprKind::Or: return {1, kAny, "at least one condition"};
  case ExprKind::Not: return {1, 1, "one condition"};
  case ExprKind::Implies:
  case ExprKind::Equivalent: return {2, 2, "two conditions"};
  case ExprKind::Add:
  case ExprKind::Subtract: return {2, kAny, "two or more numbers"};
  case ExprKind::Globally:
  case ExprKind::Finally:
  case ExprKind::Next: return {1, 1, "one formula"};
  case ExprKind::Until:
  case ExprKind::WeakUntil:
  case ExprKind::Release:
  case ExprKind::StrongRelease: return {2, 2, "two formulas"};
  default: return {2, 2, "two operands"};
  }
}

std::string countInWords(std::size_t count) {
  return count == 0 ? "none" : count == 1 ? "one" : std::to_string(count);
}

ExprKind kindOfOperator(const Node& node, std::string_view head) {
  switch (node.kind) {
  case NodeKind::Conjunction: return ExprKind::And;
  case NodeKind::Disjunction: return ExprKind::Or;
  case NodeKind::Negation: return ExprKind::Not;
  case NodeKind::Implication: return ExprKind::Implies;
  case NodeKind::Equivalence: return ExprKind::Equivalent;
  case NodeKind::Arithmetic: return head == "+" ? ExprKind::Add : ExprKind::Subtract;
  case NodeKind::Globally: return ExprKind::Globally;
  case NodeKind::Finally: return ExprKind::Finally;
  case NodeKind::Next: return ExprKind::Next;
  case NodeKind::Until: return ExprKind::Until;
  case NodeKind::WeakUntil: return ExprKind::WeakUntil;
  case NodeKind::Release: return ExprKind::Release;
  case NodeKind::StrongRelease: return ExprKind::StrongRelease;
  default: break;
  }
  if (head == "=") return ExprKind::Equal;
  if (head == "/=") return ExprKind::NotEqual;
  if (head == "<") return ExprKind::Less;
  if (head == "<=") return ExprKind::LessEqual;
  return head == ">" ? ExprKind::Greater : ExprKind::GreaterEqual;
}

bool isTemporal(ExprKind kind) { return kind >= ExprKind::Globally; }

/// Reads the operands and corrects their number, so that users of the tree can rely on it.
void takeOperands(Builder& builder, Parts& parts, Expr& expression, Context context) {
  Offset end = expression.head.range.end;
  while (const Node* part = parts.take()) {
    expression.operands.push_back(expressionOf(builder, *part, context));
    end = part->range.end;
  }
  auto arity = arityOf(expression.kind);
  auto count = expression.operands.size();
  if (count < arity.least || count > arity.most)
    builder.report(Code::WrongOperandCount, expression.range, expression.head.text, arity.words,
                   countInWords(count));
  Expr missing;
  missing.range = {end, end};
  expression.operands.resize(std::clamp(count, arity.least, arity.most), missing);
}

void readOperation(Builder& builder, const Node& node, Expr& expression, Context context) {
  Parts parts(node);
  expression.head = builder.nameOf(*parts.take());
  expression.kind = kindOfOperator(node, expression.head.text);
  if (isTemporal(expression.kind) && context != Context::Formula)
    builder.report(Code::TemporalOutsideLtl, expression.head.range, expression.head.text);
  takeOperands(builder, parts, expression, context);
}

void readTest(Builder& builder, const Node& node, Expr& expression, Context context) {
  Parts parts(node);
  expression.kind = ExprKind::Test;
  expression.head = expression.name = builder.nameOf(*parts.take());
  takeOperands(builder, parts, expression, context);
}

/// Reads `(running takeoff)`, `(ended takeoff success)`, `(value battery Low)`, …
void readObservation(Builder& builder, const Node& node, Expr& expression, ExprKind kind) {
  Parts parts(node);
  expression.kind = kind;
  expression.head = builder.nameOf(*parts.take());
  expression.name = takeName(builder, parts, expression.head);
  if (kind == ExprKind::Value) {
    takeOperands(builder, parts, expression, Context::Condition);
    return;
  }
  if (kind == ExprKind::Ended && parts.peek() && isWord(*parts.peek()))
    expression.member = builder.nameOf(*parts.take());
  builder.reportSurplus(parts, fmt::format("the name that `{}` takes", expression.head.text));
}

void readAccess(Builder& builder, const Node& node, Expr& expression) {
  Parts parts(node);
  expression.kind = ExprKind::Access;
  expression.name = builder.nameOf(*parts.take());
  parts.take(NodeKind::Token); // skip the point
  if (const Node* member = parts.take(NodeKind::Symbol)) {
    expression.member = builder.nameOf(*member);
    return;
  }
  expression.member.range = {node.range.end, node.range.end};
  builder.report(Code::MissingName, node.range, builder.textOf(node));
}

void readNumber(const Builder& builder, const Node& node, Expr& expression) {
  expression.kind = ExprKind::Number;
  expression.number = numberOf(builder, node);
  expression.decimal = builder.textOf(node).contains('.');
}

std::string_view hintFor(std::string_view head) {
  if (head == "==" || head == "eq") return "write `(= a b)` for equality";
  if (head == "!=" || head == "<>") return "write `(/= a b)` for inequality";
  if (head == "&&") return "write `(and ...)`";
  if (head == "||") return "write `(or ...)`";
  if (head == "!") return "write `(not ...)`";
  if (head == "=<") return "write `<=`";
  if (head == "->" || head == "implies") return "write `(=> a b)` for an implication";
  if (head == "<->" || head == "iff") return "write `(<=> a b)` for an equivalence";
  return "it must begin with an operator or a name";
}

void reportNoCondition(Builder& builder, const Node& node) {
  if (isDamaged(node)) return;
  if (node.kind != NodeKind::List) {
    builder.report(Code::MalformedCondition, node.range,
                   fmt::format("`{}` is not allowed here", builder.quoted(node)));
    return;
  }
  Parts parts(node);
  const Node* head = parts.take();
  if (!head)
    builder.report(Code::EmptyForm, node.range);
  else if (!isDamaged(*head))
    builder.report(Code::MalformedCondition, node.range, hintFor(builder.textOf(*head)));
}

/// Reads a name or a truth value. Among the arguments of a command, the grammar parses both as
/// symbols.
void readSymbol(Builder& builder, const Node& node, Expr& expression) {
  auto text = builder.textOf(node);
  expression.kind = text == "true"    ? ExprKind::True
                    : text == "false" ? ExprKind::False
                                      : ExprKind::Symbol;
  if (expression.kind == ExprKind::Symbol) expression.name = builder.nameOf(node);
}

} // namespace

Expr expressionOf(Builder& builder, const Node& node, Context context) {
  Expr expression;
  expression.range = node.range;
  switch (node.kind) {
  case NodeKind::Symbol: readSymbol(builder, node, expression); break;
  case NodeKind::Parameter:
    expression.kind = ExprKind::Parameter;
    expression.name = builder.nameOf(node);
    break;
  case NodeKind::String:
    expression.kind = ExprKind::String;
    expression.name = contentOf(builder, node);
    break;
  case NodeKind::Boolean: readSymbol(builder, node, expression); break;
  case NodeKind::Number: readNumber(builder, node, expression); break;
  case NodeKind::Access: readAccess(builder, node, expression); break;
  case NodeKind::Test: readTest(builder, node, expression, context); break;
  case NodeKind::Comparison:
  case NodeKind::Conjunction:
  case NodeKind::Disjunction:
  case NodeKind::Negation:
  case NodeKind::Implication:
  case NodeKind::Equivalence:
  case NodeKind::Arithmetic:
  case NodeKind::Globally:
  case NodeKind::Finally:
  case NodeKind::Next:
  case NodeKind::Until:
  case NodeKind::WeakUntil:
  case NodeKind::Release:
  case NodeKind::StrongRelease: readOperation(builder, node, expression, context); break;
  case NodeKind::Running: readObservation(builder, node, expression, ExprKind::Running); break;
  case NodeKind::Called: readObservation(builder, node, expression, ExprKind::Called); break;
  case NodeKind::Ended: readObservation(builder, node, expression, ExprKind::Ended); break;
  case NodeKind::Occurs: readObservation(builder, node, expression, ExprKind::Occurs); break;
  case NodeKind::At: readObservation(builder, node, expression, ExprKind::At); break;
  case NodeKind::Value: readObservation(builder, node, expression, ExprKind::Value); break;
  default: reportNoCondition(builder, node);
  }
  return expression;
}

Expr conditionOf(Builder& builder, Field& field) {
  const Node* value = onlyValue(builder, field, "a condition, such as `(motion Free)`");
  if (value) return expressionOf(builder, *value);
  Expr missing;
  Offset end = field.use.keyword.range.end;
  missing.range = {end, end};
  return missing;
}

Expr takeCondition(Builder& builder, Parts& parts, const Name& head) {
  const Node* next = parts.peek();
  bool clause =
      next && (next->kind == NodeKind::ElseifClause || next->kind == NodeKind::ElseClause ||
               next->kind == NodeKind::EffectsField);
  if (next && !clause) return expressionOf(builder, *parts.take());
  builder.report(Code::MissingCondition, head.range, head.text);
  Expr missing;
  missing.range = {head.range.end, head.range.end};
  return missing;
}

} // namespace proskill::syntax
