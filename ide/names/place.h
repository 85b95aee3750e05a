#pragma once

#include "ide/names/path.h"
#include "ide/names/vocabulary.h"

/// What is allowed at a place of a program, according to the open lists.
namespace proskill::ide {

enum class Slot : std::uint8_t {
  Nothing, ///< a new name, a number, or something that cannot be guessed
  Definition,
  IncludePath,
  PlatformPath,
  Field,          ///< a keyword of `Place::fields`
  OutcomeClause,  ///< `(:effects …)` after a tag, or the next field
  InitialValue,   ///< of the state variable `subject`, or a list of them
  VariableValue,  ///< of the state variable `subject`
  Transitions,    ///< `:all`, or a list
  TransitionList, ///< pairs
  Transition,     ///< a value in a pair
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
  Fair,        ///< `t`, `nil`, or a list of skills
  Effects,     ///< an effect or a list of effects
  EffectItem,  ///< an effect in a list
  EffectValue, ///< for the state variable `subject`
  Condition,
  Proposition, ///< a condition of a property
  Temporal,    ///< a formula of linear temporal logic
  Operand,     ///< a value compared with `subject`, which may be empty
  Number,      ///< a value that is a number
  Constant,    ///< a number, or a constant
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
  /// The cursor is at the start of a list that belongs to the slot, so completions must not add a
  /// parenthesis.
  bool isHead = false;
  WordKind fields = WordKind::SkillField; ///< Field, OutcomeClause
  std::string_view subject;
  std::string_view argument;
  std::string_view definition;    ///< `defskill`, … of the enclosing definition
  std::string_view owner;         ///< its name
  const OpenList* list = nullptr; ///< the innermost list; null at the top level
};

/// \pre the path outlives the place
[[nodiscard]] Place placeOf(const Path& path);

/// The same for the first `depth` lists of the path: the meaning of the next list.
[[nodiscard]] Place placeOf(const Path& path, std::size_t depth);

/// The fields of definitions with this keyword; null if there are none.
[[nodiscard]] const WordKind* fieldsOf(std::string_view definition);

} // namespace proskill::ide
