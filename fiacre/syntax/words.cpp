#include "fiacre/syntax/words.h"

#include <algorithm>
#include <array>

namespace proskill::fiacre {
namespace {

/// From this word on, the words are keywords in H-Fiacre or in properties only, and names
/// elsewhere.
constexpr std::string_view kFirstSoft = "event";

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
    // H-Fiacre: older texts use them as names
    kFirstSoft,
    "extern",
    "start",
    "task",
    // patterns of properties, and keywords of older texts
    "absent",
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
    "release",
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

bool isSoftName(std::string_view name) {
  return name == "event" || name == "task" || name == "extern" || name == "start";
}

bool isIdentifier(std::string_view name) {
  return !name.empty() && isLetter(name.front()) &&
         std::ranges::all_of(name, [](char c) { return isLetter(c) || isDigit(c); });
}

} // namespace proskill::fiacre
