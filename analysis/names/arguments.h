#pragma once

#include "analysis/names/names.h"

namespace proskill::analysis {

/// Checks the arguments of an action or a skill: literals, and `$params` of the skill that passes
/// them.
class Arguments {
public:
  /// \pre `caller` is the skill in which the arguments are written
  Arguments(Context& context, FileId file, SymbolId caller)
      : context(context), names(context, file), file(file), caller(caller) {}

  /// The type of an argument; Unknown, with a diagnostic, if it has none. A word has a meaning only
  /// if an enumeration is `wanted`.
  Type type(const syntax::Expr& argument, Type wanted);
  /// The declared type of a parameter of the caller.
  Type parameter(const syntax::Name& name);
  /// Checks the arguments of a call: each input is given once, with a value that fits.
  void checkCall(const syntax::Statement& call, SymbolId callee);

private:
  Type number(const syntax::Expr& argument, Type wanted);
  void notLiteral(const syntax::Expr& argument, Type wanted);
  [[nodiscard]] bool mayBeConstant(const syntax::Name& word, Type wanted) const;
  [[nodiscard]] const syntax::Argument* unnamed(const syntax::Statement& call,
                                                SymbolId callee) const;
  void suggestName(const syntax::Statement& call, SymbolId callee,
                   const syntax::Argument& argument);
  void checkNames(const syntax::Statement& call, SymbolId callee);
  void checkTypes(const syntax::Statement& call, SymbolId callee);
  [[nodiscard]] std::vector<std::string_view> absentInputs(const syntax::Statement& call,
                                                           SymbolId callee) const;
  void missing(const syntax::Statement& call, SymbolId callee);
  [[nodiscard]] const syntax::Skill& skill(SymbolId symbol) const;

  Context& context;
  Names names;
  FileId file;
  SymbolId caller;
};

} // namespace proskill::analysis
