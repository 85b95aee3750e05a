#pragma once

#include "tests/meaning/situation.h"

namespace proskill::meaning {

/// Whether a condition holds at a moment; `thread` is whose body it stands in, nobody for guards,
/// preconditions, postconditions and properties.
class Look {
public:
  Look(const Script& of, const Situation& at) : script(of), now(at) {}

  [[nodiscard]] bool holds(const syntax::Expr& condition, int thread = kNobody) const;
  [[nodiscard]] std::int64_t number(const syntax::Expr& value) const;
  /// Which of a variable's states a word names: one of its own, or another variable's value.
  [[nodiscard]] std::int64_t stateOf(int variable, std::string_view word) const;

  /// Every guard of the skill, if it has any, is true.
  [[nodiscard]] bool guardsHold(int skill) const;
  /// It ends early, and waits for what it called, which may be one that must not be stopped. Then
  /// nobody waits for it because of its guards.
  [[nodiscard]] bool lingers(int skill) const;
  /// A skill runs of which a guard is false.
  [[nodiscard]] bool someGuardFails() const;
  [[nodiscard]] bool preconditionHolds(int skill) const;

private:
  [[nodiscard]] bool isEnumeration(const syntax::Expr& expr) const;
  [[nodiscard]] bool equal(const syntax::Expr& a, const syntax::Expr& b, int thread) const;
  [[nodiscard]] bool hasValue(std::string_view variable, const syntax::Expr& value) const;
  [[nodiscard]] std::string_view wordOf(const syntax::Expr& expr, int thread) const;
  /// Of its own last call where the body calls it, else of the last call by anybody.
  [[nodiscard]] Outcome outcomeOf(std::string_view skill, int thread) const;

  const Script& script;
  const Situation& now;
};

[[nodiscard]] std::string_view wordOf(Status status);

} // namespace proskill::meaning
