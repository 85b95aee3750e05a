#pragma once

#include "runtime/platform/file_error.h"
#include "runtime/platform/json.h"
#include "runtime/platform/process.h"
#include "runtime/platform/simulated.h"

#include <expected>
#include <map>
#include <optional>
#include <string>
#include <string_view>

/// The files of `--platform` and `--script`, both JSON.
namespace proskill::runtime {

/// Reads the file of a simulated platform into the settings.
/// \return an error
[[nodiscard]] std::optional<FileError> readPlatform(std::string_view text,
                                                    const codegen::PlatformInterface& interface,
                                                    SimulationSettings& settings);
/// Reads the file of a platform of kind `process` into the settings.
/// \return an error
[[nodiscard]] std::optional<FileError> readProcessPlatform(std::string_view text,
                                                           ProcessSettings& settings);
/// Reads what all kinds of processes have: `startup`, `restarts`, `restart_delay`. Throws `Wrong`.
void readLife(const Json& file, ProcessSettings& settings);
/// Contents of the file of a platform of kind `library`.
struct LibrarySettings {
  std::string library;                          ///< a path, relative to the file's directory
  std::map<std::string, std::string> functions; ///< by skill: functions whose names differ from the
                                                ///< skill's
  ProcessSettings process;                      ///< without its command
  FilePlace place;                              ///< of the library in the file
};
[[nodiscard]] std::optional<FileError>
readLibraryPlatform(std::string_view text, const codegen::PlatformInterface& interface,
                    LibrarySettings& settings);
/// Reads a script into the settings.
/// \return an error
[[nodiscard]] std::optional<FileError> readScript(std::string_view text,
                                                  const codegen::PlatformInterface& interface,
                                                  SimulationSettings& settings);

/// Whether the file says when events come; the program's environment is then not executed.
[[nodiscard]] bool speaksForEnvironment(std::string_view text);

/// The kind of a platform file; `simulated` if it names none.
[[nodiscard]] std::expected<std::string, FileError> platformKind(std::string_view text);

} // namespace proskill::runtime
