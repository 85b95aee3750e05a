#pragma once

#include "analysis/flow/inspect.h"
#include "analysis/program/file_system.h"

#include <expected>
#include <filesystem>
#include <optional>
#include <string>

/// The settings file `.proskill.json`, which controls findings in the programs of its directory and
/// all directories below; see docs/proskill.schema.json. The command line and the server use it.
namespace proskill::report {

inline constexpr const char* kSettingsFile = ".proskill.json";

/// An error in the text of such a file, and its place.
struct SettingsMistake {
  std::string description; ///< for the user
  std::string text;        ///< of the file
  syntax::Range at;
  friend bool operator==(const SettingsMistake&, const SettingsMistake&) = default;
};

struct ProgramSettings {
  analysis::flow::Settings settings; ///< the defaults if there is no valid file
  std::filesystem::path file;        ///< where they were read; empty: there is no file
  std::optional<SettingsMistake> mistake;
};

/// Reads the file in the directory of a program's root file, or in the nearest directory above.
[[nodiscard]] ProgramSettings settingsFor(const analysis::FileSystem& files,
                                          const std::filesystem::path& root);

/// Parses the text of such a file.
[[nodiscard]] std::expected<analysis::flow::Settings, SettingsMistake>
parseSettings(const std::string& text);

} // namespace proskill::report
