#include "runtime/platform/json.h"

#include "syntax/diagnostics/suggest.h"

#include <algorithm>
#include <cmath>

namespace proskill::runtime {

namespace {

struct Place {
  std::size_t line = 1;
  std::size_t column = 1;
};

/// Line and column, both from 1, of the position after these bytes.
Place placeBehind(std::string_view before) {
  return {static_cast<std::size_t>(std::ranges::count(before, '\n')) + 1,
          before.size() - (before.rfind('\n') + 1) + 1};
}

std::string placeOf(std::string_view text, std::size_t byte) {
  const auto at = placeBehind(text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size())));
  return "line " + std::to_string(at.line) + ", column " + std::to_string(at.column);
}

/// The end of a string, from the position after its opening quote.
std::size_t endOfString(std::string_view text, std::size_t begin) {
  auto at = begin + 1;
  while (at < text.size() && text[at] != '"') at += text[at] == '\\' ? 2 : 1;
  return std::min(at + 1, text.size());
}

} // namespace

Json parsedFile(std::string_view text) {
  Json value;
  try {
    value = Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw Wrong{"it is not JSON at " + placeOf(text, error.byte)};
  }
  if (!value.is_object()) throw Wrong{"it is not an object"};
  return value;
}

std::string placeOfMember(std::string_view text, std::string_view name) {
  int depth = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '{' || text[at] == '[') ++depth;
    if (text[at] == '}' || text[at] == ']') --depth;
    if (text[at] != '"') continue;
    const auto begin = at;
    const auto end = endOfString(text, begin);
    at = end - 1;
    const auto colon = text.find_first_not_of(" \t\r\n", end);
    const bool isKey = colon != std::string_view::npos && text[colon] == ':';
    if (depth != 1 || !isKey || text.substr(begin + 1, end - begin - 2) != name) continue;
    const auto value = text.find_first_not_of(" \t\r\n", colon + 1);
    const auto place = placeBehind(text.substr(0, value));
    return std::to_string(place.line) + ":" + std::to_string(place.column);
  }
  return "1:1";
}

void allowMembers(const Json& value, const std::vector<std::string>& known,
                  const std::string& where) {
  if (!value.is_object()) throw Wrong{where + " must be an object"};
  for (const auto& [key, _] : value.items())
    if (std::ranges::find(known, key) == known.end()) throwUnknown("member", key, known);
}

const Json& listOf(const Json& value, const std::string& of) {
  if (!value.is_array()) throw Wrong{"`" + of + "` must be a list"};
  return value;
}

const Json::object_t& objectAt(const Json& file, const std::string& key) {
  static const Json::object_t none;
  if (!file.contains(key)) return none;
  if (!file[key].is_object()) throw Wrong{"`" + key + "` must be an object"};
  return file[key].get_ref<const Json::object_t&>();
}

const std::string& stringAt(const Json& value, const std::string& key) {
  const auto found = value.find(key);
  if (found == value.end() || !found->is_string()) throw Wrong{"`" + key + "` must be a string"};
  return found->get_ref<const std::string&>();
}

Nanoseconds secondsOf(const Json& value, const std::string& of) {
  if (!value.is_number()) throw Wrong{"`" + of + "` must be a number of seconds"};
  const auto number = value.get<double>();
  if (!(number >= 0 && number <= 1e9)) throw Wrong{"`" + of + "` is not between 0 and 1e9 s"};
  return std::llround(number * static_cast<double>(kSecond));
}

Span spanOf(const Json& value, const std::string& of) {
  if (!value.is_array() || value.size() != 2) throw Wrong{"`" + of + "` is not [LEAST, MOST]"};
  const Span made{secondsOf(value[0], of), secondsOf(value[1], of)};
  if (*made.last < made.first) throw Wrong{"`" + of + "` ends before it begins"};
  return made;
}

void throwUnknown(const std::string& what, const std::string& name,
                  const std::vector<std::string>& names) {
  const auto meant = syntax::nearest(name, names);
  throw Wrong{"there is no " + what + " `" + name + "`" +
              (meant.empty() ? "" : "; did you mean `" + std::string(meant) + "`?")};
}

} // namespace proskill::runtime
