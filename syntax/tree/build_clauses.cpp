#include "syntax/diagnostics/codes.h"
#include "syntax/text/characters.h"
#include "syntax/tree/build.h"

#include <algorithm>
#include <set>
#include <string>

/// Effects, and the fields of skills whose values are tags with conditions or clauses.
namespace proskill::syntax {
namespace {

Effect effectOf(Builder& builder, const Node& node) {
  Parts parts(node);
  Effect effect;
  effect.range = node.range;
  effect.variable = builder.nameOf(*parts.take());
  const Node* value = parts.take();
  if (!value) {
    Offset end = effect.variable.range.end;
    effect.value.range = {end, end};
    builder.report(Code::MalformedEffects, node.range,
                   fmt::format("`{}` has no value", effect.variable.text));
    return effect;
  }
  effect.value = expressionOf(builder, *value);
  builder.reportSurplus(parts, fmt::format("the value of `{}`", effect.variable.text));
  return effect;
}

void readOne(Builder& builder, const Node& node, Effects& effects) {
  if (node.kind == NodeKind::Effect)
    effects.items.push_back(effectOf(builder, node));
  else if (!isDamaged(node))
    builder.report(Code::MalformedEffects, node.range,
                   fmt::format("`{}` is not an effect", builder.quoted(node)));
}

/// Reports `(a X) (b Y)` where a list of both was meant.
void reportUnlisted(Builder& builder, Range range) {
  auto& diagnostic =
      builder.report(Code::MalformedEffects, range, "several effects need parentheses around them");
  diagnostic.fixes.push_back(
      {"put them in parentheses", {0, range}, fmt::format("({})", builder.textOf(range))});
}

void readList(Builder& builder, const Node& list, Effects& effects) {
  Parts items(list);
  if (!items.peek()) builder.report(Code::EmptyForm, list.range);
  while (const Node* item = items.take()) readOne(builder, *item, effects);
}

/// Reads an effect that is not in a list, and those that follow it.
void readUnlisted(Builder& builder, const Node& first, Parts& parts, Effects& effects) {
  readOne(builder, first, effects);
  bool alone = !parts.peek() || parts.peek()->kind != NodeKind::Effect;
  if (alone) return builder.reportSurplus(parts, "the effects");
  while (const Node* next = parts.take()) {
    readOne(builder, *next, effects);
    effects.range.end = next->range.end;
  }
  reportUnlisted(builder, effects.range);
}

} // namespace

Effects takeEffects(Builder& builder, Parts& parts, const Name& head) {
  Effects effects;
  effects.range = {head.range.end, head.range.end};
  const Node* first = parts.take();
  if (!first) {
    builder.report(Code::MissingValue, head.range, head.text, "effects, such as `(motion Free)`");
    return effects;
  }
  effects.range = first->range;
  if (first->kind == NodeKind::Effect) {
    readUnlisted(builder, *first, parts, effects);
  } else if (first->kind == NodeKind::EffectList) {
    readList(builder, *first, effects);
    builder.reportSurplus(parts, "the effects");
  } else {
    readOne(builder, *first, effects); // a word: what follows belongs to the same error
  }
  return effects;
}

namespace {

/// A tag from the first words of a condition: `arm_Free` for `(arm Free)`.
std::string tagFor(std::string_view condition) {
  constexpr int kWords = 3;
  std::string tag;
  int words = 0;
  for (std::size_t at = 0; at < condition.size() && words < kWords;) {
    const auto end = std::ranges::find_if_not(condition.substr(at), isWordCharacter);
    const std::string_view word(condition.begin() + at, end);
    const bool isKeyword = at > 0 && condition[at - 1] == ':';
    at += word.size() + 1;
    if (word.empty() || isKeyword || (tag.empty() && isDigit(word[0]))) continue;
    tag += (tag.empty() ? "" : "_") + std::string(word);
    ++words;
  }
  return tag;
}

/// The tags of a list so far.
using Tags = std::set<std::string, std::less<>>;

/// Adds a tag, with a number where there is one like it.
std::string added(const std::string& wish, Tags& tags) {
  std::string tag = wish;
  for (int number = 2; !tags.insert(tag).second; ++number) tag = fmt::format("{}_{}", wish, number);
  return tag;
}

/// \param clause what belongs after the tag
void reportMissingTag(Builder& builder, const Node& node, std::string_view what,
                      const std::string& clause, Tags& tags) {
  auto& diagnostic = builder.report(Code::MissingTag, node.range, what);
  const auto wish = tagFor(builder.textOf(node));
  if (wish.empty()) return;
  const auto tag = added(wish, tags);
  diagnostic.fixes.push_back(
      {"put a tag before it", {0, node.range}, fmt::format("{} {}", tag, clause)});
}

} // namespace

List<Precondition> preconditionsOf(Builder& builder, const Node& list) {
  List<Precondition> preconditions;
  Tags tags;
  Parts parts(list);
  while (const Node* part = parts.take()) {
    if (isDamaged(*part)) continue;
    Precondition precondition;
    precondition.range = part->range;
    if (part->kind != NodeKind::Precondition) {
      precondition.tag.range = {part->range.begin, part->range.begin};
      precondition.condition = expressionOf(builder, *part);
      reportMissingTag(builder, *part, "this precondition", std::string(builder.textOf(*part)),
                       tags);
    } else {
      Parts pair(*part);
      precondition.tag = builder.nameOf(*pair.take());
      tags.emplace(precondition.tag.text);
      if (const Node* condition = pair.take())
        precondition.condition = expressionOf(builder, *condition);
      else {
        precondition.condition.range = {part->range.end, part->range.end};
        builder.report(Code::MissingCondition, part->range, precondition.tag.text);
      }
    }
    preconditions.push_back(std::move(precondition));
  }
  return preconditions;
}

namespace {

/// Reports parts of a clause before its first keyword. \return whether there are any
bool reportLoose(Builder& builder, Parts& parts, std::string_view owner) {
  bool reported = false;
  while (const Node* next = parts.peek()) {
    if (isField(*next)) break;
    if (!reported && !isDamaged(*next))
      builder.report(Code::MalformedValue, next->range, owner, "a keyword and its value here");
    reported = true;
    parts.take();
  }
  return reported;
}

Keywords fieldsOfClause(std::string_view owner) {
  if (owner == ":invariant") return {":guard", ":effects"};
  if (owner == ":interrupt") return {":effects"};
  return {":effects", ":postcondition"};
}

/// Whether the field occurred before. This is reported, and the first one counts.
bool isRepeated(Builder& builder, const Field& field, List<Name>& seen) {
  const Name& keyword = field.use.keyword;
  auto first = std::ranges::find(seen, keyword.text, &Name::text);
  if (first == seen.end()) {
    seen.push_back(keyword);
    return false;
  }
  auto& diagnostic = builder.report(Code::DuplicateField, keyword.range, keyword.text);
  diagnostic.related.push_back({{0, first->range}, "first given here"});
  return true;
}

/// Contents of `:guard` or `:postcondition`.
struct Condition {
  Range field; ///< keyword and value
  Expr says;
};

/// Reads the fields of a clause. \return whether it contains nothing else
bool readClause(Builder& builder, const Node& clause, std::string_view owner, Effects& effects,
                std::optional<Condition>& condition) {
  Parts parts(clause);
  bool empty = !parts.peek();
  // `:interrupt` may be empty
  if (empty && owner != ":interrupt") builder.report(Code::EmptyForm, clause.range);
  bool loose = reportLoose(builder, parts, owner);
  List<Name> seen;
  while (const Node* part = parts.take()) {
    Field field = fieldOf(builder, *part);
    if (isRepeated(builder, field, seen)) continue;
    if (field.kind == NodeKind::EffectsField)
      effects = takeEffects(builder, field.values, field.use.keyword);
    else if (field.kind == NodeKind::UnknownField)
      reportUnknownField(builder, field, owner, fieldsOfClause(owner));
    else
      condition = {field.use.range, conditionOf(builder, field)};
  }
  return !empty && !loose;
}

Invariant invariantOf(Builder& builder, const Node& node) {
  Invariant invariant;
  invariant.range = node.range;
  Parts parts(node);
  invariant.tag = builder.nameOf(*parts.take());
  Offset end = node.range.end;
  invariant.guard.range = {end, end};
  const Node* clause = parts.take();
  if (!clause) {
    builder.report(Code::MissingCondition, node.range, invariant.tag.text);
    return invariant;
  }
  std::optional<Condition> guard;
  bool plain = readClause(builder, *clause, ":invariant", invariant.effects, guard);
  if (guard)
    invariant.guard = std::move(guard->says);
  else if (plain)
    builder.report(Code::MissingValue, clause->range, ":invariant", "a `:guard`");
  return invariant;
}

/// The clause of an invariant whose text may be only its condition.
std::string clauseOf(const Builder& builder, const Node& node) {
  const Node* first = Parts(node).peek();
  const auto text = builder.textOf(node);
  return first && isField(*first) ? std::string(text) : fmt::format("(:guard {})", text);
}

} // namespace

List<Invariant> invariantsOf(Builder& builder, const Node& list) {
  List<Invariant> invariants;
  Tags tags;
  Parts parts(list);
  while (const Node* part = parts.take()) {
    if (part->kind == NodeKind::Invariant)
      tags.emplace(invariants.emplace_back(invariantOf(builder, *part)).tag.text);
    else if (part->kind == NodeKind::InvariantClause)
      reportMissingTag(builder, *part, "this invariant", clauseOf(builder, *part), tags);
    else if (!isDamaged(*part))
      builder.report(Code::MalformedValue, part->range, ":invariant",
                     "tags and clauses, such as `(in_control (:guard (motion Free)))`");
  }
  return invariants;
}

namespace {

Outcome outcomeOf(Builder& builder, const Node& node) {
  Outcome outcome;
  outcome.range = node.range;
  Parts parts(node);
  outcome.tag = builder.nameOf(*parts.take());
  std::optional<Condition> postcondition;
  if (const Node* clause = parts.take())
    readClause(builder, *clause, "outcome", outcome.effects, postcondition);
  if (postcondition) {
    outcome.postconditionField = postcondition->field;
    outcome.postcondition = std::move(postcondition->says);
  }
  return outcome;
}

void reportNoOutcome(Builder& builder, const Node& node) {
  if (isDamaged(node)) return;
  const Node* first = Parts(node).peek();
  if (first && first->kind == NodeKind::Keyword)
    builder.report(Code::MalformedOutcome, node.range, "the tag before the parenthesis is missing");
  else
    builder.report(Code::MalformedOutcome, node.range,
                   fmt::format("`{}` is not an outcome", builder.quoted(node)));
}

/// The clauses of an outcome without their parentheses: from their first keyword to the next tag.
void reportBareClauses(Builder& builder, const Node& keyword, Parts& items) {
  Range range = keyword.range;
  while (items.peek() && items.peek()->kind != NodeKind::Outcome)
    range.end = items.take()->range.end;
  auto& diagnostic = builder.report(Code::MalformedOutcome, range,
                                    "what follows the tag needs parentheses around it");
  diagnostic.fixes.push_back(
      {"put it in parentheses", {0, range}, fmt::format("({})", builder.textOf(range))});
}

/// The end of the last part.
Offset endOf(Parts parts) {
  Offset end = 0;
  while (const Node* next = parts.take()) end = next->range.end;
  return end;
}

/// An outcome with parentheses around its tag and clauses, such as `(done :effects (arm Free))`.
/// The fix removes these, and puts the clauses in parentheses of their own.
void reportWrapped(Builder& builder, const Node& list) {
  Parts items(list);
  const Offset end = endOf(items);
  items.take();
  const Node* clauses = items.peek();
  const Offset from = clauses && clauses->kind == NodeKind::Keyword ? clauses->range.begin : end;
  const bool isClosed = list.range.end > end && builder.textOf(list).ends_with(')');
  const Range rest{end, list.range.end - (isClosed ? 1 : 0)};
  const auto wrapped = from < end ? fmt::format("({})", builder.textOf({from, end})) : "";
  const auto plain = fmt::format("{}{}{}", builder.textOf({list.range.begin + 1, from}), wrapped,
                                 builder.textOf(rest));
  auto& diagnostic =
      builder.report(Code::MalformedOutcome, list.range, "there are parentheses around the tag");
  diagnostic.fixes.push_back({"remove them", {0, list.range}, plain});
}

bool startsWithOutcome(const Node& node) {
  const Node* first = Parts(node).peek();
  return node.kind == NodeKind::OutcomeList && first && first->kind == NodeKind::Outcome;
}

bool startsWithWrapped(const Node& node) {
  const Node* first = Parts(node).peek();
  return node.kind == NodeKind::OutcomeList && first && startsWithOutcome(*first);
}

} // namespace

List<Outcome> outcomesOf(Builder& builder, Field& field) {
  List<Outcome> outcomes;
  auto read = [&](const Node& node) {
    if (node.kind == NodeKind::Outcome) {
      outcomes.push_back(outcomeOf(builder, node));
    } else if (startsWithOutcome(node)) {
      reportWrapped(builder, node);
      outcomes.push_back(outcomeOf(builder, *Parts(node).peek()));
    } else {
      reportNoOutcome(builder, node);
    }
  };
  if (!field.values.peek()) {
    auto& keyword = field.use.keyword;
    builder.report(Code::MissingValue, keyword.range, keyword.text, "an outcome, such as `landed`");
  }
  while (const Node* value = field.values.take()) {
    if (!startsWithOutcome(*value) && !startsWithWrapped(*value)) {
      read(*value);
      continue;
    }
    Parts items(*value);
    while (const Node* item = items.take())
      if (item->kind == NodeKind::Keyword)
        reportBareClauses(builder, *item, items);
      else
        read(*item);
  }
  return outcomes;
}

std::optional<Interrupt> interruptOf(Builder& builder, Field& field) {
  constexpr auto kNeeds = "what it sets, such as `(:effects (motion Free))`";
  const Node* value = onlyValue(builder, field, kNeeds);
  if (!value) return std::nullopt;
  Interrupt interrupt;
  interrupt.range = value->range;
  std::optional<Condition> none;
  if (value->kind == NodeKind::InterruptClause)
    readClause(builder, *value, ":interrupt", interrupt.effects, none);
  else
    reportMalformed(builder, field, *value, kNeeds);
  return interrupt;
}

} // namespace proskill::syntax
