#include "codegen/message/message.h"

#include "analysis/checks/message.h"
#include "codegen/term/inputs.h"

#include <algorithm>

namespace proskill::codegen {
namespace {

MessagePart textPart(std::string_view text) { return {std::string(text), {}}; }

MessagePart variablePart(std::string name) { return {"", {{1, std::move(name)}}, 0, true}; }

/// Whether the model contains every input in an argument.
bool isKnown(const Context& context, const syntax::Expr& expr) {
  if (expr.kind != syntax::ExprKind::Parameter)
    return std::ranges::all_of(expr.operands,
                               [&](const auto& each) { return isKnown(context, each); });
  return context.writtenIn && std::ranges::any_of(context.writtenIn->inputs, [&](const auto* it) {
           return it->name.text == expr.name.text;
         });
}

/// The variable that a word or an input is. \pre it is known
std::string variableOf(const Context& context, const syntax::Expr& expr) {
  const bool isInput = expr.kind == syntax::ExprKind::Parameter;
  return isInput ? shownInput(context.writtenIn->name(), expr.name.text)
                 : std::string(expr.name.text);
}

/// Adds a sum of naturals.
void addSum(const Context& context, MessagePart& to, const syntax::Expr& expr,
            std::int64_t factor) {
  if (expr.kind == syntax::ExprKind::Number) to.constant += factor * expr.number.numerator;
  if (expr.kind == syntax::ExprKind::Symbol || expr.kind == syntax::ExprKind::Parameter)
    to.terms.push_back({factor, variableOf(context, expr)});
  const bool subtracts = expr.kind == syntax::ExprKind::Subtract;
  for (std::size_t i = 0; i < expr.operands.size(); ++i)
    addSum(context, to, expr.operands[i],
           subtracts && (i > 0 || expr.operands.size() == 1) ? -factor : factor);
}

MessagePart sumPart(const Context& context, const syntax::Expr& expr) {
  MessagePart part;
  addSum(context, part, expr, 1);
  if (part.terms.empty()) part.text = std::to_string(part.constant);
  return part;
}

MessagePart argumentPart(const Context& context, const syntax::Expr& expr) {
  if (!isKnown(context, expr)) return textPart("?");
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
    return sumPart(context, expr);
  if (expr.kind == syntax::ExprKind::Parameter) return variablePart(variableOf(context, expr));
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
