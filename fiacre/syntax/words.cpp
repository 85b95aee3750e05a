#include "fiacre/syntax/words.h"

#include <algorithm>
#include <array>

namespace proskill::fiacre {
namespace {

/// From it on, words mean something only where properties do.
constexpr std::string_view kFirstSoft = "absent";

constexpr auto kReserved = std::to_array<std::string_view>({
    // Fiacre
    "and",
    "any",
    "append",
    "array",
    "assert",
    "begin",
    "bool",
    "case",
    "channel",
    "component",
    "const",
    "dequeue",
    "do",
    "else",
    "elsif",
    "empty",
    "end",
    "enqueue",
    "false",
    "first",
    "foreach",
    "from",
    "full",
    "function",
    "if",
    "in",
    "init",
    "int",
    "is",
    "loop",
    "nat",
    "none",
    "not",
    "null",
    "of",
    "on",
    "or",
    "out",
    "par",
    "port",
    "priority",
    "process",
    "property",
    "prove",
    "queue",
    "record",
    "return",
    "select",
    "states",
    "sync",
    "then",
    "to",
    "true",
    "type",
    "union",
    "unless",
    "until",
    "var",
    "wait",
    "where",
    "while",
    // H-Fiacre
    "event",
    "extern",
    "start",
    "task",
    // patterns of properties, and words of older texts
    kFirstSoft,
    "after",
    "always",
    "before",
    "between",
    "deadlockfree",
    "duration",
    "enter",
    "for",
    "infinitelyoften",
    "interval",
    "lasting",
    "leadsto",
    "leave",
    "ltl",
    "mortal",
    "precedes",
    "present",
    "read",
    "state",
    "tag",
    "value",
    "within",
    "write",
});

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

} // namespace

bool isReserved(std::string_view name) {
  return std::ranges::find(kReserved, name) != kReserved.end();
}

bool isKeyword(std::string_view name) {
  const auto* const soft = std::ranges::find(kReserved, kFirstSoft);
  return std::find(kReserved.begin(), soft, name) != soft;
}

std::span<const std::string_view> reservedWords() { return kReserved; }

bool isIdentifier(std::string_view name) {
  return !name.empty() && isLetter(name.front()) &&
         std::ranges::all_of(name, [](char c) { return isLetter(c) || isDigit(c); });
}

} // namespace proskill::fiacre
