#pragma once

#include "bridge/gen/read/component.h"
#include "bridge/text/token_reader.h"

namespace proskill::bridge::gen {

/// Reads declarations of the IDL: types, constants, modules. Names count without their scope.
class Types {
public:
  explicit Types(TokenReader& reader) : reader(reader) {}

  /// Reads one declaration, such as a `struct` or a `typedef`, if there is one.
  bool declaration();
  /// Reads the `exception` that comes next, one name or several; \return the names
  std::vector<Word> exceptions();
  /// Reads `{ member… }`: the internal data of a component, or a structure.
  Type members();
  Type type();
  /// Reads a name with the sizes of an array. \return its type as well
  std::pair<Word, Type> declarator(const Type& type);
  /// Skips sizes or indices in brackets. \return whether there are any
  bool skipBrackets();
  /// Skips an expression or an initializer, up to one of `,` `)` `;` outside of parentheses.
  void skipExpression();
  /// Skips what is between the parentheses or braces that come next.
  void skipGroup();

  std::vector<Word> inModules; ///< exceptions

private:
  void names(const Type& type);
  void module();
  Type structure();
  Type base();
  Type named();
  Type sequence();

  TokenReader& reader;
  std::map<std::string, Type, std::less<>> known;
  std::size_t depth = 0;
};

} // namespace proskill::bridge::gen
