#pragma once

#include "analysis/program/program.h"
#include "bridge/pddl/binding.h"
#include "bridge/text/place.h"

#include <map>
#include <set>

namespace proskill::bridge::pddl {

/// Conditions and effects in PDDL. An enumeration becomes a predicate for each of its values, a
/// natural a function. PDDL does not distinguish upper and lower case, so names are in lower case,
/// with a number where two would be equal.
class Terms {
public:
  Terms(const analysis::Program& program, Errors& errors);

  /// The name in PDDL, the same for the same key. \param wish its words; `_` becomes `-`
  std::string name(const std::string& key, std::string_view wish);
  /// The atom that a variable has a value: `(door-open)`.
  std::string has(std::string_view variable, std::string_view value);
  std::string function(std::string_view natural);
  /// The place for errors in what follows.
  void in(analysis::FileId id) { file = id; }
  /// The values of inputs in what follows.
  void bind(const Binding& values) { binding = values; }

  std::string condition(const syntax::Expr& of);
  /// Effects, one per string; those of an enumeration withdraw its other values.
  std::vector<std::string> effects(const syntax::Effects& all);
  /// Conditions before an effect that exclude forbidden moves and numbers out of range.
  std::vector<std::string> allowing(const syntax::Effect& effect);
  /// Effects that make a condition true, as far as it is a conjunction of values.
  /// \return nothing if it is something else
  std::optional<std::vector<std::string>> making(const syntax::Expr& condition);

  bool usesNumbers = false;

private:
  void allowMove(const syntax::StateVariable& variable, const syntax::Expr& value,
                 std::vector<std::string>& to);
  void allowNumber(const syntax::StateVariable& variable, const syntax::Expr& value,
                   std::vector<std::string>& to);
  std::vector<std::string> moves(std::string_view variable, std::string_view value);
  std::string joined(const syntax::Expr& expr, const char* word);
  std::string equality(const syntax::Expr& expr);
  [[nodiscard]] std::optional<bool> areSame(const syntax::Expr& expr) const;
  std::string comparison(const syntax::Expr& expr, const char* word);
  std::string number(const syntax::Expr& of);
  std::string fail(const syntax::Expr& expr, const char* what);
  [[nodiscard]] bool isValue(const syntax::Expr& operand) const;
  [[nodiscard]] const syntax::Expr& bound(const syntax::Expr& expr) const;
  [[nodiscard]] const syntax::StateVariable* enumeration(std::string_view name) const;

  const analysis::Program& program;
  Errors& errors;
  analysis::FileId file = 0;
  Binding binding;
  std::map<std::string, std::string> names;
  std::set<std::string> taken;
};

} // namespace proskill::bridge::pddl
