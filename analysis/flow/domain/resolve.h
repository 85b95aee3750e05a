#pragma once

#include "analysis/flow/domain/effect.h"
#include "analysis/flow/domain/inputs.h"

namespace proskill::analysis::flow {

/// Resolves the names in conditions and effects to variables. Total: what it does not understand
/// becomes unknown or is omitted.
class Resolver {
public:
  Resolver(const Program& program, const Variables& variables)
      : program(program), variables(variables), inputs(program, variables) {}

  [[nodiscard]] std::optional<VariableId> stateVariable(std::string_view name) const;
  [[nodiscard]] std::optional<std::size_t> skill(std::string_view name) const;

  /// Appends every variable that an expression reads.
  void addReads(const syntax::Expr& expr, std::vector<VariableId>& reads) const;
  [[nodiscard]] Condition condition(const syntax::Expr& expr, const Slots& slots) const;
  [[nodiscard]] std::vector<Assignment> assignments(const syntax::Effects& effects,
                                                    const Slots& slots) const;
  [[nodiscard]] Assignment constant(VariableId variable, std::int64_t number,
                                    const Slots& slots) const;

private:
  [[nodiscard]] std::optional<VariableId> variableOf(const syntax::Expr& expr) const;
  [[nodiscard]] const Inputs::Input* inputOf(const syntax::Expr& expr, const Slots& slots) const;
  [[nodiscard]] const Domain* wordsOf(const syntax::Expr& expr, const Slots& slots) const;
  [[nodiscard]] Term term(const syntax::Expr& expr, const Domain* beside, const Slots& slots) const;
  [[nodiscard]] Condition compare(Comparison comparison, const syntax::Expr& left,
                                  const syntax::Expr& right, const Slots& slots) const;
  [[nodiscard]] Condition truth(const syntax::Expr& parameter, const Slots& slots) const;
  [[nodiscard]] Condition implication(const syntax::Expr& from, const syntax::Expr& to,
                                      const Slots& slots) const;
  [[nodiscard]] Condition connective(Condition::Kind kind, const syntax::Expr& expr,
                                     const Slots& slots) const;

  const Program& program;
  const Variables& variables;
  Inputs inputs;
};

} // namespace proskill::analysis::flow
