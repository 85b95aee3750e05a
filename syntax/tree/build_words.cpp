#include "syntax/diagnostics/codes.h"
#include "syntax/diagnostics/suggest.h"
#include "syntax/tree/build.h"
#include "syntax/tree/enumerate.h"

#include <algorithm>

namespace proskill::syntax {

bool isDamaged(const Node& node) {
  return node.kind == NodeKind::MalformedName || node.kind == NodeKind::Unexpected ||
         node.kind == NodeKind::Error;
}

bool isWord(const Node& node) {
  return node.kind == NodeKind::Symbol || node.kind == NodeKind::MalformedName;
}

void Builder::reportSurplus(Parts& parts, std::string_view what) {
  const Node* first = parts.take();
  if (!first) return;
  bool damaged = isDamaged(*first);
  Range range = first->range;
  while (const Node* next = parts.take()) {
    damaged |= isDamaged(*next);
    range.end = next->range.end;
  }
  if (!damaged) report(Code::SurplusPart, range, what);
}

Field fieldOf(const Builder& builder, const Node& node) {
  Parts parts(node);
  const Node* keyword = parts.take();
  return {node.kind, {builder.nameOf(*keyword), node.range}, parts};
}

const Node* onlyValue(Builder& builder, Field& field, std::string_view needs) {
  const Name& keyword = field.use.keyword;
  const Node* value = field.values.take();
  if (!value)
    builder.report(Code::MissingValue, keyword.range, keyword.text, needs);
  else
    builder.reportSurplus(field.values, fmt::format("the value of `{}`", keyword.text));
  return value;
}

void reportMalformed(Builder& builder, const Field& field, const Node& value,
                     std::string_view needs) {
  if (!isDamaged(value))
    builder.report(Code::MalformedValue, value.range, field.use.keyword.text, needs);
}

void reportUnknownField(Builder& builder, const Field& field, std::string_view owner,
                        const Keywords& known) {
  const Name& keyword = field.use.keyword;
  suggest(builder.report(Code::UnknownField, keyword.range, owner, keyword.text,
                         known.empty() ? "none" : enumerateNames(known)),
          nearest(keyword.text, known));
}

namespace {

/// The word of `(word)`, otherwise null.
const Node* wordInParentheses(const Builder& builder, const Node& node) {
  if (!builder.textOf(node).starts_with('(')) return nullptr;
  Parts parts(node);
  const Node* word = parts.take();
  return word && word->kind == NodeKind::Symbol && !parts.peek() ? word : nullptr;
}

} // namespace

Name takeName(Builder& builder, Parts& parts, const Name& head) {
  const Node* next = parts.peek();
  if (next && isWord(*next)) return builder.nameOf(*parts.take());
  if (const Node* word = next ? wordInParentheses(builder, *next) : nullptr) {
    auto& diagnostic = builder.report(Code::MissingName, next->range, head.text);
    diagnostic.fixes.push_back(
        {"remove the parentheses", {0, parts.take()->range}, std::string(builder.textOf(*word))});
    return builder.nameOf(*word);
  }
  if (!next || !isDamaged(*next)) builder.report(Code::MissingName, head.range, head.text);
  return {{}, {head.range.end, head.range.end}};
}

List<Name> namesOf(Builder& builder, const Node& list) {
  List<Name> names;
  Parts parts(list);
  while (const Node* part = parts.take()) {
    if (isWord(*part))
      names.push_back(builder.nameOf(*part));
    else if (!isDamaged(*part))
      builder.report(Code::MalformedName, part->range, builder.textOf(*part));
  }
  return names;
}

Rational numberOf(const Builder& builder, const Node& number) {
  return parseRational(builder.textOf(number)).value_or(Rational{});
}

Name contentOf(const Builder& builder, const Node& string) {
  Range range = string.range;
  bool closed =
      string.size > 1 ? (&string + string.size - 1)->range.end < range.end : range.length() > 1;
  ++range.begin;
  if (closed) --range.end;
  return {builder.textOf(range), range};
}

namespace {

/// A number, or the name of a constant, whose value is not known here.
bool takeBound(const Builder& builder, Parts& parts, std::optional<Rational>& bound, Name& name) {
  if (const Node* number = parts.take(NodeKind::Number)) {
    bound = numberOf(builder, *number);
    return true;
  }
  const Node* symbol = parts.take(NodeKind::Symbol);
  if (symbol) name = builder.nameOf(*symbol);
  return symbol != nullptr;
}

/// What is missing from an interval, for a diagnostic; empty if it is complete.
std::string_view readInterval(const Builder& builder, const Node& node, Interval& interval) {
  Parts parts(node);
  interval.lowerOpen = builder.textOf(*parts.take()) == "]";
  std::optional<Rational> lower;
  if (!takeBound(builder, parts, lower, interval.lowerName)) return "the first bound is missing";
  interval.lower = lower.value_or(Rational{});
  const Node* comma = parts.peek();
  if (!comma || builder.textOf(*comma) != ",") return "the comma is missing";
  parts.take();
  const bool isBounded = takeBound(builder, parts, interval.upper, interval.upperName);
  if (!isBounded && !parts.take(NodeKind::Unbounded)) return "the second bound is missing";
  const Node* right = parts.take();
  if (!right) return "the closing bracket is missing";
  interval.upperOpen = !isBounded || builder.textOf(*right) == "[";
  if (interval.lower < Rational{} || (interval.upper && *interval.upper < Rational{}))
    return "a duration cannot be negative";
  return {};
}

} // namespace

std::optional<Interval> takeInterval(Builder& builder, Parts& parts) {
  const Node* node = parts.take();
  Interval interval;
  interval.range = node->range;
  auto problem = readInterval(builder, *node, interval);
  if (problem.empty()) return interval;
  // the grammar ends a broken interval early; its other parts follow
  while (const Node* next = parts.peek()) {
    bool piece = next->kind == NodeKind::Number || next->kind == NodeKind::Interval ||
                 next->kind == NodeKind::Unexpected || next->kind == NodeKind::Symbol;
    if (!piece) break;
    interval.range.end = parts.take()->range.end;
  }
  builder.report(Code::MalformedInterval, interval.range, problem);
  return std::nullopt;
}

std::optional<Interval> intervalOf(Builder& builder, Field& field) {
  constexpr auto kNeeds = "an interval of seconds, such as `[1,3]`";
  const Node* next = field.values.peek();
  if (!next || next->kind != NodeKind::Interval) {
    if (const Node* value = onlyValue(builder, field, kNeeds))
      reportMalformed(builder, field, *value, kNeeds);
    return std::nullopt;
  }
  auto interval = takeInterval(builder, field.values);
  builder.reportSurplus(field.values, "the interval");
  return interval;
}

} // namespace proskill::syntax
