#include "ide/names/word_at.h"

#include <algorithm>
#include <initializer_list>

namespace proskill::ide {

namespace {

const Word* firstOf(std::initializer_list<WordKind> kinds, std::string_view text) {
  for (auto kind : kinds)
    if (const Word* found = findWord(kind, text)) return found;
  return nullptr;
}

/// The keyword, depending on the list that contains it.
const Word* keyword(const Place& outer, const OpenList& list, std::string_view text) {
  if (outer.slot == Slot::Definition && !list.items.empty()) {
    const auto* fields = fieldsOf(list.items.front().text);
    return fields ? findWord(*fields, text) : nullptr;
  }
  switch (outer.slot) {
  case Slot::InvariantClause: return findWord(WordKind::InvariantField, text);
  case Slot::InterruptClause: return findWord(WordKind::InterruptField, text);
  case Slot::OutcomeClause:
  case Slot::OutcomeTag: return findWord(WordKind::OutcomeField, text);
  case Slot::Pattern: return findWord(WordKind::PatternField, text);
  default: return findWord(WordKind::WaitField, text);
  }
}

/// The first word of a list.
const Word* head(Slot slot, std::string_view text) {
  switch (slot) {
  case Slot::Definition: return findWord(WordKind::Definition, text);
  case Slot::Pattern: return findWord(WordKind::Pattern, text);
  case Slot::Statement:
  case Slot::IfStatement:
  case Slot::DoStatement:
  case Slot::TimeoutStatement:
    return firstOf({WordKind::Statement, WordKind::EnvironmentStatement}, text);
  case Slot::CaseArm:
  case Slot::CasePattern: return findWord(WordKind::CaseOutcome, text);
  case Slot::Temporal:
  case Slot::Proposition:
    if (const Word* found = findWord(WordKind::Observation, text)) return found;
    if (const Word* found = findWord(WordKind::Temporal, text)) return found;
    [[fallthrough]];
  case Slot::Condition:
  case Slot::WaitCondition:
    return firstOf({WordKind::Connective, WordKind::Comparison, WordKind::Arithmetic}, text);
  case Slot::Number:
  case Slot::Operand:
  case Slot::ArgumentValue:
  case Slot::PrintArgument:
  case Slot::InitialValue:
  case Slot::VariableValue:
  case Slot::EffectValue: return findWord(WordKind::Arithmetic, text);
  default: return nullptr;
  }
}

/// A word that is not the first of its list.
const Word* inner(const Place& place, std::string_view text) {
  switch (place.slot) {
  case Slot::IfStatement:
    if (const Word* found = findWord(WordKind::Clause, text)) return found;
    break;
  case Slot::DoStatement:
    if (const Word* found = findWord(WordKind::Until, text)) return found;
    break;
  case Slot::InputType: return findWord(WordKind::Type, text);
  case Slot::Status: return findWord(WordKind::Status, text);
  case Slot::Operand:
    if (place.subject.ends_with(".status")) return findWord(WordKind::Status, text);
    return place.subject.ends_with(".res") ? findWord(WordKind::Result, text) : nullptr;
  default: break;
  }
  if (text == "break") return findWord(WordKind::Statement, text);
  return findWord(WordKind::Constant, text);
}

} // namespace

const Word* wordAt(const Path& path, std::string_view text) {
  if (path.surrounding != Surrounding::Code || text.empty()) return nullptr;
  if (const auto dot = text.find('.'); dot != std::string_view::npos)
    return findWord(WordKind::Member, text.substr(dot + 1));
  if (path.lists.empty()) return nullptr;
  const auto& list = path.lists.back();
  const Place outer = placeOf(path, path.lists.size() - 1);
  if (text.front() == ':') return keyword(outer, list, text);
  const Place place = placeOf(path);
  return place.isHead ? head(outer.slot, text) : inner(place, text);
}

} // namespace proskill::ide
