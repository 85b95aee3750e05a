#pragma once

#include "codegen/term/context.h"

#include <utility>

namespace proskill::codegen {

/// A sum of naturals as a number for each variable and a constant. Comparisons are printed from it
/// with nothing negative on either side, since Fiacre's naturals must not go below 0 on the way.
class Linear {
public:
  /// \pre `expr` is made of numbers, state variables that are naturals, `+` and `-`.
  Linear(Context& context, const syntax::Expr& expr);
  explicit Linear(std::int64_t value) : constant(value) {}

  [[nodiscard]] Linear minus(const Linear& other) const;
  /// The least and the greatest value that the variables' bounds allow.
  [[nodiscard]] std::pair<std::int64_t, std::int64_t> range() const;
  [[nodiscard]] fiacre::Expr expr() const;

  /// `left op right`, of a comparison; a constant where it can only have one result.
  [[nodiscard]] static fiacre::Expr compare(fiacre::Op op, const Linear& left, const Linear& right);

private:
  struct Term {
    std::string variable; ///< as it is called in the model
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
