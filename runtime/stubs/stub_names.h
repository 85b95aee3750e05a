#pragma once

#include <set>
#include <string>
#include <string_view>

/// The names that generated text declares, and those that it may not declare.
namespace proskill::runtime {

/// The names that are taken in a scope. A copy is a scope within it, whose names hide none of it.
class StubNames {
public:
  /// Words that mean something in C or C++, names and macros of the headers that the generated text
  /// includes, and names that it uses itself.
  static StubNames ofC();
  /// Likewise in Python.
  static StubNames ofPython();

  void take(std::string name) { taken.insert(std::move(name)); }
  /// Takes the name, with `_` appended as often as necessary.
  std::string unique(std::string name);

private:
  std::set<std::string, std::less<>> taken;
};

/// `goto_waypoint` as `GotoWaypoint`, `_2` as `Value2`.
[[nodiscard]] std::string upperCamel(std::string_view name);
/// `at_altitude` as `AT_ALTITUDE`, `InAir` as `IN_AIR`.
[[nodiscard]] std::string upperSnake(std::string_view name);
/// A name that does not begin like those of compilers: `_x` as `name_x`.
[[nodiscard]] std::string plainName(std::string name);
/// A plain name that does not look like a macro either: `INT_MAX` as `INT_MAX_`.
[[nodiscard]] std::string functionName(std::string name);

} // namespace proskill::runtime
