#include "syntax/tree/build.h"

#include "syntax/diagnostics/codes.h"

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
