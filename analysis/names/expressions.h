#pragma once

#include "analysis/names/names.h"

namespace proskill::analysis {

/// The atoms that a condition may contain: those of programs, or also those of properties.
enum class Atoms : std::uint8_t { Program, Property };

/// Resolves and checks conditions, values and effects: names and types.
///
/// A word in a condition is a state variable, unless it is next to an enumeration, a status or a
/// result that has this value. So `(= battery Low)` compares with the value, even if some state
/// variable is called `Low`.
class Expressions {
public:
  /// \param skill the skill in which they are written; kNoSymbol: there are no parameters
  Expressions(Context& context, FileId file, SymbolId skill = kNoSymbol,
              Atoms atoms = Atoms::Program)
      : context(context), names(context, file), file(file), skill(skill), atoms(atoms) {}

  void condition(const syntax::Expr& expr);
  void effects(const syntax::Effects& effects);
  /// The type of a value without context; a word is a state variable.
  Type value(const syntax::Expr& expr);

private:
  Type operand(const syntax::Expr& expr, Type expected);
  Type word(const syntax::Expr& expr, Type expected);
  Type number(const syntax::Expr& expr, Type expected);
  Type access(const syntax::Expr& expr);
  Type variable(const syntax::Name& name, Role role);
  Type readVariable(const syntax::Name& name);
  void natural(const syntax::Expr& expr);
  void naturals(const syntax::List<syntax::Expr>& operands);
  void equality(const syntax::Expr& expr);
  void test(const syntax::Expr& expr);
  void valueOf(const syntax::Name& name, const syntax::Expr& value, Role role);
  Type parameter(const syntax::Expr& expr);
  void truthValue(const syntax::Expr& parameter);
  [[nodiscard]] std::string described(const syntax::Expr& expr, Type type) const;
  void onlyInProperty(const syntax::Name& word);
  void atom(const syntax::Expr& expr);
  void valueAtom(const syntax::Expr& expr);
  void skillAtom(const syntax::Expr& expr);
  void noCondition(const syntax::Expr& expr);
  void refuse(syntax::CodeFor<1> code, const syntax::Expr& expr, const std::string& found);
  void refuseRepeated(const syntax::Effects& effects);

  Context& context;
  Names names;
  FileId file;
  SymbolId skill;
  Atoms atoms;
};

} // namespace proskill::analysis
