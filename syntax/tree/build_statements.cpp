#include "syntax/diagnostics/codes.h"
#include "syntax/tree/build.h"

#include <array>

namespace proskill::syntax {
namespace {

bool isWordLike(const Node& node) {
  switch (node.kind) {
  case NodeKind::Symbol:
  case NodeKind::Access:
  case NodeKind::Parameter:
  case NodeKind::Keyword:
  case NodeKind::Number:
  case NodeKind::Operator:
  case NodeKind::String:
  case NodeKind::Interval:
  case NodeKind::MalformedName:
  case NodeKind::Unexpected: return true;
  default: return false;
  }
}

/// Keywords that belong to the surrounding statement, without parentheses of their own.
bool isClauseWord(std::string_view word) {
  return word == "else" || word == "elseif" || word == "until";
}

void reportClauseWord(Builder& builder, Range range, std::string_view word) {
  builder.report(Code::MalformedStatement, range,
                 fmt::format("write `{}` directly in its `{}`, without parentheses", word,
                             word == "until" ? "do" : "if"));
}

void reportNoStatement(Builder& builder, const Node& node) {
  if (isDamaged(node)) return;
  auto text = builder.textOf(node);
  const Node* head = Parts(node).peek();
  if (node.kind == NodeKind::List) {
    if (!head)
      builder.report(Code::EmptyForm, node.range);
    else if (!isDamaged(*head))
      builder.report(Code::MalformedStatement, node.range, "it must begin with a name");
  } else if (isClauseWord(text)) {
    reportClauseWord(builder, node.range, text);
  } else if (node.kind == NodeKind::Symbol) {
    auto& diagnostic = builder.report(Code::MalformedStatement, node.range,
                                      fmt::format("write `({})` to call it", text));
    diagnostic.fixes.push_back(
        {"put it in parentheses", {0, node.range}, fmt::format("({})", text)});
  } else {
    builder.report(Code::MalformedStatement, node.range,
                   fmt::format("`{}` cannot be used alone", text));
  }
}

void readArguments(Builder& builder, Parts& parts, Statement& statement) {
  bool reported = false;
  auto reportOnce = [&](Range range, std::string_view problem) {
    if (!reported) builder.report(Code::MalformedArgument, range, problem);
    reported = true;
  };
  while (const Node* part = parts.take()) {
    if (isDamaged(*part)) continue;
    Argument argument;
    argument.range = part->range;
    if (part->kind != NodeKind::Argument) {
      argument.name.range = {part->range.begin, part->range.begin};
      argument.value = expressionOf(builder, *part);
      reportOnce(part->range, fmt::format("`{}` has no name before it", builder.quoted(*part)));
    } else {
      Parts pair(*part);
      argument.name = builder.nameOf(*pair.take());
      if (const Node* value = pair.take())
        argument.value = expressionOf(builder, *value);
      else {
        argument.value.range = {part->range.end, part->range.end};
        reportOnce(part->range, fmt::format("`{}` has no value after it", argument.name.text));
      }
    }
    statement.arguments.push_back(std::move(argument));
  }
}

void readCall(Builder& builder, const Node& node, Statement& statement) {
  Parts parts(node);
  Name skill = builder.nameOf(*parts.take());
  if (isClauseWord(skill.text)) return reportClauseWord(builder, skill.range, skill.text);
  statement.kind = StatementKind::Call;
  statement.head = statement.name = skill;
  readArguments(builder, parts, statement);
}

void readInterrupt(Builder& builder, const Node& node, Statement& statement) {
  Parts parts(node);
  const Node* target = parts.take();
  Parts halves(*target);
  statement.kind = StatementKind::Interrupt;
  statement.name = builder.nameOf(*halves.take());
  halves.take(NodeKind::Token); // skip the point
  const Node* member = halves.take();
  statement.head =
      member ? builder.nameOf(*member) : Name{{}, {target->range.end, target->range.end}};
  if (statement.head.text != "interrupt") {
    auto& diagnostic = builder.report(
        Code::MalformedStatement, target->range,
        fmt::format("write `({}.interrupt)` to interrupt the skill", statement.name.text));
    diagnostic.fixes.push_back({"write `interrupt`", {0, statement.head.range}, "interrupt"});
  }
  builder.reportSurplus(parts, "the skill that is interrupted");
}

Interval instant(const Builder& builder, const Node& number) {
  Rational seconds = numberOf(builder, number);
  return {seconds, seconds, false, false, number.range};
}

/// Reads a number of seconds, a constant or an interval.
void readDuration(Builder& builder, Parts& parts, Statement& statement) {
  if (const Node* number = parts.take(NodeKind::Number)) {
    statement.duration = instant(builder, *number);
    if (statement.duration.lower < Rational{})
      builder.report(Code::MalformedInterval, number->range, "a duration cannot be negative");
  } else if (const Node* constant = parts.take(NodeKind::Symbol)) {
    statement.duration.range = constant->range;
    statement.duration.lowerName = statement.duration.upperName = builder.nameOf(*constant);
  } else if (auto interval = takeInterval(builder, parts)) {
    statement.duration = *interval;
  }
}

/// Reads `:timeout 5`, and the statements after the timeout.
void readTimeout(Builder& builder, Field& field, Statement& statement) {
  const Node* first = field.values.peek();
  if (first && (first->kind == NodeKind::Number || first->kind == NodeKind::Symbol ||
                first->kind == NodeKind::Interval))
    readDuration(builder, field.values, statement);
  else
    builder.report(Code::MissingValue, field.use.keyword.range, field.use.keyword.text,
                   "a number of seconds, such as `5`");
  statement.branches.push_back(takeBlock(builder, field.values, field.use.range.end));
}

void readWait(Builder& builder, Parts& parts, Statement& statement) {
  const Node* first = parts.peek();
  if (first && (first->kind == NodeKind::Number || first->kind == NodeKind::Interval)) {
    statement.kind = StatementKind::WaitTime;
    readDuration(builder, parts, statement);
    builder.reportSurplus(parts, "the duration");
    return;
  }
  statement.kind = StatementKind::WaitCondition;
  statement.condition = takeCondition(builder, parts, statement.head);
  bool hasEffects = false;
  while (const Node* next = parts.peek()) {
    const bool isTimeout = next->kind == NodeKind::TimeoutField && statement.branches.empty();
    const bool isEffects = next->kind == NodeKind::EffectsField && !hasEffects;
    if (!isTimeout && !isEffects) break;
    Field field = fieldOf(builder, *parts.take());
    hasEffects |= isEffects;
    if (isTimeout)
      readTimeout(builder, field, statement);
    else
      statement.effects = takeEffects(builder, field.values, field.use.keyword);
  }
  builder.reportSurplus(parts, "what is waited for");
}

Arm armOf(Builder& builder, const Name& keyword, Parts& parts) {
  Arm arm;
  arm.keyword = keyword.range;
  Offset end = keyword.range.end;
  if (keyword.text != "else") {
    arm.condition = takeCondition(builder, parts, keyword);
    end = arm.condition->range.end;
  }
  arm.body = takeBlock(builder, parts, end);
  return arm;
}

void readIf(Builder& builder, Parts& parts, Statement& statement) {
  statement.kind = StatementKind::If;
  statement.arms.push_back(armOf(builder, statement.head, parts));
  while (const Node* clause = parts.take()) {
    if (!statement.arms.back().condition) {
      builder.report(Code::MalformedStatement, clause->range, "nothing can follow `else`");
      return;
    }
    Parts inner(*clause);
    Name keyword = builder.nameOf(*inner.take());
    statement.arms.push_back(armOf(builder, keyword, inner));
  }
}

void readLoop(Builder& builder, Parts& parts, Statement& statement, StatementKind kind) {
  statement.kind = kind;
  statement.condition = takeCondition(builder, parts, statement.head);
  statement.branches.push_back(takeBlock(builder, parts, statement.condition.range.end));
}

void readDo(Builder& builder, Parts& parts, Statement& statement) {
  statement.kind = StatementKind::DoUntil;
  statement.branches.push_back(takeBlock(builder, parts, statement.head.range.end));
  const Node* clause = parts.take(NodeKind::UntilClause);
  if (!clause) {
    Offset end = statement.branches.back().range.end;
    statement.condition.range = {end, end};
    builder.report(Code::MalformedStatement, statement.head.range,
                   "a `do` ends with `until` and a condition");
    return;
  }
  Parts inner(*clause);
  Name keyword = builder.nameOf(*inner.take());
  statement.condition = takeCondition(builder, inner, keyword);
  builder.reportSurplus(inner, "the condition of `until`");
}

void readNamed(Builder& builder, Parts& parts, Statement& statement, StatementKind kind) {
  statement.kind = kind;
  statement.name = takeName(builder, parts, statement.head);
  builder.reportSurplus(parts, fmt::format("the name that `{}` takes", statement.head.text));
}

bool looksLikeOneStatement(const Node& block) {
  const Node* first = Parts(block).peek();
  return first && isWordLike(*first);
}

void readBranches(Builder& builder, Parts& parts, Statement& statement, StatementKind kind) {
  statement.kind = kind;
  auto head = statement.head.text;
  if (!parts.peek()) builder.report(Code::MalformedBranch, statement.head.range, head, head);
  while (const Node* part = parts.take()) {
    bool list = part->kind == NodeKind::Block && !looksLikeOneStatement(*part);
    if (list) {
      statement.branches.push_back(blockOf(builder, *part));
    } else if (!isDamaged(*part)) {
      auto& diagnostic = builder.report(Code::MalformedBranch, part->range, head, head);
      diagnostic.fixes.push_back(
          {"put it in parentheses", {0, part->range}, fmt::format("({})", builder.textOf(*part))});
    }
  }
}

void readPrintf(Builder& builder, Parts& parts, Statement& statement) {
  statement.kind = StatementKind::Printf;
  statement.format.range = {statement.head.range.end, statement.head.range.end};
  if (const Node* format = parts.take(NodeKind::String))
    statement.format = contentOf(builder, *format);
  else
    builder.report(Code::MalformedStatement, statement.head.range,
                   "`printf` needs its format in quotes");
  while (const Node* part = parts.take())
    statement.arguments.push_back({{}, expressionOf(builder, *part), part->range});
}

/// Reads a statement that begins with a keyword.
void readHeaded(Builder& builder, const Node& node, Statement& statement) {
  Parts parts(node);
  statement.head = builder.nameOf(*parts.take());
  switch (node.kind) {
  case NodeKind::Wait: return readWait(builder, parts, statement);
  case NodeKind::If: return readIf(builder, parts, statement);
  case NodeKind::Case: return readCase(builder, parts, statement);
  case NodeKind::While: return readLoop(builder, parts, statement, StatementKind::While);
  case NodeKind::DoUntil: return readLoop(builder, parts, statement, StatementKind::DoUntil);
  case NodeKind::Do: return readDo(builder, parts, statement);
  case NodeKind::Label: return readNamed(builder, parts, statement, StatementKind::Label);
  case NodeKind::Goto: return readNamed(builder, parts, statement, StatementKind::Goto);
  case NodeKind::Success: return readNamed(builder, parts, statement, StatementKind::Success);
  case NodeKind::Failure: return readNamed(builder, parts, statement, StatementKind::Failure);
  case NodeKind::Emit: return readNamed(builder, parts, statement, StatementKind::Emit);
  case NodeKind::Parallel: return readBranches(builder, parts, statement, StatementKind::Parallel);
  case NodeKind::Race: return readBranches(builder, parts, statement, StatementKind::Race);
  case NodeKind::Choose: return readBranches(builder, parts, statement, StatementKind::Choose);
  case NodeKind::Printf: return readPrintf(builder, parts, statement);
  case NodeKind::Set:
    statement.kind = StatementKind::Set;
    statement.effects = takeEffects(builder, parts, statement.head);
    return;
  default: // break
    statement.kind = StatementKind::Break;
    builder.reportSurplus(parts, "`break`");
  }
}

} // namespace

Block takeBlock(Builder& builder, Parts& parts, Offset at) {
  Block block;
  block.range = {at, at};
  while (const Node* next = parts.peek()) {
    if (next->kind == NodeKind::ElseifClause || next->kind == NodeKind::ElseClause ||
        next->kind == NodeKind::UntilClause)
      break;
    if (block.range.empty()) block.range.begin = next->range.begin;
    block.range.end = next->range.end;
    block.statements.push_back(statementOf(builder, *parts.take()));
  }
  return block;
}

Statement statementOf(Builder& builder, const Node& node) {
  Statement statement;
  statement.range = node.range;
  if (node.kind == NodeKind::Call)
    readCall(builder, node, statement);
  else if (node.kind == NodeKind::Interrupt)
    readInterrupt(builder, node, statement);
  else if (node.kind == NodeKind::List || isWordLike(node))
    reportNoStatement(builder, node);
  else
    readHeaded(builder, node, statement);
  return statement;
}

Block blockOf(Builder& builder, const Node& list) {
  Block block;
  block.range = list.range;
  Parts parts(list);
  if (looksLikeOneStatement(list)) {
    // its words are not separate statements, so there is one report
    if (!isDamaged(*parts.peek())) {
      auto& diagnostic =
          builder.report(Code::MalformedStatement, list.range, "expected a list of statements");
      diagnostic.fixes.push_back(
          {"put it in parentheses", {0, list.range}, fmt::format("({})", builder.textOf(list))});
    }
    while (parts.peek() && isWordLike(*parts.peek())) parts.take();
  }
  while (const Node* part = parts.take()) block.statements.push_back(statementOf(builder, *part));
  return block;
}

} // namespace proskill::syntax
