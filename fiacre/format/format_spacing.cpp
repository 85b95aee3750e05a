#include "fiacre/format/format_spacing.h"

#include "fiacre/syntax/words.h"

#include <algorithm>
#include <array>

namespace proskill::fiacre {
namespace {

template <std::size_t N>
bool isOneOf(const Token& token, const std::array<std::string_view, N>& texts) {
  return token.kind != TokenKind::String && token.kind != TokenKind::Comment &&
         std::ranges::find(texts, token.text) != texts.end();
}

/// Keywords that may end an expression or a type.
constexpr auto kOperands =
    std::to_array<std::string_view>({"true", "false", "any", "end", "nat", "int", "bool", "sync"});
constexpr auto kClosing = std::to_array<std::string_view>({")", "]", "}", "|}"});
constexpr auto kTouchingBefore =
    std::to_array<std::string_view>({",", ";", ")", "]", "}", "|}", "..", "..."});
constexpr auto kBeforeInterval =
    std::to_array<std::string_view>({"wait", "in", "within", "interval"});
/// Keywords that end the expression after `value` in a path.
constexpr auto kAfterValue =
    std::to_array<std::string_view>({"and", "or", "=>", "until", "leadsto", "precedes", "after",
                                     "before", "within", "lasting", "for"});
constexpr auto kPathWords = std::to_array<std::string_view>({"state", "value", "tag", "event"});
constexpr auto kCalledWords = std::to_array<std::string_view>({"enqueue", "append"});

bool is(const Token& token, std::string_view text) {
  return token.text == text && token.kind != TokenKind::String && token.kind != TokenKind::Comment;
}

} // namespace

bool Spacing::opensInterval(const Token& token) const {
  return (is(token, "[") || is(token, "]")) && interval == Interval::Outside &&
         isOneOf(previous, kBeforeInterval);
}

Spacing::Role Spacing::roleOf(const Token& token, const Token& next) {
  const bool afterOperand = previousRole == Role::Operand;
  if (token.kind == TokenKind::Number || token.kind == TokenKind::String) return Role::Operand;
  if (token.kind == TokenKind::Comment) return Role::Other;
  if (token.kind == TokenKind::Name) {
    if (!afterOperand && !inValue && is(next, "/")) inPath = kind == LineKind::Property || inProbe;
    const bool operand =
        !isReserved(token.text) || isSoftName(token.text) || isOneOf(token, kOperands);
    return operand ? Role::Operand : Role::Other;
  }
  if (is(token, "/") && inPath) {
    inPath = next.kind == TokenKind::Number || isOneOf(next, kPathWords);
    return Role::Joint;
  }
  if (is(token, "=") && !groups.empty() && groups.back() == Group::Field) return Role::Joint;
  if (is(token, "&") || is(token, "$")) return Role::Prefix;
  if ((is(token, "-") || is(token, "#")) && !afterOperand) return Role::Prefix;
  if (opensInterval(token)) return Role::Open;
  if (isOneOf(token, kClosing)) return Role::Operand;
  if (is(token, "[") && interval == Interval::Upper && inner == 0) return Role::Operand;
  if (is(token, "(") || is(token, "{") || is(token, "{|") || is(token, "[")) return Role::Open;
  return Role::Other;
}

bool Spacing::closesInterval(const Token& token) {
  return interval == Interval::Upper && inner == 0 && (is(token, "[") || is(token, "]"));
}

/// Whether no space comes before a token, whatever token precedes it.
bool Spacing::touches(const Token& token, Role role) const {
  if (role == Role::Joint || is(token, ".")) return true;
  if (role == Role::Open && opensInterval(token)) return false;
  if (isOneOf(token, kTouchingBefore)) return true;
  const bool named = previousRole == Role::Operand || isOneOf(previous, kCalledWords);
  if (is(token, "(") || is(token, "["))
    return named && kind != LineKind::Head && !is(previous, "end");
  return false;
}

bool Spacing::spaced(const Token& token, Role role) {
  if (previous.kind == TokenKind::Comment || token.kind == TokenKind::Comment)
    return !isOneOf(token, kTouchingBefore);
  if (previousRole == Role::Prefix || previousRole == Role::Open || previousRole == Role::Joint)
    return false;
  if (interval != Interval::Outside && (is(previous, ",") || closesInterval(token))) return false;
  if (isOneOf(previous, std::to_array<std::string_view>({".", ".."}))) return false;
  if (is(token, ":")) return conditionals > 0;
  // a formula after `[]` or `()` is separated by a space; all other groups follow a name or a sign
  if (is(token, "(") && is(previous, ")")) return true;
  if (is(token, "(") && is(previous, "]") && kind == LineKind::Property && !inValue) return true;
  return !touches(token, role);
}

void Spacing::follow(const Token& token, Role role) {
  if (closesInterval(token)) {
    interval = Interval::Outside;
  } else if (opensInterval(token)) {
    interval = Interval::Lower;
    inner = 0;
  } else if (interval != Interval::Outside) {
    if (is(token, "(")) ++inner;
    if (is(token, ")") && inner > 0) --inner;
    if (is(token, ",")) interval = Interval::Upper;
  } else if (role == Role::Open) {
    groups.push_back(is(token, "{") ? Group::Field : Group::Other);
  } else if (isOneOf(token, kClosing) && !groups.empty()) {
    groups.pop_back();
  } else if (!groups.empty() && groups.back() != Group::Other) {
    if (is(token, "=")) groups.back() = Group::FieldValue;
    if (is(token, ",")) groups.back() = Group::Field;
  }
  if (is(token, ":") && conditionals == 0) inProbe = inValue = false; // the colon of the next port
  if (is(token, "?")) ++conditionals;
  if (is(token, ":") && conditionals > 0) --conditionals;
  if (is(token, "is") && kind == LineKind::Ports) inProbe = true;
  if (is(token, "value") && is(previous, "/")) {
    inValue = true;
    inPath = false;
  }
  if (isOneOf(token, kAfterValue)) inValue = false;
  previous = token;
  previousRole = role;
  first = false;
}

bool Spacing::before(const Token& token, const Token& next) {
  const Role role = roleOf(token, next);
  const bool result = !first && spaced(token, role);
  follow(token, role);
  return result;
}

} // namespace proskill::fiacre
