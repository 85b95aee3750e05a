#include "bridge/bt/read/script.h"

#include "syntax/text/quote.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

namespace proskill::bridge::bt {
namespace {

/// Longer ones first.
constexpr auto kOperators = std::to_array<std::string_view>(
    {":=", "+=", "-=", "*=", "/=", "==", "!=", "<=", ">=", "&&", "||", "..", "+", "-", "*",
     "/",  "&",  "|",  "^",  "~",  "!",  "<",  ">",  "=",  "?",  ":",  "(",  ")", ";"});
constexpr auto kAssignments = std::to_array<std::string_view>({":=", "=", "+=", "-=", "*=", "/="});
constexpr auto kUnary = std::to_array<std::string_view>({"!", "-", "~"});

bool isIn(const auto& all, std::string_view word) {
  return std::ranges::find(all, word) != all.end();
}

/// Goes through the words of a script: operands and operators must alternate.
class ScriptCheck {
public:
  explicit ScriptCheck(std::string_view of) : rest(of) {}

  std::optional<std::string> run() {
    bool isEmpty = true;
    while (skipBlanks(), !rest.empty()) {
      const auto word = next();
      if (word.empty()) return "it has " + syntax::backquoted(rest.substr(0, 1));
      if (!take(word)) return "unexpected " + syntax::backquoted(word);
      isEmpty = false;
    }
    if (isEmpty) return "it is empty";
    if (!open.empty() || (needsOperand && !isAtBegin)) return "it ends too early";
    return std::nullopt;
  }

private:
  void skipBlanks() {
    const auto length = rest.find_first_not_of(" \t\r\n");
    rest.remove_prefix(std::min(length, rest.size()));
  }

  /// The next word; empty if there is none.
  std::string_view next() {
    auto length = std::size_t{0};
    if (rest.front() == '\'') {
      const auto end = rest.find('\'', 1);
      length = end == std::string_view::npos ? 0 : end + 1;
    } else if (isWordByte(rest.front())) {
      while (length < rest.size() && isWordByte(rest[length])) ++length;
      const bool isNumber = std::isdigit(static_cast<unsigned char>(rest.front())) != 0;
      while (isNumber && length < rest.size() && (isWordByte(rest[length]) || rest[length] == '.'))
        ++length;
    } else {
      for (const auto each : kOperators)
        if (length == 0 && rest.starts_with(each)) length = each.size();
    }
    const auto word = rest.substr(0, length);
    rest.remove_prefix(length);
    return word;
  }

  static bool isWordByte(char byte) {
    return std::isalnum(static_cast<unsigned char>(byte)) != 0 || byte == '_' || byte == '@' ||
           byte == '$';
  }

  /// \return whether the word is allowed here
  bool take(std::string_view word) {
    const bool isOperand = word.front() == '\'' || isWordByte(word.front());
    const bool fits = needsOperand ? beforeOperand(word, isOperand) : !isOperand && after(word);
    isAfterName = isOperand && word.front() != '\'';
    return fits;
  }

  bool beforeOperand(std::string_view word, bool isOperand) {
    if (word == ";") return isAtBegin;
    const bool wasAtBegin = std::exchange(isAtBegin, false);
    mayAssign = isOperand && wasAtBegin;
    if (isOperand) return needsOperand = false, true;
    if (word == "(") open.push_back('(');
    return word == "(" || isIn(kUnary, word);
  }

  bool after(std::string_view word) {
    if (word == ")" || word == ":") return close(word == ")" ? '(' : '?', word == ":");
    needsOperand = true;
    if (isIn(kAssignments, word)) return std::exchange(mayAssign, false) && isAfterName;
    mayAssign = false;
    if (word == ";") return isAtBegin = true, open.empty();
    if (word == "?") open.push_back('?');
    return word != "(" && word != "!" && word != "~";
  }

  bool close(char opened, bool needsMore) {
    if (open.empty() || open.back() != opened) return false;
    open.pop_back();
    needsOperand = needsMore;
    return true;
  }

  std::string_view rest;
  std::vector<char> open; ///< parentheses, and `?` without their `:`
  bool needsOperand = true;
  bool isAtBegin = true; ///< of a statement
  bool isAfterName = false;
  bool mayAssign = false;
};

} // namespace

std::optional<std::string> scriptError(std::string_view code) { return ScriptCheck(code).run(); }

} // namespace proskill::bridge::bt
