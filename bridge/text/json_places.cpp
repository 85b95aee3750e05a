#include "bridge/text/json_places.h"

#include "syntax/text/utf8.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace proskill::bridge {

namespace {

constexpr std::size_t kDeepest = 8;        ///< levels with paths of their own
constexpr std::size_t kMostRepeated = 100; ///< more of them help nobody

} // namespace

/// Walks through a text without recursion: it may be nested as deeply as it likes.
class JsonWalk {
public:
  JsonWalk(std::string_view text, JsonPlaces& places) : text(text), places(places) {}

  void walk() {
    for (skip(); at < text.size(); skip()) token();
  }

private:
  struct Level {
    std::string path;
    bool isObject = false;
    bool hasKey = false; ///< of an object: its value comes next
    std::string key;
    std::size_t next = 0; ///< of a list: the index of its next element
  };

  void skip() { at = std::min(text.find_first_not_of(" \t\r\n,:", at), text.size()); }

  void token() {
    if (text[at] == '}' || text[at] == ']') {
      levels.pop_back();
      ++at;
    } else if (!levels.empty() && levels.back().isObject && !levels.back().hasKey) {
      key();
    } else {
      value();
    }
  }

  void key() {
    const auto begin = at;
    auto& level = levels.back();
    level.key = nlohmann::json::parse(scalar()).get<std::string>();
    level.hasKey = true;
    if (levels.size() < kDeepest) places.note(memberPath(level.path, level.key), begin, true);
  }

  void value() {
    const auto path = pathOfValue();
    if (text[at] == '{' || text[at] == '[')
      levels.push_back({.path = path, .isObject = text[at++] == '{', .key = {}});
    else
      scalar();
  }

  std::string pathOfValue() {
    if (levels.empty()) return {};
    auto& level = levels.back();
    level.hasKey = false;
    if (levels.size() >= kDeepest) return {};
    if (level.isObject) return memberPath(level.path, level.key);
    auto path = level.path + "/" + std::to_string(level.next++);
    places.note(path, at, false);
    return path;
  }

  std::string_view scalar() {
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
  JsonPlaces& places;
  std::size_t at = 0;
  std::vector<Level> levels;
};

std::string memberPath(const std::string& object, std::string_view key) {
  auto path = object + "/";
  for (const char c : key) path += c == '/' ? "~1" : c == '~' ? "~0" : std::string(1, c);
  return path;
}

JsonPlaces::JsonPlaces(std::string_view text, std::filesystem::path file)
    : text(text), file(std::move(file)) {
  JsonWalk(text, *this).walk();
}

void JsonPlaces::note(const std::string& path, std::size_t byte, bool isMember) {
  const bool isNew = places.insert_or_assign(path, byte).second;
  if (isNew || !isMember) return;
  if (repetitions.size() < kMostRepeated) repetitions.emplace_back(path, placeIn(text, byte, file));
  // What the earlier member contains is not in the parsed text.
  const auto first = places.lower_bound(path + "/");
  places.erase(first, places.lower_bound(path + "0")); // '0' follows '/'
}

Place JsonPlaces::of(std::string path) const {
  for (; !path.empty(); path.resize(path.rfind('/')))
    if (const auto found = places.find(path); found != places.end())
      return placeIn(text, found->second, file);
  return {file};
}

Place placeIn(std::string_view text, std::size_t byte, std::filesystem::path file) {
  const auto before = text.substr(0, std::min(byte, text.size()));
  const auto line = static_cast<std::uint64_t>(std::ranges::count(before, '\n')) + 1;
  return {std::move(file), line,
          syntax::countCharacters(before.substr(before.rfind('\n') + 1)) + 1};
}

} // namespace proskill::bridge
