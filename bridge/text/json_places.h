#pragma once

#include "bridge/text/place.h"

#include <map>
#include <string_view>
#include <utility>

namespace proskill::bridge {

/// The path of a member of an object, as a JSON pointer (RFC 6901).
[[nodiscard]] std::string memberPath(const std::string& object, std::string_view key);

/// Where the parts of a JSON text are, by their paths, such as `/leaves/Drive/duration/0`. Of
/// members with one name, the last one has the path, as in the parsed text.
class JsonPlaces {
public:
  /// \pre the text is JSON
  JsonPlaces(std::string_view text, std::filesystem::path file);

  /// The key of a member, or an element of a list. What lies deeper than people write is at the
  /// part around it.
  [[nodiscard]] Place of(std::string path) const;
  /// The members whose names their objects have more than once, with their paths.
  [[nodiscard]] const std::vector<std::pair<std::string, Place>>& repeated() const {
    return repetitions;
  }

private:
  friend class JsonWalk;

  void note(const std::string& path, std::size_t byte, bool isMember);

  std::string_view text;
  std::filesystem::path file;
  std::map<std::string, std::size_t> places;
  std::vector<std::pair<std::string, Place>> repetitions;
};

/// The place of a byte.
[[nodiscard]] Place placeIn(std::string_view text, std::size_t byte, std::filesystem::path file);

} // namespace proskill::bridge
