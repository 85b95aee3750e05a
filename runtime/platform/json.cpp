#include "runtime/platform/json.h"

#include "syntax/diagnostics/suggest.h"

#include <algorithm>
#include <cmath>

namespace proskill::runtime {

bool isTooDeep(std::string_view text) {
  constexpr int kMost = 1000;
  int depth = 0;
  bool isString = false;
  for (std::size_t i = 0; i < text.size() && depth <= kMost; ++i) {
    const char c = text[i];
    if (c == '"') isString = !isString;
    if (isString && c == '\\') ++i;
    if (isString) continue;
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
  }
  return depth > kMost;
}

Json parsedText(std::string_view text) {
  return isTooDeep(text) ? Json(Json::value_t::discarded) : Json::parse(text, nullptr, false);
}

void allowMembers(const Json& value, const std::vector<std::string>& known,
                  const std::string& where, Errors& errors) {
  if (!value.is_object()) throw Wrong{where + " must be an object", &value};
  for (const auto& [key, _] : value.get_ref<const Json::object_t&>())
    if (std::ranges::find(known, key) == known.end()) errors.note(unknown("member", key, known));
}

const Json& listOf(const Json& value, const std::string& of) {
  if (!value.is_array()) throw Wrong{"`" + of + "` must be a list", &value};
  return value;
}

const Json::object_t& objectAt(const Json& file, const std::string& key) {
  static const Json::object_t none;
  if (!file.contains(key)) return none;
  const auto& value = file[key];
  if (!value.is_object()) throw Wrong{"`" + key + "` must be an object", &value};
  return value.get_ref<const Json::object_t&>();
}

const std::string& stringAt(const Json& value, const std::string& key) {
  const auto found = value.find(key);
  if (found == value.end()) throw Wrong{"`" + key + "` must be a string", &value};
  if (!found->is_string()) throw Wrong{"`" + key + "` must be a string", &*found};
  return found->get_ref<const std::string&>();
}

Nanoseconds secondsOf(const Json& value, const std::string& of) {
  if (!value.is_number()) throw Wrong{"`" + of + "` must be a number of seconds", &value};
  const auto number = value.get<double>();
  if (!(number >= 0 && number <= 1e9))
    throw Wrong{"`" + of + "` is not between 0 and 1e9 s", &value};
  return std::llround(number * static_cast<double>(kSecond));
}

Span spanOf(const Json& value, const std::string& of) {
  if (!value.is_array() || value.size() != 2)
    throw Wrong{"`" + of + "` is not [LEAST, MOST]", &value};
  const Span made{secondsOf(value[0], of), secondsOf(value[1], of)};
  if (*made.last < made.first) throw Wrong{"`" + of + "` ends before it begins", &value};
  return made;
}

Wrong unknown(const std::string& what, const std::string& name,
              const std::vector<std::string>& names) {
  const auto meant = syntax::nearest(name, names);
  return {"there is no " + what + " `" + name + "`" +
              (meant.empty() ? "" : "; did you mean `" + std::string(meant) + "`?"),
          &name};
}

} // namespace proskill::runtime
