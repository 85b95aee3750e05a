#pragma once

#include "tests/meaning/runs.h"

#include "codegen/model.h"
#include "verify/verify.h"

namespace proskill::meaning {

/// Truth of properties, by the second semantics.
class Verdicts {
public:
  Verdicts(const Script& of, const Runs& explored) : script(of), runs(explored) {}

  /// Whether the verifier's question is answered by yes, as the property is written: what is absent
  /// never happens. nullopt for unknown kinds of questions.
  [[nodiscard]] std::optional<bool> isTrue(const codegen::Check& check,
                                           const fiacre::Origin& place) const;

  /// The answer to a question for a time. nullopt for other questions, and if there are too many
  /// situations.
  [[nodiscard]] std::optional<verify::Duration> duration(const codegen::Check& check) const;

private:
  [[nodiscard]] std::optional<bool> isTrue(const syntax::Property& property) const;
  [[nodiscard]] bool isTrueAt(const syntax::Expr& wish, const Situation& situation,
                              const std::vector<Fact>& facts) const;
  [[nodiscard]] bool sometimes(const syntax::Expr& wish, bool value) const;
  [[nodiscard]] std::vector<bool> avoiding(const syntax::Property& property,
                                           const syntax::Expr& wish) const;
  [[nodiscard]] bool canAlwaysReach(const syntax::Expr& wish) const;
  [[nodiscard]] bool canMiss(const syntax::Property& property) const;
  [[nodiscard]] bool canPrecede(const syntax::Expr& late, const syntax::Expr& early) const;
  [[nodiscard]] bool isAt(std::string_view label, const Situation& situation) const;
  [[nodiscard]] std::optional<Fact> factOf(const codegen::Check& check,
                                           const fiacre::Origin& place) const;

  const Script& script;
  const Runs& runs;
};

} // namespace proskill::meaning
