#pragma once

#include "analysis/flow/domain/state.h"

#include <vector>

namespace proskill::analysis::flow {

/// A value in a condition or an effect, its names resolved to slots.
struct Term {
  enum class Kind : std::uint8_t { Unknown, Number, Variable, Add, Subtract };
  Kind kind = Kind::Unknown;
  std::int64_t number = 0;
  Slot slot = 0;
  const Domain* domain = nullptr; ///< Variable
  std::vector<Term> operands;

  [[nodiscard]] bool reads(Slot slot) const;
};

/// The numbers that a term may have; nothing where that is unknown.
[[nodiscard]] std::optional<std::vector<Span>> evaluate(const Term& term, const State& state);

enum class Comparison : std::uint8_t { Equal, NotEqual, Less, LessEqual, Greater, GreaterEqual };
/// Holds where the other fails.
[[nodiscard]] Comparison negated(Comparison comparison);

/// A condition over the slots of one process.
struct Condition {
  enum class Kind : std::uint8_t { Unknown, Constant, Member, Compare, And, Or, Not };
  Kind kind = Kind::Unknown;
  bool constant = false;
  Slot slot = 0;           ///< Member: of this variable
  ValueSet holds;          ///< Member: the classes where it may hold
  ValueSet fails;          ///< Member: the classes where it may fail
  Comparison comparison{}; ///< Compare: of two terms
  std::vector<Term> terms;
  std::vector<Slot> slots; ///< Compare: what the terms read
  std::vector<Condition> operands;
};

/// Keeps of a state what is possible where the condition holds, or fails. Sound: nothing goes that
/// could be; not always all that cannot be goes, since variables are seen one by one.
void refine(State& state, const Condition& condition, bool holds);
/// The same of a conjunction.
void refineAll(State& state, const std::vector<Condition>& conditions, bool holds);

[[nodiscard]] bool mayHold(const State& state, const Condition& condition);
[[nodiscard]] bool mayFail(const State& state, const Condition& condition);

} // namespace proskill::analysis::flow
