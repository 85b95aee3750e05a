#include "analysis/checks/message.h"

#include "analysis/names/arguments.h"
#include "analysis/names/expressions.h"
#include "syntax/diagnostics/codes.h"
#include "syntax/text/utf8.h"

#include <algorithm>
#include <utility>

namespace proskill::analysis {

using syntax::Code;
using syntax::Expr;
using syntax::ExprKind;
using syntax::Offset;

namespace {

bool takes(char letter, TypeKind kind) {
  switch (kind) {
  case TypeKind::Unknown: return true;
  case TypeKind::Natural:
  case TypeKind::Integer: return letter == 'd' || letter == 'f';
  case TypeKind::Float: return letter == 'f';
  case TypeKind::Boolean:
  case TypeKind::String:
  case TypeKind::Value:
  case TypeKind::Status:
  case TypeKind::Result: return letter == 's';
  }
  std::unreachable();
}

std::string_view takenBy(char letter) {
  switch (letter) {
  case 'd': return "an integer";
  case 'f': return "a number";
  default: return "a string or a named value";
  }
}

Type typeOf(Context& context, const Body& body, const Expr& argument) {
  if (argument.kind == ExprKind::Number) return typeOfNumber(argument);
  const bool inSkill = context.symbols[body.owner].kind == SymbolKind::Skill;
  if (argument.kind != ExprKind::Parameter)
    return Expressions(context, body.file, inSkill ? body.owner : kNoSymbol).value(argument);
  if (inSkill) return Arguments(context, body.file, body.owner).parameter(argument.name);
  Names(context, body.file).useParameter(argument.name, Role::Read, body.owner);
  return {};
}

/// Length of `%` and the following letter, which may have several bytes.
std::size_t letterLength(std::string_view format, std::size_t at) {
  std::size_t end = std::min(at + 2, format.size());
  while (end < format.size() && syntax::continuesCharacter(format[end])) ++end;
  return end - at;
}

} // namespace

std::vector<Directive> directives(std::string_view format) {
  std::vector<Directive> found;
  for (std::size_t at = format.find('%'); at < format.size(); at = format.find('%', at + 2))
    found.push_back({at + 1 < format.size() ? format[at + 1] : '\0', at});
  return found;
}

namespace {

/// The format and its arguments, with their types.
struct Message {
  const syntax::Statement& statement;
  std::vector<Directive> directives; ///< those that take an argument
  std::vector<Type> types;           ///< of the arguments
};

/// Reports invalid directives of the format. \return whether there are none
bool checkDirectives(Context& context, FileId file, const Message& message) {
  bool known = true;
  const syntax::Name& format = message.statement.format;
  for (const Directive& it : message.directives) {
    if (it.letter == 'd' || it.letter == 's' || it.letter == 'f') continue;
    known = false;
    const auto begin = static_cast<Offset>(format.range.begin + it.at);
    const auto word = format.text.substr(it.at, letterLength(format.text, it.at));
    const auto end = static_cast<Offset>(begin + word.size());
    context.findings.report(Code::UnknownDirective, {file, {begin, end}}, word);
  }
  return known;
}

void checkTypes(Context& context, FileId file, const Message& message) {
  for (std::size_t i = 0; i < message.types.size(); ++i) {
    const char letter = message.directives[i].letter;
    if (takes(letter, message.types[i].kind)) continue;
    context.findings.report(Code::FormatType, {file, message.statement.arguments[i].value.range},
                            letter, takenBy(letter), describe(message.types[i], context.symbols));
  }
}

} // namespace

void checkMessage(Context& context, const Body& body, const syntax::Statement& statement) {
  Message message{statement, directives(statement.format.text), {}};
  std::erase_if(message.directives, [](const Directive& it) { return it.letter == '%'; });
  for (const syntax::Argument& argument : statement.arguments)
    message.types.push_back(typeOf(context, body, argument.value));
  if (!checkDirectives(context, body.file, message)) return;
  const std::size_t takes = message.directives.size(), given = message.types.size();
  if (takes == given) return checkTypes(context, body.file, message);
  context.findings.report(Code::FormatArguments, {body.file, statement.format.range},
                          takes == 1 ? "1 argument" : std::to_string(takes) + " arguments",
                          given == 1 ? "1 is" : std::to_string(given) + " are");
}

} // namespace proskill::analysis
