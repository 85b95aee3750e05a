#pragma once

#include <cstdint>
#include <span>
#include <string_view>

/// The words of the language itself, with what the manual says of them: one table for all features.
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
  std::string_view form;     ///< how it is written, for a reader
  std::string_view snippet;  ///< what a completion puts behind it, in LSP's syntax of snippets
  std::string_view sentence; ///< the manual's
};

/// All words; those of a kind stand together.
[[nodiscard]] std::span<const Word> vocabulary();
/// The words of one kind, in the order in which a program has them.
[[nodiscard]] std::span<const Word> wordsOf(WordKind kind);
/// Null where the kind has no such word.
[[nodiscard]] const Word* findWord(WordKind kind, std::string_view text);

} // namespace proskill::ide
