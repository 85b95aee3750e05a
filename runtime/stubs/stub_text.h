#pragma once

#include "runtime/stubs/stubs.h"

#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>

/// What stubs of all languages need: names, arguments, and the mark of generated files.
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

/// The names of an action's parameters, in order.
/// \param reserved words that may not be names
[[nodiscard]] std::vector<std::string> parameterNames(const StubAction& action,
                                                      std::span<const std::string_view> reserved);

/// The first line of `:action`, safe in a comment; empty if there is none.
[[nodiscard]] std::string actionLine(const StubAction& action);

/// One text for each kind of argument.
struct ArgumentTexts {
  std::string integer;
  std::string number;
  std::string boolean;
  std::string string;
};

/// The text for an argument's kind.
/// \param ofVariable returns the text for values of the variable with this index
[[nodiscard]] std::string textFor(const StubProgram& program, const StubType& type,
                                  const ArgumentTexts& texts,
                                  const std::function<std::string(std::size_t)>& ofVariable);

/// Puts the mark of generated files before a text. It contains a hash of the text.
/// \param comment start of a comment: `#`
[[nodiscard]] std::string withStubMark(std::string_view comment, std::string_view text);

} // namespace proskill::runtime
