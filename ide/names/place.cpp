#include "ide/names/place.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

namespace proskill::ide {

namespace {

using Items = std::span<const Item>;

/// A place without a list and a head.
Place just(Slot slot, std::string_view subject = {}) { return {.slot = slot, .subject = subject}; }

Place field(WordKind kind) { return {.slot = Slot::Field, .fields = kind}; }

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

/// The last keyword before the cursor, and the number of items after it. A value with a colon
/// (`:all`) does not count.
const Item* lastKeyword(Items items, std::size_t& after) {
  for (auto i = items.size(); i-- > 0;)
    if (items[i].isKeyword() && items[i].text != ":all") {
      after = items.size() - i - 1;
      return &items[i];
    }
  return nullptr;
}

bool lastIsWord(Items items) { return !items.empty() && !items.back().isList(); }

/// The value of a field of a definition or clause: `after` items follow the keyword.
struct FieldValue {
  std::string_view keyword;
  Slot slot;
};
constexpr std::array kFieldValues{
    FieldValue{":init", Slot::InitialValue},
    FieldValue{":states", Slot::Nothing},
    FieldValue{":min", Slot::Constant},
    FieldValue{":max", Slot::Constant},
    FieldValue{":transitions", Slot::Transitions},
    FieldValue{":capacity", Slot::Constant},
    FieldValue{":every", Slot::Interval},
    FieldValue{":effects", Slot::Effects},
    FieldValue{":guard", Slot::Condition},
    FieldValue{":postcondition", Slot::Condition},
    FieldValue{":input", Slot::InputList},
    FieldValue{":precondition", Slot::PreconditionList},
    FieldValue{":start", Slot::Effects},
    FieldValue{":invariant", Slot::InvariantList},
    FieldValue{":time_interval", Slot::Interval},
    FieldValue{":action", Slot::Command},
    FieldValue{":interrupt", Slot::InterruptClause},
    FieldValue{":interruptible", Slot::Interruptible},
    FieldValue{":success", Slot::OutcomeTag},
    FieldValue{":failure", Slot::OutcomeTag},
    FieldValue{":resources", Slot::ResourceList},
    FieldValue{":monitor", Slot::Monitor},
    FieldValue{":body", Slot::Body},
    FieldValue{":after", Slot::Proposition},
    FieldValue{":before", Slot::Proposition},
    FieldValue{":within", Slot::Interval},
    FieldValue{":for", Slot::Interval},
    FieldValue{":lasting", Slot::Constant},
    FieldValue{":fair", Slot::Fair},
};

Place valueOf(const Item& keyword) {
  auto found = std::ranges::find(kFieldValues, keyword.text, &FieldValue::keyword);
  return just(found == kFieldValues.end() ? Slot::Nothing : found->slot);
}

/// In a definition or a clause, after the parts that precede its fields.
Place amongFields(Items items, WordKind fields) {
  std::size_t after = 0;
  const Item* keyword = lastKeyword(items, after);
  if (!keyword) return field(fields);
  if (after == 0) return valueOf(*keyword);
  const bool isOutcome = isOneOf(keyword->text, {":success", ":failure"});
  if (isOutcome && after == 1 && lastIsWord(items))
    return {.slot = Slot::OutcomeClause, .fields = fields};
  return field(fields);
}

Place inDefinition(Items items) {
  const auto head = items.front().text;
  if (head == "include") return just(items.size() == 1 ? Slot::IncludePath : Slot::Nothing);
  if (head == "defplatform") return just(items.size() == 1 ? Slot::PlatformPath : Slot::Nothing);
  if (items.size() == 1) return just(Slot::Nothing);
  if (head == "defproperty") return just(items.size() == 2 ? Slot::Pattern : Slot::Nothing);
  const auto* fields = fieldsOf(head);
  return fields ? amongFields(items.subspan(2), *fields) : just(Slot::Nothing);
}

Place inPattern(Items items) {
  const auto head = items.front().text;
  std::size_t after = 0;
  if (lastKeyword(items, after)) return amongFields(items, WordKind::PatternField);
  if (head == "ltl" && items.size() == 1) return just(Slot::Temporal);
  const std::size_t operands =
      isOneOf(head, {"leadsto", "precedes", "longest", "shortest"}) ? 2 : 1;
  if (items.size() <= operands && head != "deadlockfree") return just(Slot::Proposition);
  return field(WordKind::PatternField);
}

/// The other operand of a comparison, if it determines what is allowed here.
Place inComparison(Items items) {
  if (isOneOf(items.front().text, {"=", "/="}))
    return just(Slot::Operand, items.size() == 2 ? items[1].text : std::string_view());
  return just(Slot::Number);
}

Place inObservation(Items items) {
  const auto head = items.front().text;
  const bool first = items.size() == 1;
  if (head == "occurs") return just(first ? Slot::Event : Slot::Nothing);
  if (head == "at") return just(first ? Slot::AnyLabel : Slot::Nothing);
  if (head == "value")
    return first ? just(Slot::Variable) : just(Slot::VariableValue, items[1].text);
  if (first) return just(Slot::Skill);
  return just(head == "ended" && items.size() == 2 ? Slot::Status : Slot::Nothing);
}

/// A list in place of a condition; `outer` is the kind of condition.
Place inCondition(Items items, Slot outer) {
  const auto head = items.front().text;
  if (items.front().isList()) return just(outer);
  if (findWord(WordKind::Connective, head)) return just(outer);
  if (findWord(WordKind::Comparison, head)) return inComparison(items);
  if (findWord(WordKind::Arithmetic, head)) return just(Slot::Number);
  const bool inProperty = outer == Slot::Proposition || outer == Slot::Temporal;
  if (inProperty && findWord(WordKind::Observation, head)) return inObservation(items);
  if (outer == Slot::Temporal && findWord(WordKind::Temporal, head)) // or a variable: `(F On)`
    return just(outer, items.size() == 1 ? head : std::string_view());
  return items.size() == 1 ? just(Slot::VariableValue, head) : just(Slot::Nothing);
}

Place inEffect(Items items) {
  if (items.size() != 1) return just(Slot::Nothing);
  return just(Slot::EffectValue, items.front().text);
}

Place inWait(Items items) {
  if (items.size() == 1) return just(Slot::WaitCondition);
  std::size_t after = 0;
  const Item* keyword = lastKeyword(items, after);
  if (keyword && keyword->text == ":timeout")
    return just(after == 0 ? Slot::Constant : Slot::TimeoutStatement);
  if (keyword) return amongFields(items, WordKind::WaitField);
  return field(WordKind::WaitField);
}

Place inIf(Items items) {
  if (items.size() == 1 || items.back().text == "elseif") return just(Slot::Condition);
  return just(Slot::IfStatement);
}

Place inDo(Items items) {
  if (items.back().text == "until") return just(Slot::Condition);
  const bool tested = items.size() > 2 && items[items.size() - 2].text == "until";
  return just(tested ? Slot::Nothing : Slot::DoStatement);
}

/// Names and values alternate. Unexpected items are skipped, as in the grammar.
Place inCall(Items items) {
  std::string_view name;
  for (const Item& item : items.subspan(1)) {
    const bool isName = name.empty() && !item.isList();
    name = isName ? item.text : std::string_view();
  }
  Place place = just(name.empty() ? Slot::ArgumentName : Slot::ArgumentValue, items.front().text);
  place.argument = name;
  return place;
}

/// First the call, then the arms.
Place inCase(Items items) {
  return just(std::ranges::any_of(items, &Item::isList) ? Slot::CaseArm : Slot::CaseCall);
}

/// First an outcome, or a list of an outcome and tags; then statements.
Place inArm(Items items) {
  if (items.empty()) return {.slot = Slot::CasePattern, .isHead = true};
  return just(Slot::Statement);
}

Place inCasePattern(Items items) {
  if (items.empty()) return {.slot = Slot::CasePattern, .isHead = true};
  return just(Slot::CaseTag, items.front().text);
}

Place inStatement(Items items) {
  const auto head = items.front().text;
  const bool first = items.size() == 1;
  auto name = [&](Slot slot) { return just(first ? slot : Slot::Nothing); };
  if (items.front().isList()) return just(Slot::Statement);
  if (head == "^") return inWait(items);
  if (head == "if") return inIf(items);
  if (head == "case") return inCase(items);
  if (head == "do") return inDo(items);
  if (isOneOf(head, {"while", "do-until"})) return just(first ? Slot::Condition : Slot::Statement);
  if (isOneOf(head, {"//", "race", "choose"})) return just(Slot::Branch);
  if (head == "set") return just(Slot::Effects);
  if (head == "printf") return just(first ? Slot::Nothing : Slot::PrintArgument);
  if (head == "goto") return name(Slot::Label);
  if (head == "success") return name(Slot::SuccessTag);
  if (head == "failure") return name(Slot::FailureTag);
  if (head == "emit") return name(Slot::Event);
  const bool isNoCall = isOneOf(head, {"label", "break"}) || head.contains('.');
  return isNoCall ? just(Slot::Nothing) : inCall(items);
}

/// Contents of an expression.
Place inValue(Items items) {
  const auto head = items.front().text;
  return just(findWord(WordKind::Arithmetic, head) ? Slot::Number : Slot::Nothing);
}

/// Tags, each followed by its statements or conditions.
Place inTagged(Items items, Slot list, Slot value) {
  return just(lastIsWord(items) ? value : list);
}

/// What may follow `items`, of which there is at least one, in a list in place of `outer`.
Place behind(Items items, Slot outer) {
  switch (outer) {
  case Slot::Definition: return inDefinition(items);
  case Slot::Pattern: return inPattern(items);
  case Slot::Command: return just(Slot::CommandArgument);
  case Slot::Effects: return items.front().isList() ? just(Slot::EffectItem) : inEffect(items);
  case Slot::EffectItem: return inEffect(items);
  case Slot::EffectValue:
  case Slot::Number:
  case Slot::Operand:
  case Slot::VariableValue:
  case Slot::PrintArgument:
  case Slot::ArgumentValue: return inValue(items);
  case Slot::Condition:
  case Slot::Proposition:
  case Slot::Temporal: return inCondition(items, outer);
  case Slot::WaitCondition: return inCondition(items, Slot::Condition);
  case Slot::Statement:
  case Slot::IfStatement:
  case Slot::TimeoutStatement:
  case Slot::DoStatement: return inStatement(items);
  case Slot::CaseCall: return inCall(items);
  default: return just(Slot::Nothing);
  }
}

/// `:success (done (…) partly (…))`, or its clause directly.
Place inOutcomes(Items items) {
  if (!items.empty() && items.front().isKeyword())
    return amongFields(items, WordKind::OutcomeField);
  Place place = inTagged(items, Slot::OutcomeTag, Slot::OutcomeClause);
  place.fields = WordKind::OutcomeField;
  return place;
}

/// Lists without a head.
std::optional<Place> withoutHead(Items items, Slot outer) {
  switch (outer) {
  case Slot::InitialValue: return just(Slot::VariableValue);
  case Slot::Transitions: return just(Slot::TransitionList);
  case Slot::TransitionList: return just(items.size() < 2 ? Slot::Transition : Slot::Nothing);
  case Slot::ResourceList: return just(Slot::Resource);
  case Slot::Fair: return just(Slot::Skill);
  case Slot::InputList: return inTagged(items, Slot::InputList, Slot::InputType);
  case Slot::PreconditionList: return inTagged(items, Slot::PreconditionList, Slot::Condition);
  case Slot::InvariantList: return inTagged(items, Slot::InvariantList, Slot::InvariantClause);
  case Slot::InterruptClause: return amongFields(items, WordKind::InterruptField);
  case Slot::InvariantClause: return amongFields(items, WordKind::InvariantField);
  case Slot::OutcomeClause: return amongFields(items, WordKind::OutcomeField);
  case Slot::OutcomeTag: return inOutcomes(items);
  case Slot::CaseArm: return inArm(items);
  case Slot::CasePattern: return inCasePattern(items);
  case Slot::Body:
  case Slot::Branch: return just(Slot::Statement);
  default: return std::nullopt;
  }
}

Place within(const OpenList& list, Slot outer) {
  if (auto place = withoutHead(list.items, outer)) return *place;
  // a list is not allowed where a keyword is expected
  if (outer == Slot::Field) return just(Slot::Nothing);
  if (list.items.empty()) return {.slot = outer, .isHead = true};
  return behind(list.items, outer);
}

} // namespace

const WordKind* fieldsOf(std::string_view definition) {
  static constexpr std::array kFields{
      std::pair{std::string_view("defsv"), WordKind::VariableField},
      std::pair{std::string_view("defevent"), WordKind::EventField},
      std::pair{std::string_view("defskill"), WordKind::SkillField},
      std::pair{std::string_view("defresource"), WordKind::ResourceField},
      std::pair{std::string_view("defenvironment"), WordKind::EnvironmentField},
  };
  const auto* found =
      std::ranges::find(kFields, definition, [](const auto& it) { return it.first; });
  return found == kFields.end() ? nullptr : &found->second;
}

Place placeOf(const Path& path, std::size_t depth) {
  Place place = just(Slot::Definition);
  for (const OpenList& list : std::span(path.lists).first(depth)) {
    place = within(list, place.slot);
    place.list = &list;
  }
  if (depth > 0) {
    const auto& items = path.lists.front().items;
    if (!items.empty()) place.definition = items[0].text;
    if (items.size() > 1) place.owner = items[1].text;
  }
  const bool isOwn = place.slot == Slot::VariableValue || place.slot == Slot::InitialValue ||
                     place.slot == Slot::Transition;
  if (isOwn && place.subject.empty()) place.subject = place.owner;
  return place;
}

Place placeOf(const Path& path) {
  Place place = placeOf(path, path.lists.size());
  if (path.isInInterval) place.slot = Slot::Constant;
  return place;
}

} // namespace proskill::ide
