#include "syntax/tree/build.h"

#include "syntax/diagnostics/codes.h"
#include "syntax/text/characters.h"

#include <algorithm>

namespace proskill::syntax {
namespace {

List<Input> inputsOf(Builder& builder, const Node& list) {
  List<Input> inputs;
  bool reported = false;
  Parts parts(list);
  while (const Node* part = parts.take()) {
    if (part->kind != NodeKind::Input) {
      if (!reported && !isDamaged(*part))
        builder.report(Code::MalformedValue, part->range, ":input",
                       "parameters and their types, such as `($height float)`");
      reported = true;
      continue;
    }
    Parts pair(*part);
    Input input;
    input.range = part->range;
    input.name = builder.nameOf(*pair.take());
    if (const Node* type = pair.take())
      input.type = builder.nameOf(*type);
    else {
      input.type.range = {part->range.end, part->range.end};
      builder.report(Code::MissingValue, input.name.range, input.name.text,
                     "a type: `int`, `nat`, `float`, `bool`, `string` or a state variable");
    }
    inputs.push_back(input);
  }
  return inputs;
}

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
    if (word.empty() || isKeyword || (tag.empty() && word[0] <= '9')) continue;
    tag += (tag.empty() ? "" : "_") + std::string(word);
    ++words;
  }
  return tag;
}

/// \param clause what belongs after the tag
void reportMissingTag(Builder& builder, const Node& node, std::string_view what,
                      const std::string& clause) {
  auto& diagnostic = builder.report(Code::MissingTag, node.range, what);
  const auto tag = tagFor(builder.textOf(node));
  if (tag.empty()) return;
  diagnostic.fixes.push_back(
      {"put a tag before it", {0, node.range}, fmt::format("{} {}", tag, clause)});
}

List<Precondition> preconditionsOf(Builder& builder, const Node& list) {
  List<Precondition> preconditions;
  Parts parts(list);
  while (const Node* part = parts.take()) {
    if (isDamaged(*part)) continue;
    Precondition precondition;
    precondition.range = part->range;
    if (part->kind != NodeKind::Precondition) {
      precondition.tag.range = {part->range.begin, part->range.begin};
      precondition.condition = expressionOf(builder, *part);
      reportMissingTag(builder, *part, "this precondition", std::string(builder.textOf(*part)));
    } else {
      Parts pair(*part);
      precondition.tag = builder.nameOf(*pair.take());
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

List<Invariant> invariantsOf(Builder& builder, const Node& list) {
  List<Invariant> invariants;
  Parts parts(list);
  while (const Node* part = parts.take()) {
    if (part->kind == NodeKind::Invariant)
      invariants.push_back(invariantOf(builder, *part));
    else if (part->kind == NodeKind::InvariantClause)
      reportMissingTag(builder, *part, "this invariant", clauseOf(builder, *part));
    else if (!isDamaged(*part))
      builder.report(Code::MalformedValue, part->range, ":invariant",
                     "tags and clauses, such as `(in_control (:guard (motion Free)))`");
  }
  return invariants;
}

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
  const auto plain = fmt::format(fmt::runtime(from < end ? "{}({}){}" : "{}{}{}"),
                                 builder.textOf({list.range.begin + 1, from}),
                                 builder.textOf({from, end}), builder.textOf(rest));
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

std::optional<Action> actionOf(Builder& builder, Field& field) {
  constexpr auto kNeeds = "the command of the platform, such as `(takeoff $height)`";
  const Node* value = onlyValue(builder, field, kNeeds);
  if (!value) return std::nullopt;
  if (value->kind != NodeKind::Command) {
    reportMalformed(builder, field, *value, kNeeds);
    return std::nullopt;
  }
  Parts parts(*value);
  Action action;
  action.range = value->range;
  action.command = takeName(builder, parts, field.use.keyword);
  while (const Node* argument = parts.take())
    action.arguments.push_back(expressionOf(builder, *argument));
  return action;
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

/// The value of the field if it has the required kind; otherwise null, with a report.
const Node* valueOfKind(Builder& builder, Field& field, NodeKind kind, std::string_view needs) {
  const Node* value = onlyValue(builder, field, needs);
  if (!value || value->kind == kind) return value;
  reportMalformed(builder, field, *value, needs);
  return nullptr;
}

void readMonitor(Builder& builder, Field& field, Skill& skill) {
  constexpr auto kNeeds = "`t` or `always`";
  const Node* value = valueOfKind(builder, field, NodeKind::Symbol, kNeeds);
  skill.monitor = true;
  if (!value) return;
  skill.armed = builder.textOf(*value) == "always";
  if (!skill.armed && builder.textOf(*value) != "t")
    reportMalformed(builder, field, *value, kNeeds);
}

/// Reads `:interruptible`; `t` has the effect of an empty `:interrupt`.
void readInterruptible(Builder& builder, Field& field, Skill& skill) {
  constexpr auto kNeeds = "`t` or `nil`";
  const Node* value = valueOfKind(builder, field, NodeKind::Symbol, kNeeds);
  if (!value) return;
  const auto word = builder.textOf(*value);
  skill.unstoppable = word == "nil";
  if (word == "t" && !skill.interrupt)
    skill.interrupt = Interrupt{.effects = {}, .range = value->range};
  if (word != "t" && !skill.unstoppable) reportMalformed(builder, field, *value, kNeeds);
}

void readField(Builder& builder, Field& field, Skill& skill) {
  switch (field.kind) {
  case NodeKind::InputField:
    if (auto list = valueOfKind(builder, field, NodeKind::InputList,
                                "parameters and their types, such as `($height float)`"))
      skill.inputs = inputsOf(builder, *list);
    return;
  case NodeKind::PreconditionField:
    if (auto list = valueOfKind(builder, field, NodeKind::PreconditionList,
                                "tags and conditions, such as `(not_moving (motion Free))`"))
      skill.preconditions = preconditionsOf(builder, *list);
    return;
  case NodeKind::InvariantField:
    if (auto list = valueOfKind(builder, field, NodeKind::InvariantList,
                                "tags and clauses, such as `(in_control (:guard (motion Free)))`"))
      skill.invariants = invariantsOf(builder, *list);
    return;
  case NodeKind::ResourcesField:
    if (auto list =
            valueOfKind(builder, field, NodeKind::NameList, "a list of resources, such as `(arm)`"))
      skill.resources = namesOf(builder, *list);
    return;
  case NodeKind::BodyField:
    skill.body.emplace();
    if (auto list = valueOfKind(builder, field, NodeKind::Block,
                                "a list of statements, such as `((takeoff) (landing))`"))
      skill.body = blockOf(builder, *list);
    return;
  case NodeKind::StartField:
    skill.start = takeEffects(builder, field.values, field.use.keyword);
    return;
  case NodeKind::TimeIntervalField: skill.timeInterval = intervalOf(builder, field); return;
  case NodeKind::ActionField: skill.action = actionOf(builder, field); return;
  case NodeKind::InterruptField: skill.interrupt = interruptOf(builder, field); return;
  case NodeKind::InterruptibleField: return readInterruptible(builder, field, skill);
  case NodeKind::SuccessField: skill.successes = outcomesOf(builder, field); return;
  case NodeKind::FailureField: skill.failures = outcomesOf(builder, field); return;
  case NodeKind::MonitorField: return readMonitor(builder, field, skill);
  default: return;
  }
}

} // namespace

void readSkill(Builder& builder, std::vector<Field>& fields, Skill& skill) {
  for (Field& field : fields) readField(builder, field, skill);
}

} // namespace proskill::syntax
