#pragma once

#include "runtime/platform/process.h"
#include "runtime/platform/simulated.h"

#include <expected>
#include <map>
#include <optional>
#include <string>
#include <string_view>

/// The files of `--platform` and `--script`, both JSON.
namespace proskill::runtime {

/// Takes over what the file of a simulated platform says. What is wrong with it is in words.
[[nodiscard]] std::optional<std::string>
readPlatform(std::string_view text, const Executable& executable, SimulationSettings& settings);
/// Takes over what the file of a platform of kind `process` says.
[[nodiscard]] std::optional<std::string> readProcessPlatform(std::string_view text,
                                                             ProcessSettings& settings);
/// What the file of a platform of kind `library` says.
struct LibrarySettings {
  std::string library;                          ///< a path, relative to the file's directory
  std::map<std::string, std::string> functions; ///< by skill: those not called after it
  ProcessSettings process;                      ///< without its command
};
[[nodiscard]] std::optional<std::string>
readLibraryPlatform(std::string_view text, const Executable& executable, LibrarySettings& settings);
/// Takes over a script.
[[nodiscard]] std::optional<std::string>
readScript(std::string_view text, const Executable& executable, SimulationSettings& settings);

/// Whether the file says itself when events come, so that the program's environment does not.
[[nodiscard]] bool speaksForEnvironment(std::string_view text);

/// What a platform file says of its kind: `simulated` where it says nothing. The error says what is
/// wrong with the file, and where.
[[nodiscard]] std::expected<std::string, std::string> platformKind(std::string_view text);

} // namespace proskill::runtime
