#pragma once

#include "ide/names/path.h"
#include "ide/names/vocabulary.h"

/// What may stand at a place of a program, told from the lists that are open there.
namespace proskill::ide {

enum class Slot : std::uint8_t {
  Nothing, ///< a new name, a number, or what nobody can guess
  Definition,
  IncludePath,
  Field,          ///< a keyword of `Place::fields`
  OutcomeClause,  ///< `(:effects …)` after a tag, or the next field
  VariableValue,  ///< of the state variable `subject`
  Transitions,    ///< `:all`, or a list
  TransitionList, ///< pairs
  Transition,     ///< one value of a pair
  InputList,      ///< a new parameter
  InputType,
  PreconditionList, ///< a new tag
  InvariantList,    ///< a new tag
  InvariantClause,  ///< `(:guard …)`
  OutcomeTag,       ///< a new tag, or a list
  InterruptClause,  ///< `(:effects …)`
  Interval,
  Command, ///< of an action
  CommandArgument,
  Resource, ///< within `:resources`
  ResourceList,
  Monitor,
  Interruptible,
  Effects,     ///< one or a list of them
  EffectItem,  ///< one of a list
  EffectValue, ///< for the state variable `subject`
  Condition,
  Proposition, ///< a condition of a property
  Temporal,    ///< a formula of linear temporal logic
  Operand,     ///< a value beside `subject`, which may be empty
  Number,      ///< a value that is a number
  Body,        ///< a list of statements
  Statement,
  IfStatement,      ///< or `elseif`, `else`
  DoStatement,      ///< or `until`
  TimeoutStatement, ///< or a keyword of a wait
  Branch,           ///< a list of statements
  CaseCall,         ///< the call of a `case`
  CaseArm,          ///< an arm of a `case`
  CasePattern,      ///< an outcome, or a list of one with tags
  CaseTag,          ///< of the outcome `subject`
  WaitCondition,    ///< a condition or a time
  Label,
  AnyLabel,
  SuccessTag,
  FailureTag,
  Event,
  Skill,
  Status,
  Variable,
  ArgumentName,  ///< of a call of the skill `subject`
  ArgumentValue, ///< for its input `argument`
  PrintArgument,
  Pattern,
};

struct Place {
  Slot slot = Slot::Nothing;
  /// The cursor stands first in a list that is for the slot: what is offered has its parenthesis.
  bool isHead = false;
  WordKind fields = WordKind::SkillField; ///< Field, OutcomeClause
  std::string_view subject;
  std::string_view argument;
  std::string_view definition;    ///< `defskill`, … around the place
  std::string_view owner;         ///< the name of that definition
  const OpenList* list = nullptr; ///< the innermost list; null at the top level
};

/// \pre the path outlives the place
[[nodiscard]] Place placeOf(const Path& path);

/// The same for the first `depth` lists of the path: what the list behind them stands for.
[[nodiscard]] Place placeOf(const Path& path, std::size_t depth);

/// The fields of the definition that begins with this word; null where it has none.
[[nodiscard]] const WordKind* fieldsOf(std::string_view definition);

} // namespace proskill::ide
