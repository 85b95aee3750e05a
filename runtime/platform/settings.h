#pragma once

#include "runtime/platform/simulated.h"

#include <expected>
#include <string>
#include <string_view>

/// The files of a simulated platform: `--platform` and `--script`, both JSON.
namespace proskill::runtime {

/// Takes over what a platform file says. What is wrong with it is in words.
[[nodiscard]] std::optional<std::string>
readPlatform(std::string_view text, const Executable& executable, SimulationSettings& settings);
/// Takes over a script.
[[nodiscard]] std::optional<std::string>
readScript(std::string_view text, const Executable& executable, SimulationSettings& settings);

/// Whether the file says itself when events come, so that the program's environment does not.
[[nodiscard]] bool speaksForEnvironment(std::string_view text);

/// What a platform file says of its kind: `simulated` where it says nothing. The error says what is
/// wrong with the file, and where.
[[nodiscard]] std::expected<std::string, std::string> platformKind(std::string_view text);

} // namespace proskill::runtime
