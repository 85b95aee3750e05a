#include "codegen/message/message.h"

#include "analysis/checks/message.h"

#include <algorithm>

namespace proskill::codegen {
namespace {

MessagePart textPart(std::string_view text) { return {std::string(text), {}}; }

MessagePart variablePart(std::string name) { return {"", {{1, std::move(name)}}, 0, true}; }

/// Adds a sum of naturals.
void addSum(MessagePart& to, const syntax::Expr& expr, std::int64_t factor) {
  if (expr.kind == syntax::ExprKind::Number) to.constant += factor * expr.number.numerator;
  if (expr.kind == syntax::ExprKind::Symbol)
    to.terms.push_back({factor, std::string(expr.name.text)});
  const bool subtracts = expr.kind == syntax::ExprKind::Subtract;
  for (std::size_t i = 0; i < expr.operands.size(); ++i)
    addSum(to, expr.operands[i],
           subtracts && (i > 0 || expr.operands.size() == 1) ? -factor : factor);
}

MessagePart sumPart(const syntax::Expr& expr) {
  MessagePart part;
  addSum(part, expr, 1);
  if (part.terms.empty()) part.text = std::to_string(part.constant);
  return part;
}

MessagePart argumentPart(const Context& context, const syntax::Expr& expr) {
  if (expr.kind == syntax::ExprKind::Number) return textPart(syntax::toString(expr.number));
  if (expr.kind == syntax::ExprKind::String || expr.kind == syntax::ExprKind::True ||
      expr.kind == syntax::ExprKind::False)
    return textPart(expr.name.text);
  if (expr.kind == syntax::ExprKind::Symbol)
    return context.program.stateVariables.find(expr.name.text)
               ? variablePart(std::string(expr.name.text))
               : textPart(expr.name.text);
  if (expr.kind == syntax::ExprKind::Access)
    return variablePart(std::string(expr.name.text) + "." + std::string(expr.member.text));
  if (expr.kind == syntax::ExprKind::Add || expr.kind == syntax::ExprKind::Subtract)
    return sumPart(expr);
  return textPart("?");
}

} // namespace

std::vector<MessagePart> messageOf(Context& context, const syntax::Statement& printf) {
  std::vector<MessagePart> parts;
  const auto format = printf.format.text;
  std::size_t begin = 0;
  std::size_t next = 0; ///< argument
  for (const auto& directive : analysis::directives(format)) {
    parts.push_back(textPart(format.substr(begin, directive.at - begin)));
    begin = std::min(directive.at + 2, format.size());
    if (directive.letter == '%')
      parts.push_back(textPart("%"));
    else if (next < printf.arguments.size())
      parts.push_back(argumentPart(context, printf.arguments[next++].value));
  }
  parts.push_back(textPart(format.substr(begin)));
  return parts;
}

} // namespace proskill::codegen
