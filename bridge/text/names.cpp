#include "bridge/text/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace proskill::bridge {
namespace {

constexpr std::size_t kLongestName = 60;

/// Words that begin a definition, a statement or a condition.
constexpr auto kReserved = std::to_array<std::string_view>(
    {"and",      "break",       "case",        "choose",   "defconst", "defenvironment",
     "defevent", "defproperty", "defresource", "defskill", "defsv",    "do",
     "else",     "elseif",      "emit",        "failure",  "false",    "goto",
     "if",       "include",     "label",       "not",      "or",       "printf",
     "race",     "set",         "success",     "true",     "until",    "while"});

bool isNameByte(char byte) {
  return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') ||
         (byte >= '0' && byte <= '9') || byte == '_';
}

std::string onOneLine(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char byte) { return byte < ' ' || byte == 0x7f; }, ' ');
  return text;
}

} // namespace

std::string asName(std::string_view text) {
  std::string name(text.substr(0, kLongestName));
  std::ranges::replace_if(
      name, [](char byte) { return !isNameByte(byte); }, '_');
  if (name.empty() || (name.front() >= '0' && name.front() <= '9')) name.insert(0, "node_");
  const bool reserved = std::ranges::find(kReserved, std::string_view(name)) != kReserved.end();
  return reserved ? name + "_node" : name;
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string NamePool::take(std::string_view wish) {
  const auto first = asName(wish);
  if (taken.insert(first).second) return first;
  for (auto& number = next.try_emplace(first, 2).first->second;; ++number) {
    auto name = fmt::format("{}_{}", first, number);
    if (taken.insert(name).second) return name;
  }
}

std::string asString(std::string_view text) {
  std::string quoted = "\"";
  for (const char byte : onOneLine(std::string(text))) {
    if (byte == '"' || byte == '\\') quoted += '\\';
    quoted += byte;
  }
  return quoted + "\"";
}

std::string asText(const Place& place, const std::filesystem::path& folder) {
  const auto file = folder.empty() ? place.file : place.file.lexically_proximate(folder);
  const auto relative = file.generic_string();
  return onOneLine(fmt::format("{}:{}:{}", relative, place.line, place.column));
}

std::string asComment(const Place& place, std::string_view what,
                      const std::filesystem::path& folder) {
  return onOneLine(fmt::format("from {} {}", asText(place, folder), what));
}

} // namespace proskill::bridge
