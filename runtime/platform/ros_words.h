#pragma once

#include "runtime/platform/json.h"

#include <string>
#include <vector>

/// What the parts of the reader of platforms of kinds `ros1` and `ros2` share.
namespace proskill::runtime {

enum class Ros { One, Two };

/// A name, a type or a path: a string that is not empty.
[[nodiscard]] const std::string& wordAt(const Json& value, const std::string& key,
                                        const std::string& of);

/// The member `type`: `package/Type`, and in ROS 2 `package/KIND/Type`. \param kind `action`, `srv`
/// or `msg`
[[nodiscard]] const std::string& typeAt(const Json& value, const std::string& of, Ros ros,
                                        const std::string& kind);

/// Reads `below`, `above` and `equals` of a case.
[[nodiscard]] Json conditionOf(const Json& value, const std::string& of);

[[nodiscard]] double inSeconds(const Json& value, const std::string& of);

} // namespace proskill::runtime
