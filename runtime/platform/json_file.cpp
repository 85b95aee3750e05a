#include "runtime/platform/json_file.h"

#include "syntax/text/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <vector>

namespace proskill::runtime {

namespace {

/// More errors help nobody.
constexpr std::size_t kMostShown = 100;

/// Positions of parts of a file, as far as they are known.
using Positions = std::unordered_map<const void*, std::size_t>;

/// Walks through a text and what was parsed from it at the same time. Without recursion, since
/// files may be nested as deeply as they like. Of members with the same key only the last was kept,
/// so a value in the text may be missing, or another, in what was parsed.
class Walk {
public:
  /// \param wanted keys; their values are set where the text has the part
  Walk(std::string_view of, const Json& parsed, Positions& wanted)
      : text(of), file(parsed), found(wanted), at(of.starts_with("\xEF\xBB\xBF") ? 3 : 0) {}

  void find() {
    for (skip(); at < text.size(); skip()) passToken();
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

  void note(const void* part, std::size_t begin) {
    if (const auto wanted = found.find(part); wanted != found.end()) wanted->second = begin;
  }

  /// Passes a key, a value without others in it, or a bracket.
  void passToken() {
    if (text[at] == '}' || text[at] == ']') {
      levels.pop_back();
      ++at;
      return;
    }
    if (!levels.empty() && levels.back().isObject && !levels.back().hasKey) return passKey();
    passValue(nextValue());
  }

  void passKey() {
    const auto begin = at;
    const auto key = Json::parse(passScalar()).get<std::string>();
    auto& level = levels.back();
    level.hasKey = true;
    level.member = nullptr;
    if (!level.container || !level.container->is_object()) return;
    const auto& members = level.container->get_ref<const Json::object_t&>();
    const auto member = members.find(key);
    if (member == members.end()) return;
    level.member = &member->second;
    note(&member->first, begin);
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

  void passValue(const Json* value) {
    if (value) note(value, at);
    if (value && value->is_string()) note(value->get_ptr<const std::string*>(), at);
    if (text[at] == '{' || text[at] == '[')
      levels.push_back({.container = value, .isObject = text[at++] == '{'});
    else
      passScalar();
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
  Positions& found;
  std::size_t at;
  std::vector<Level> levels;
};

FilePlace placeOfByte(std::string_view text, std::size_t byte) {
  const auto before = text.substr(0, std::min(byte, text.size()));
  const auto line = std::ranges::count(before, '\n') + 1;
  const auto column = syntax::countCharacters(before.substr(before.rfind('\n') + 1)) + 1;
  return {static_cast<std::uint32_t>(line), static_cast<std::uint32_t>(column)};
}

/// Where the number is that the parser's message has in quotes at its end.
std::size_t byteOfNumber(std::string_view text, std::string_view message) {
  const auto begin = message.find('\'') + 1;
  return text.find(message.substr(begin, message.rfind('\'') - begin));
}

} // namespace

std::expected<JsonFile, FileErrors> JsonFile::parse(std::string_view text) {
  const auto wrong = [&](std::string why, std::size_t byte = 0) {
    return std::unexpected(FileErrors{{std::move(why), placeOfByte(text, byte)}});
  };
  if (isTooDeep(text)) return wrong("it is nested too deep");
  try {
    auto object = Json::parse(text);
    if (!object.is_object()) return wrong("it is not an object");
    return JsonFile(text, std::move(object));
  } catch (const Json::parse_error& error) {
    return wrong("it is not JSON", error.byte == 0 ? 0 : error.byte - 1);
  } catch (const Json::out_of_range& error) {
    return wrong("the number is too large", byteOfNumber(text, error.what()));
  }
}

FilePlace JsonFile::placeOf(const void* part) const {
  Positions positions{{part, 0}};
  Walk(text, object, positions).find();
  return placeOfByte(text, positions.at(part));
}

FileErrors JsonFile::placed(const Errors& errors) const {
  Positions positions;
  for (const auto& wrong : errors.all()) positions[wrong.part] = 0;
  if (!positions.empty()) Walk(text, object, positions).find();
  std::vector<const Wrong*> sorted;
  for (const auto& wrong : errors.all()) sorted.push_back(&wrong);
  std::ranges::stable_sort(sorted, {}, [&](const auto* it) { return positions.at(it->part); });
  FileErrors made;
  for (const auto* wrong : sorted) {
    if (made.size() == kMostShown) {
      made.push_back({fmt::format("{} more errors are not shown", sorted.size() - kMostShown)});
      break;
    }
    made.push_back({wrong->why, {}, wrong->skill});
    if (wrong->skill.empty()) made.back().place = placeOfByte(text, positions.at(wrong->part));
  }
  return made;
}

} // namespace proskill::runtime
