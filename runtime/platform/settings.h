#pragma once

#include "runtime/platform/json.h"
#include "runtime/platform/process.h"
#include "runtime/platform/simulated.h"

#include <expected>
#include <map>
#include <optional>
#include <string>
#include <string_view>

/// The files of `--platform` and `--script`, both JSON. Errors have the form `3:14: MESSAGE`, with
/// line and column.
namespace proskill::runtime {

/// Reads the file of a simulated platform into the settings.
/// \return an error
[[nodiscard]] std::optional<std::string> readPlatform(std::string_view text,
                                                      const codegen::PlatformInterface& interface,
                                                      SimulationSettings& settings);
/// Reads the file of a platform of kind `process` into the settings.
/// \return an error
[[nodiscard]] std::optional<std::string> readProcessPlatform(std::string_view text,
                                                             ProcessSettings& settings);
/// Reads what all kinds of processes have: `startup`, `restarts`, `restart_delay`. Throws `Wrong`.
void readLife(const Json& file, ProcessSettings& settings);
/// Contents of the file of a platform of kind `library`.
struct LibrarySettings {
  std::string library;                          ///< a path, relative to the file's directory
  std::map<std::string, std::string> functions; ///< by skill: functions whose names differ from the
                                                ///< skill's
  ProcessSettings process;                      ///< without its command
  std::string place;                            ///< of the library in the file, as `3:14`
};
[[nodiscard]] std::optional<std::string>
readLibraryPlatform(std::string_view text, const codegen::PlatformInterface& interface,
                    LibrarySettings& settings);
/// Reads a script into the settings.
/// \return an error
[[nodiscard]] std::optional<std::string> readScript(std::string_view text,
                                                    const codegen::PlatformInterface& interface,
                                                    SimulationSettings& settings);

/// Whether the file says when events come; the program's environment is then not executed.
[[nodiscard]] bool speaksForEnvironment(std::string_view text);

/// The kind of a platform file; `simulated` if it names none.
[[nodiscard]] std::expected<std::string, std::string> platformKind(std::string_view text);

} // namespace proskill::runtime
