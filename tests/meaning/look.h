#pragma once

#include "tests/meaning/situation.h"

namespace proskill::meaning {

/// Whether a condition is true at a moment. \param thread whose body contains it; nobody for
/// guards, preconditions, postconditions and properties
class Look {
public:
  Look(const Script& of, const Situation& at) : script(of), now(at) {}

  [[nodiscard]] bool holds(const syntax::Expr& condition, int thread = kNobody) const;
  [[nodiscard]] std::int64_t number(const syntax::Expr& value) const;
  /// The state of a variable that a word names: its own, or the value of another variable.
  [[nodiscard]] std::int64_t stateOf(int variable, std::string_view word) const;
  /// A value for a variable: a number, a word, or an argument of the current call.
  [[nodiscard]] std::int64_t valueFor(int variable, const syntax::Expr& value) const;

  /// Whether every guard of the skill is true.
  [[nodiscard]] bool guardsHold(int skill) const;
  /// Whether it ends early and waits for its callees, which may have to finish. Its guards then no
  /// longer hold up others.
  [[nodiscard]] bool lingers(int skill) const;
  /// Whether a skill runs with a false guard.
  [[nodiscard]] bool someGuardFails() const;
  [[nodiscard]] bool preconditionHolds(int skill) const;

private:
  [[nodiscard]] bool isTruth(const syntax::Expr& expr) const;
  [[nodiscard]] bool isEnumeration(const syntax::Expr& expr) const;
  [[nodiscard]] std::int64_t given(const syntax::Expr& parameter) const;
  [[nodiscard]] int variableOf(const syntax::Expr& expr) const;
  [[nodiscard]] bool equal(const syntax::Expr& a, const syntax::Expr& b, int thread) const;
  [[nodiscard]] bool hasValue(std::string_view variable, const syntax::Expr& value) const;
  [[nodiscard]] std::string_view wordOf(const syntax::Expr& expr, int thread) const;
  /// The outcome of the body's own last call if it calls the skill, otherwise of the last call by
  /// anybody.
  [[nodiscard]] Outcome outcomeOf(std::string_view skill, int thread) const;

  const Script& script;
  const Situation& now;
};

[[nodiscard]] std::string_view wordOf(Status status);

} // namespace proskill::meaning
