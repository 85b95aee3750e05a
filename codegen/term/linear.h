#pragma once

#include "codegen/term/context.h"

#include <utility>

namespace proskill::codegen {

/// A sum of naturals: a coefficient for each variable, and a constant. Comparisons are printed
/// without negative terms on either side, since Fiacre's naturals must not be negative in between.
class Linear {
public:
  /// \pre `expr` consists of numbers, state variables and inputs that are naturals, `+` and `-`
  Linear(Context& context, const syntax::Expr& expr);
  explicit Linear(std::int64_t value) : constant(value) {}

  [[nodiscard]] Linear minus(const Linear& other) const;
  /// The least and the greatest value within the variables' bounds.
  [[nodiscard]] std::pair<std::int64_t, std::int64_t> range() const;
  [[nodiscard]] fiacre::Expr expr() const;

  /// The comparison `left op right`; a constant if only one result is possible.
  [[nodiscard]] static fiacre::Expr compare(fiacre::Op op, const Linear& left, const Linear& right);

private:
  struct Term {
    std::string variable; ///< its name in the model
    std::int64_t factor = 0;
    std::int64_t low = 0;
    std::int64_t high = 0;
  };

  void add(Context& context, const syntax::Expr& expr, std::int64_t sign);
  void addTerm(const Term& term);
  [[nodiscard]] fiacre::Expr part(bool positive) const;

  std::vector<Term> terms;
  std::int64_t constant = 0;
};

/// The least and the greatest value of a natural.
[[nodiscard]] std::pair<std::int64_t, std::int64_t> domainOf(const syntax::StateVariable& natural);

} // namespace proskill::codegen
