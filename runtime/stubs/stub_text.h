#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>

/// What stubs of all languages need: names, and the mark of generated files.
namespace proskill::runtime {

/// `goto_waypoint` as `GotoWaypoint`.
[[nodiscard]] std::string upperCamel(std::string_view name);
/// `at_altitude` as `AT_ALTITUDE`, `InAir` as `IN_AIR`.
[[nodiscard]] std::string upperSnake(std::string_view name);

/// Unique names, none of which is a reserved word.
class StubNames {
public:
  explicit StubNames(std::span<const std::string_view> reserved)
      : taken(reserved.begin(), reserved.end()) {}

  /// The name, with `_` appended if it is taken.
  std::string unique(std::string name) {
    while (!taken.insert(name).second) name += '_';
    return name;
  }

private:
  std::set<std::string> taken;
};

/// Puts the mark of generated files before a text. It contains a hash of the text.
/// \param comment start of a comment: `#`
[[nodiscard]] std::string withStubMark(std::string_view comment, std::string_view text);

} // namespace proskill::runtime
