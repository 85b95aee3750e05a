#pragma once

#include <cstdint>
#include <span>
#include <string_view>

/// The keywords of the language with their documentation: one table for all features.
namespace proskill::ide {

enum class WordKind : std::uint8_t {
  Definition,
  VariableField,
  EventField,
  SkillField,
  ResourceField,
  EnvironmentField,
  InvariantField,
  InterruptField,
  OutcomeField,
  WaitField,
  PatternField,
  Statement,
  EnvironmentStatement,
  Clause, ///< of an `if`
  Until,  ///< of a `do`
  Connective,
  Comparison,
  Arithmetic,
  Constant,
  Pattern,
  Observation,
  Temporal,
  Type,
  Member,
  Status,
  CaseOutcome, ///< of an arm of a `case`
  Result,
};

struct Word {
  WordKind kind;
  std::string_view text;
  std::string_view form;     ///< how it is written, for users
  std::string_view snippet;  ///< what a completion inserts after it, in LSP's snippet syntax
  std::string_view sentence; ///< from the manual
};

/// All words, grouped by kind.
[[nodiscard]] std::span<const Word> vocabulary();
/// The words of one kind, in their usual order in a program.
[[nodiscard]] std::span<const Word> wordsOf(WordKind kind);
/// Null if the kind has no such word.
[[nodiscard]] const Word* findWord(WordKind kind, std::string_view text);

} // namespace proskill::ide
