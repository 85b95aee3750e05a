#pragma once

#include "analysis/flow/domain/state.h"

#include <vector>

namespace proskill::analysis::flow {

/// A value in a condition or an effect, with names resolved to slots.
struct Term {
  enum class Kind : std::uint8_t { Unknown, Number, Any, Variable, Add, Subtract };
  Kind kind = Kind::Unknown;
  std::int64_t number = 0;
  const std::vector<Span>* spans = nullptr; ///< Any: one of these, an input of the skill
  Slot slot = 0;
  const Domain* domain = nullptr; ///< for a Variable
  std::vector<Term> operands;

  [[nodiscard]] bool reads(Slot slot) const;
};

/// The possible values of a term; nothing if they are unknown.
[[nodiscard]] std::optional<std::vector<Span>> evaluate(const Term& term, const State& state);

enum class Comparison : std::uint8_t { Equal, NotEqual, Less, LessEqual, Greater, GreaterEqual };
/// The comparison that holds exactly if this one does not.
[[nodiscard]] Comparison negated(Comparison comparison);

/// A condition over the slots of one process.
struct Condition {
  enum class Kind : std::uint8_t { Unknown, Constant, Member, Compare, And, Or, Not };
  Kind kind = Kind::Unknown;
  bool constant = false;
  Slot slot = 0;           ///< Member: the variable that is tested
  ValueSet holds;          ///< Member: the classes for which it may hold
  ValueSet fails;          ///< Member: the classes for which it may fail
  Comparison comparison{}; ///< Compare: applied to two terms
  std::vector<Term> terms;
  std::vector<Slot> slots; ///< Compare: the slots that the terms read
  std::vector<Condition> operands;
};

/// Restricts a state to what is possible if the condition holds, or fails. Sound: keeps everything
/// that is possible. It may keep more, since variables are treated separately.
void refine(State& state, const Condition& condition, bool holds);
/// The same for a conjunction.
void refineAll(State& state, const std::vector<Condition>& conditions, bool holds);

[[nodiscard]] bool mayHold(const State& state, const Condition& condition);
[[nodiscard]] bool mayFail(const State& state, const Condition& condition);

} // namespace proskill::analysis::flow
