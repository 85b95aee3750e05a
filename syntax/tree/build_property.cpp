#include "syntax/diagnostics/codes.h"
#include "syntax/tree/build.h"

namespace proskill::syntax {
namespace {

struct Pattern {
  PropertyKind kind;
  std::size_t operands;
  std::string_view words;
};

std::optional<Pattern> patternOf(NodeKind kind) {
  switch (kind) {
  case NodeKind::Always: return Pattern{PropertyKind::Always, 1, "one condition"};
  case NodeKind::Never: return Pattern{PropertyKind::Never, 1, "one condition"};
  case NodeKind::Reachable: return Pattern{PropertyKind::Reachable, 1, "one condition"};
  case NodeKind::AlwaysReachable: return Pattern{PropertyKind::AlwaysReachable, 1, "one condition"};
  case NodeKind::DeadlockFree: return Pattern{PropertyKind::DeadlockFree, 0, "no condition"};
  case NodeKind::InfinitelyOften: return Pattern{PropertyKind::InfinitelyOften, 1, "one condition"};
  case NodeKind::LeadsTo: return Pattern{PropertyKind::LeadsTo, 2, "two conditions"};
  case NodeKind::Precedes: return Pattern{PropertyKind::Precedes, 2, "two conditions"};
  case NodeKind::Present: return Pattern{PropertyKind::Present, 1, "one condition"};
  case NodeKind::Absent: return Pattern{PropertyKind::Absent, 1, "one condition"};
  case NodeKind::Longest: return Pattern{PropertyKind::Longest, 2, "two conditions"};
  case NodeKind::Shortest: return Pattern{PropertyKind::Shortest, 2, "two conditions"};
  case NodeKind::Ltl: return Pattern{PropertyKind::Ltl, 1, "one formula"};
  default: return std::nullopt;
  }
}

std::optional<Interval> intervalField(Builder& builder, Field& field) {
  constexpr auto kNeeds = "an interval of seconds, such as `[0,2]`";
  if (const Node* next = field.values.peek(); next && next->kind == NodeKind::Interval) {
    auto interval = takeInterval(builder, field.values);
    builder.reportSurplus(field.values, "the interval");
    return interval;
  }
  if (const Node* value = onlyValue(builder, field, kNeeds))
    reportMalformed(builder, field, *value, kNeeds);
  return std::nullopt;
}

std::optional<Expr> secondsField(Builder& builder, Field& field) {
  constexpr auto kNeeds = "a number of seconds";
  const Node* value = onlyValue(builder, field, kNeeds);
  if (value && (value->kind == NodeKind::Number || value->kind == NodeKind::Symbol))
    return expressionOf(builder, *value);
  if (value) reportMalformed(builder, field, *value, kNeeds);
  return std::nullopt;
}

std::optional<Expr> propositionField(Builder& builder, Field& field) {
  const Node* value = onlyValue(builder, field, "a condition, such as `(running takeoff)`");
  if (!value) return std::nullopt;
  return expressionOf(builder, *value, Context::Proposition);
}

/// `t`, `nil`, or the skills whose actions and waits end.
void readFair(Builder& builder, Field& field, Property& property) {
  constexpr auto kNeeds = "`t`, `nil` or a list of skills";
  const Node* value = onlyValue(builder, field, kNeeds);
  if (!value) return;
  const auto word = builder.textOf(*value);
  if (value->kind == NodeKind::List) property.fairSkills = namesOf(builder, *value);
  if (word == "nil")
    property.fair = false;
  else if (word == "t" || !property.fairSkills.empty())
    property.fair = true;
  else
    reportMalformed(builder, field, *value, kNeeds);
}

/// Whether `:fair` can make a difference: the verdict depends on infinite runs.
bool isAboutTheEnd(PropertyKind kind) {
  return kind == PropertyKind::Present || kind == PropertyKind::LeadsTo ||
         kind == PropertyKind::InfinitelyOften || kind == PropertyKind::Ltl;
}

bool takes(PropertyKind kind, NodeKind field) {
  switch (field) {
  case NodeKind::WithinField: return kind == PropertyKind::LeadsTo || kind == PropertyKind::Present;
  case NodeKind::AfterField:
  case NodeKind::BeforeField: return kind == PropertyKind::Present || kind == PropertyKind::Absent;
  case NodeKind::ForField: return kind == PropertyKind::Absent;
  case NodeKind::LastingField: return kind == PropertyKind::Present;
  case NodeKind::FairField: return isAboutTheEnd(kind);
  default: return false;
  }
}

Keywords fieldsOf(PropertyKind kind) {
  switch (kind) {
  case PropertyKind::LeadsTo: return {":within", ":fair"};
  case PropertyKind::Present: return {":after", ":before", ":within", ":lasting", ":fair"};
  case PropertyKind::Absent: return {":after", ":before", ":for"};
  case PropertyKind::InfinitelyOften:
  case PropertyKind::Ltl: return {":fair"};
  default: return {};
  }
}

void readField(Builder& builder, const Node& node, Property& property) {
  Field field = fieldOf(builder, node);
  property.fields.push_back(field.use);
  if (!takes(property.kind, field.kind)) {
    reportUnknownField(builder, field, property.head.text, fieldsOf(property.kind));
    return;
  }
  switch (field.kind) {
  case NodeKind::AfterField: property.after = propositionField(builder, field); return;
  case NodeKind::BeforeField: property.before = propositionField(builder, field); return;
  case NodeKind::WithinField: property.within = intervalField(builder, field); return;
  case NodeKind::FairField: readFair(builder, field, property); return;
  case NodeKind::ForField: property.forDuration = intervalField(builder, field); return;
  default: property.lasting = secondsField(builder, field);
  }
}

void readPattern(Builder& builder, const Node& node, const Pattern& pattern, Property& property) {
  Parts parts(node);
  property.kind = pattern.kind;
  property.bodyRange = node.range;
  property.head = builder.nameOf(*parts.take());
  auto context = pattern.kind == PropertyKind::Ltl ? Context::Formula : Context::Proposition;
  while (parts.peek() && !isField(*parts.peek()))
    property.operands.push_back(expressionOf(builder, *parts.take(), context));
  auto count = property.operands.size();
  if (count != pattern.operands)
    builder.report(Code::WrongOperandCount, node.range, property.head.text, pattern.words,
                   count == 0 ? "none" : std::to_string(count));
  Expr missing;
  missing.range = {property.head.range.end, property.head.range.end};
  property.operands.resize(pattern.operands, missing);
  while (const Node* part = parts.take()) readField(builder, *part, property);
}

void reportNoPattern(Builder& builder, const Node& node) {
  if (isDamaged(node)) return;
  const Node* head = node.kind == NodeKind::List ? Parts(node).peek() : &node;
  if (!head)
    builder.report(Code::EmptyForm, node.range);
  else if (!isDamaged(*head))
    builder.report(Code::UnknownPattern, head->range, builder.textOf(*head));
}

} // namespace

Property propertyOf(Builder& builder, const Node& node) {
  Property property;
  Parts parts(node);
  Name head = builder.nameOf(*parts.take());
  property.name = takeName(builder, parts, head);
  property.bodyRange = {property.name.range.end, property.name.range.end};
  const Node* body = parts.take();
  if (!body)
    builder.report(Code::MissingPattern, head.range);
  else if (auto pattern = patternOf(body->kind))
    readPattern(builder, *body, *pattern, property);
  else
    reportNoPattern(builder, *body);
  builder.reportSurplus(parts, "the property");
  return property;
}

} // namespace proskill::syntax
