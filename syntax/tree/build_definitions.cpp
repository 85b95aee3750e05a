#include "syntax/diagnostics/codes.h"
#include "syntax/diagnostics/suggest.h"
#include "syntax/text/scan.h"
#include "syntax/tree/build.h"

#include <algorithm>

namespace proskill::syntax {
namespace {

Keywords fieldsOf(NodeKind definition) {
  switch (definition) {
  case NodeKind::StateVariable: return {":states", ":init", ":transitions", ":min", ":max"};
  case NodeKind::Event: return {":every", ":guard", ":effects"};
  case NodeKind::Resource: return {":capacity"};
  case NodeKind::Environment: return {":body"};
  default:
    return {":input",     ":precondition", ":start",         ":invariant", ":time_interval",
            ":action",    ":interrupt",    ":interruptible", ":success",   ":failure",
            ":resources", ":monitor",      ":body"};
  }
}

/// A definition whose fields are not yet read.
struct Definition {
  Name keyword;
  Name name;
  List<FieldUse> uses;       ///< all fields
  std::vector<Field> fields; ///< the known fields; of duplicates only the first
};

void addField(Builder& builder, const Node& node, NodeKind owner, Definition& definition) {
  Field field = fieldOf(builder, node);
  bool again = std::ranges::any_of(definition.uses, [&](const FieldUse& use) {
    return use.keyword.text == field.use.keyword.text;
  });
  definition.uses.push_back(field.use);
  if (field.kind == NodeKind::UnknownField)
    reportUnknownField(builder, field, definition.keyword.text, fieldsOf(owner));
  else if (!again)
    definition.fields.push_back(field);
}

Definition definitionOf(Builder& builder, const Node& node) {
  Definition definition;
  Parts parts(node);
  definition.keyword = builder.nameOf(*parts.take());
  definition.name = takeName(builder, parts, definition.keyword);
  bool reported = !definition.name;
  while (const Node* part = parts.take()) {
    if (isField(*part)) {
      addField(builder, *part, node.kind, definition);
    } else if (!reported && !isDamaged(*part)) {
      builder.report(Code::SurplusPart, part->range, "the name");
      reported = true;
    }
  }
  return definition;
}

Expr valueField(Builder& builder, Field& field, std::string_view needs) {
  if (const Node* value = onlyValue(builder, field, needs)) return expressionOf(builder, *value);
  Expr missing;
  Offset end = field.use.keyword.range.end;
  missing.range = {end, end};
  return missing;
}

void readStates(Builder& builder, Field& field, StateVariable& variable) {
  constexpr auto kNeeds = "a list of names, such as `(Good Low Critical)`";
  const Node* value = onlyValue(builder, field, kNeeds);
  if (!value) return;
  if (value->kind == NodeKind::NameList) {
    variable.states = namesOf(builder, *value);
    if (!Parts(*value).peek()) builder.report(Code::EmptyForm, value->range);
  } else {
    reportMalformed(builder, field, *value, kNeeds);
  }
}

void readPairs(Builder& builder, const Node& list, StateVariable& variable) {
  bool reported = false;
  Parts parts(list);
  while (const Node* part = parts.take()) {
    auto names = part->kind == NodeKind::Transition ? namesOf(builder, *part) : List<Name>{};
    if (names.size() == 2) {
      variable.transitions.push_back({names[0], names[1], part->range});
    } else if (!reported && !isDamaged(*part)) {
      builder.report(Code::MalformedValue, part->range, ":transitions",
                     "pairs of values, such as `(Good Low)`");
      reported = true;
    }
  }
}

void readTransitions(Builder& builder, Field& field, StateVariable& variable) {
  constexpr auto kNeeds = "`:all` or a list of pairs, such as `((Good Low) (Low Good))`";
  const Node* value = onlyValue(builder, field, kNeeds);
  if (!value) return;
  if (value->kind == NodeKind::All) {
    variable.transitionsKind = Transitions::All;
  } else if (value->kind == NodeKind::TransitionList) {
    variable.transitionsKind = Transitions::Listed;
    readPairs(builder, *value, variable);
  } else {
    reportMalformed(builder, field, *value, kNeeds);
  }
}

/// Reads one value, or a list of possible values.
void readInit(Builder& builder, Field& field, StateVariable& variable) {
  const Node* value = onlyValue(builder, field, "the initial value");
  variable.init.range = {field.use.keyword.range.end, field.use.keyword.range.end};
  if (!value) return;
  if (value->kind != NodeKind::NameList) {
    variable.init = expressionOf(builder, *value);
    return;
  }
  Parts parts(*value);
  if (!parts.peek()) builder.report(Code::EmptyForm, value->range);
  if (const Node* first = parts.take()) variable.init = expressionOf(builder, *first);
  while (const Node* next = parts.take())
    variable.otherInits.push_back(expressionOf(builder, *next));
}

/// `(defconst NAME NUMBER)`
Constant constantOf(Builder& builder, const Node& node) {
  Parts parts(node);
  const Name head = builder.nameOf(*parts.take());
  Constant constant{takeName(builder, parts, head), {}};
  constexpr auto kNeeds = "a number, such as `(defconst speed 2)`";
  const Node* value = parts.take();
  const Offset end = constant.name.range.end;
  constant.value.range = value ? value->range : Range{end, end};
  if (value && value->kind == NodeKind::Number)
    constant.value = expressionOf(builder, *value);
  else if (value && !isDamaged(*value))
    builder.report(Code::MalformedValue, value->range, head.text, kNeeds);
  else if (!value && constant.name)
    builder.report(Code::MissingValue, head.range, head.text, kNeeds);
  builder.reportSurplus(parts, "the number");
  return constant;
}

StateVariable stateVariableOf(Builder& builder, Definition& definition) {
  StateVariable variable;
  variable.name = definition.name;
  variable.fields = definition.uses;
  variable.init.range = {definition.name.range.end, definition.name.range.end};
  for (Field& field : definition.fields) {
    switch (field.kind) {
    case NodeKind::InitField: readInit(builder, field, variable); break;
    case NodeKind::MinField: variable.min = valueField(builder, field, "a number"); break;
    case NodeKind::MaxField: variable.max = valueField(builder, field, "a number"); break;
    case NodeKind::StatesField: readStates(builder, field, variable); break;
    default: readTransitions(builder, field, variable);
    }
  }
  return variable;
}

Event eventOf(Builder& builder, Definition& definition) {
  Event event{definition.name, definition.uses, {}, {}, {}};
  event.effects.range = {definition.name.range.end, definition.name.range.end};
  for (Field& field : definition.fields)
    if (field.kind == NodeKind::EveryField)
      event.every = intervalOf(builder, field);
    else if (field.kind == NodeKind::GuardField)
      event.guard = conditionOf(builder, field);
    else
      event.effects = takeEffects(builder, field.values, field.use.keyword);
  return event;
}

Resource resourceOf(Builder& builder, Definition& definition) {
  Resource resource{definition.name, definition.uses, {}};
  for (Field& field : definition.fields) resource.capacity = valueField(builder, field, "a number");
  return resource;
}

Environment environmentOf(Builder& builder, Definition& definition) {
  constexpr auto kNeeds = "a list of statements, such as `((emit gust) (^ 2))`";
  Environment environment{definition.name, definition.uses, {}};
  environment.body.range = {definition.name.range.end, definition.name.range.end};
  for (Field& field : definition.fields) {
    const Node* value = onlyValue(builder, field, kNeeds);
    if (value && value->kind == NodeKind::Block)
      environment.body = blockOf(builder, *value);
    else if (value)
      reportMalformed(builder, field, *value, kNeeds);
  }
  return environment;
}

Skill skillOf(Builder& builder, Definition& definition) {
  Skill skill;
  skill.name = definition.name;
  skill.fields = definition.uses;
  readSkill(builder, definition.fields, skill);
  return skill;
}

/// The path in a form that names a file. \param missing reported if there is none
Name pathOf(Builder& builder, const Node& node, syntax::CodeFor<0> missing) {
  Parts parts(node);
  Name head = builder.nameOf(*parts.take());
  if (const Node* text = parts.take(NodeKind::String)) {
    builder.reportSurplus(parts, "the file's name");
    Name path = contentOf(builder, *text);
    if (!path && !isDamaged(*text)) builder.report(missing, head.range);
    return path;
  }
  if (!parts.peek() || !isDamaged(*parts.peek())) builder.report(missing, head.range);
  return {{}, {head.range.end, head.range.end}};
}

UnknownForm unknownFormOf(Builder& builder, const Node& node) {
  Parts parts(node);
  const Node* head = parts.take();
  if (!head) {
    builder.report(Code::EmptyForm, node.range);
    return {};
  }
  if (!isDamaged(*head))
    suggest(builder.report(Code::UnknownDefinition, head->range, builder.textOf(*head)),
            nearest(builder.textOf(*head), kDefinitionWords));
  if (!isWord(*head)) return {};
  const Node* name = parts.take();
  return {builder.nameOf(*head), name && isWord(*name) ? builder.nameOf(*name) : Name{}};
}

ReadForm formOf(Builder& builder, const Node& node) {
  ReadForm form;
  form.range = node.range;
  if (const Node* head = Parts(node).take()) form.keyword = builder.nameOf(*head);
  switch (node.kind) {
  case NodeKind::List: form.node = unknownFormOf(builder, node); return form;
  case NodeKind::Include:
    form.node = Include{pathOf(builder, node, Code::MissingPath)};
    return form;
  case NodeKind::Platform:
    form.node = Platform{pathOf(builder, node, Code::MissingPlatformPath)};
    return form;
  case NodeKind::Constant: form.node = constantOf(builder, node); return form;
  case NodeKind::Property: form.node = propertyOf(builder, node); return form;
  default: break;
  }
  Definition definition = definitionOf(builder, node);
  switch (node.kind) {
  case NodeKind::StateVariable: form.node = stateVariableOf(builder, definition); break;
  case NodeKind::Event: form.node = eventOf(builder, definition); break;
  case NodeKind::Resource: form.node = resourceOf(builder, definition); break;
  case NodeKind::Environment: form.node = environmentOf(builder, definition); break;
  default: form.node = skillOf(builder, definition);
  }
  return form;
}

bool isForm(const Node& node) {
  switch (node.kind) {
  case NodeKind::List:
  case NodeKind::Include:
  case NodeKind::Platform:
  case NodeKind::Constant:
  case NodeKind::StateVariable:
  case NodeKind::Event:
  case NodeKind::Skill:
  case NodeKind::Resource:
  case NodeKind::Property:
  case NodeKind::Environment: return true;
  default: return false;
  }
}

/// Reports words between forms, up to the next form, as one error.
void reportStray(Builder& builder, const Node& first, Parts& parts) {
  bool damaged = isDamaged(first);
  Range range = first.range;
  while (parts.peek() && !isForm(*parts.peek()) && parts.peek()->kind != NodeKind::SurplusClose) {
    damaged |= isDamaged(*parts.peek());
    range.end = parts.take()->range.end;
  }
  if (!damaged) builder.report(Code::StrayText, range);
}

} // namespace

std::vector<ReadForm> formsOf(Builder& builder, const Tree& tree) {
  std::vector<ReadForm> forms;
  Parts parts(tree.front());
  while (const Node* part = parts.take()) {
    if (isForm(*part))
      forms.push_back(formOf(builder, *part));
    else if (part->kind != NodeKind::SurplusClose)
      reportStray(builder, *part, parts);
  }
  return forms;
}

} // namespace proskill::syntax
