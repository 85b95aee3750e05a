#include "runtime/platform/json_place.h"

#include "syntax/text/utf8.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace proskill::runtime {

namespace {

/// Walks through a text and what was parsed from it at the same time. Without recursion, since
/// files may be nested as deeply as they like. Of members with the same key only the last was kept,
/// so a value in the text may be missing, or another, in what was parsed.
class Walk {
public:
  Walk(std::string_view of, const Json& parsed, const void* wanted)
      : text(of), file(parsed), part(wanted), at(of.starts_with("\xEF\xBB\xBF") ? 3 : 0) {}

  /// The position of the part; nullopt: it is not there.
  [[nodiscard]] std::optional<std::size_t> find() {
    for (skip(); at < text.size(); skip())
      if (const auto begin = at; passToken()) return begin;
    return std::nullopt;
  }

private:
  struct Level {
    const Json* container = nullptr; ///< null: missing
    bool isObject = false;           ///< in the text
    std::size_t next = 0;            ///< of an array: the index of its next value
    bool hasKey = false;             ///< of an object: its key was read, and its value comes next
    const Json* member = nullptr;    ///< that value; null: missing
  };

  void skip() { at = std::min(text.find_first_not_of(" \t\r\n,:", at), text.size()); }

  /// Passes a key, a value without others in it, or a bracket. \return whether it begins the part
  bool passToken() {
    if (text[at] == '}' || text[at] == ']') {
      levels.pop_back();
      ++at;
      return false;
    }
    if (!levels.empty() && levels.back().isObject && !levels.back().hasKey) return passKey();
    return passValue(nextValue());
  }

  bool passKey() {
    const auto key = Json::parse(passScalar()).get<std::string>();
    auto& level = levels.back();
    level.hasKey = true;
    level.member = nullptr;
    if (!level.container || !level.container->is_object()) return false;
    for (const auto& [name, value] : level.container->get_ref<const Json::object_t&>()) {
      if (name != key) continue;
      level.member = &value;
      return &name == part;
    }
    return false;
  }

  const Json* nextValue() {
    if (levels.empty()) return &file;
    auto& level = levels.back();
    level.hasKey = false;
    if (level.isObject) return level.member;
    const auto index = level.next++;
    const auto* list = level.container;
    return list && list->is_array() && index < list->size() ? &(*list)[index] : nullptr;
  }

  bool passValue(const Json* value) {
    if (text[at] == '{' || text[at] == '[')
      levels.push_back({.container = value, .isObject = text[at++] == '{'});
    else
      passScalar();
    return value && (value == part || value->get_ptr<const std::string*>() == part);
  }

  std::string_view passScalar() {
    const auto begin = at;
    if (text[at] != '"') {
      at = std::min(text.find_first_of(" \t\r\n,:]}", at), text.size());
    } else {
      for (++at; text[at] != '"';) at += text[at] == '\\' ? 2 : 1;
      ++at;
    }
    return text.substr(begin, at - begin);
  }

  std::string_view text;
  const Json& file;
  const void* part;
  std::size_t at;
  std::vector<Level> levels;
};

} // namespace

FilePlace placeOfByte(std::string_view text, std::size_t byte) {
  const auto before = text.substr(0, std::min(byte, text.size()));
  const auto line = std::ranges::count(before, '\n') + 1;
  const auto column = syntax::countCharacters(before.substr(before.rfind('\n') + 1)) + 1;
  return {static_cast<std::uint32_t>(line), static_cast<std::uint32_t>(column)};
}

FilePlace placeOfPart(std::string_view text, const Json& file, const void* part) {
  const auto found = part ? Walk(text, file, part).find() : std::nullopt;
  return placeOfByte(text, found.value_or(0));
}

} // namespace proskill::runtime
