#pragma once

#include "analysis/names/names.h"

namespace proskill::analysis {

/// Which atoms a condition may be made of: those of a program, or those of a property beside.
enum class Atoms : std::uint8_t { Program, Property };

/// Reads conditions, values and effects: what each word means, and whether the types agree.
///
/// A word in a condition is a state variable; beside an enumeration, a status or a result it is a
/// value of that one if it has it. So `(= battery Low)` compares with the value, even if some
/// state variable is called `Low`.
class Expressions {
public:
  Expressions(Context& context, FileId file, Atoms atoms = Atoms::Program)
      : context(context), names(context, file), file(file), atoms(atoms) {}

  void condition(const syntax::Expr& expr);
  void effects(const syntax::Effects& effects);
  /// A value of which nothing is known beforehand; a word is a state variable.
  Type value(const syntax::Expr& expr);

private:
  Type operand(const syntax::Expr& expr, Type expected);
  Type word(const syntax::Expr& expr, Type expected);
  Type number(const syntax::Expr& expr, Type expected);
  Type access(const syntax::Expr& expr);
  Type variable(const syntax::Name& name, Role role);
  void natural(const syntax::Expr& expr);
  void naturals(const syntax::List<syntax::Expr>& operands);
  void equality(const syntax::Expr& expr);
  void test(const syntax::Expr& expr);
  void valueOf(const syntax::Name& name, const syntax::Expr& value, Role role);
  void parameter(const syntax::Expr& expr);
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
  Atoms atoms;
};

} // namespace proskill::analysis
