#include "syntax/diagnostics/codes.h"
#include "syntax/tree/build.h"
#include "syntax/tree/statements.h"

/// `(case (takeoff) ((success at_altitude) …) (failure …))`: a call with an arm for each outcome.
namespace proskill::syntax {
namespace {

/// The call of a `case`; an empty block, with a report, if there is none.
Block takeCall(Builder& builder, Parts& parts, const Name& head) {
  Block block;
  block.range = {head.range.end, head.range.end};
  const Node* next = parts.peek();
  if (next && next->kind == NodeKind::Call) {
    block.range = next->range;
    Statement call = statementOf(builder, *parts.take());
    if (call.kind == StatementKind::Call) block.statements.push_back(std::move(call));
    return block;
  }
  builder.report(Code::MalformedStatement, head.range,
                 "a `case` begins with a call, as in `(case (takeoff) (success) (failure))`");
  while (parts.peek() && parts.peek()->kind != NodeKind::CaseArm) parts.take();
  return block;
}

Expr namePart(ExprKind kind, const Name& name, const Name& member, Range range) {
  Expr expr;
  expr.kind = kind;
  expr.range = range;
  expr.name = name;
  expr.member = member;
  return expr;
}

/// The condition that tests an outcome: `(= takeoff.status success)`.
Expr outcomeIs(const Name& callee, std::string_view member, std::string_view word, Range range) {
  Expr equal;
  equal.kind = ExprKind::Equal;
  equal.range = range;
  equal.operands.push_back(
      namePart(ExprKind::Access, {callee.text, range}, {member, range}, range));
  equal.operands.push_back(namePart(ExprKind::Symbol, {word, range}, {}, range));
  return equal;
}

Expr joined(ExprKind kind, List<Expr> operands, Range range) {
  if (operands.size() == 1) return std::move(operands[0]);
  Expr all;
  all.kind = kind;
  all.range = range;
  all.operands = std::move(operands);
  return all;
}

/// A refused call leaves no status.
Expr conditionOf(const CasePattern& pattern, const Name& callee) {
  const auto status = pattern.status.text == "refused" ? "no_status" : pattern.status.text;
  List<Expr> all;
  all.push_back(outcomeIs(callee, "status", status, pattern.range));
  List<Expr> tags;
  for (const Name& tag : pattern.tags)
    tags.push_back(outcomeIs(callee, "res", tag.text, pattern.range));
  if (!tags.empty()) all.push_back(joined(ExprKind::Or, std::move(tags), pattern.range));
  return joined(ExprKind::And, std::move(all), pattern.range);
}

void reportNoOutcomeHere(Builder& builder, const Node& node) {
  if (!isDamaged(node))
    builder.report(Code::MalformedStatement, node.range,
                   "an arm of a `case` begins with an outcome: `(failure ...)`, or "
                   "`((failure lost) ...)`");
}

/// Outcomes that a skill declares have tags.
bool hasTags(std::string_view status) {
  return status != "interrupted" && status != "refused" && status != "else";
}

/// Reads `((failure blocked lost) …)`: any of these tags.
void readPattern(Builder& builder, const Node& node, CasePattern& pattern) {
  Parts words(node);
  const Node* status = words.take(NodeKind::Symbol);
  if (!status) return reportNoOutcomeHere(builder, node);
  pattern.status = builder.nameOf(*status);
  while (const Node* tag = words.take()) {
    if (tag->kind == NodeKind::Symbol)
      pattern.tags.push_back(builder.nameOf(*tag));
    else
      reportNoOutcomeHere(builder, *tag);
  }
  if (pattern.tags.empty() || hasTags(pattern.status.text)) return;
  builder.report(Code::MalformedStatement, pattern.range,
                 fmt::format("`{}` has no tags", pattern.status.text));
  pattern.tags = {};
}

Arm caseArmOf(Builder& builder, const Node& node, const Name& callee) {
  Arm arm;
  Parts parts(node);
  const Node* pattern = parts.take();
  arm.pattern.range = pattern ? pattern->range : node.range;
  arm.keyword = arm.pattern.range;
  if (pattern && pattern->kind == NodeKind::Symbol)
    arm.pattern.status = builder.nameOf(*pattern);
  else if (pattern && pattern->kind == NodeKind::CasePattern)
    readPattern(builder, *pattern, arm.pattern);
  else
    reportNoOutcomeHere(builder, pattern ? *pattern : node);
  if (arm.pattern.status.text != "else") arm.condition = conditionOf(arm.pattern, callee);
  arm.body = takeBlock(builder, parts, arm.pattern.range.end);
  return arm;
}

} // namespace

void readCase(Builder& builder, Parts& parts, Statement& statement) {
  statement.kind = StatementKind::Case;
  statement.branches.push_back(takeCall(builder, parts, statement.head));
  const Statement* call = callOf(statement);
  const Name callee = call ? call->head : Name{{}, statement.head.range};
  while (const Node* part = parts.take()) {
    if (part->kind == NodeKind::CaseArm)
      statement.arms.push_back(caseArmOf(builder, *part, callee));
    else
      reportNoOutcomeHere(builder, *part);
  }
}

} // namespace proskill::syntax
