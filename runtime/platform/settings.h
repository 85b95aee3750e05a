#pragma once

#include "runtime/platform/json_file.h"
#include "runtime/platform/process.h"
#include "runtime/platform/simulated.h"

#include <expected>
#include <map>
#include <string>
#include <string_view>

/// The files of `--platform` and `--script`, both JSON.
namespace proskill::runtime {

enum class PlatformKind : std::uint8_t { Simulated, Process, Library, Ros1, Ros2 };

/// A platform file, parsed once.
struct PlatformFile {
  JsonFile file;
  PlatformKind kind = PlatformKind::Simulated;

  /// Fails if it is not an object, or of no known kind.
  [[nodiscard]] static std::expected<PlatformFile, FileErrors> parse(std::string_view text);
};

/// Reads the file of a simulated platform into the settings.
[[nodiscard]] FileErrors readSimulation(const JsonFile& file,
                                        const codegen::PlatformInterface& interface,
                                        SimulationSettings& settings);
/// Reads a script into the settings.
[[nodiscard]] FileErrors readScript(const JsonFile& file,
                                    const codegen::PlatformInterface& interface,
                                    SimulationSettings& settings);
/// Reads the file of a platform of kind `process` into the settings.
[[nodiscard]] FileErrors readProcessPlatform(const JsonFile& file, ProcessSettings& settings);
/// Reads what all kinds of processes have: `startup`, `restarts`, `restart_delay`.
void readLife(const Json& file, ProcessSettings& settings, Errors& errors);
/// Contents of the file of a platform of kind `library`.
struct LibrarySettings {
  std::string library;                          ///< a path, relative to the file's directory
  std::map<std::string, std::string> functions; ///< by skill: functions whose names differ from the
                                                ///< skill's
  ProcessSettings process;                      ///< without its command
  FilePlace place;                              ///< of the library in the file
};
[[nodiscard]] FileErrors readLibraryPlatform(const JsonFile& file,
                                             const codegen::PlatformInterface& interface,
                                             LibrarySettings& settings);

/// Whether the file says when events come; the program's environment is then not executed.
[[nodiscard]] bool speaksForEnvironment(const JsonFile& file);

} // namespace proskill::runtime
