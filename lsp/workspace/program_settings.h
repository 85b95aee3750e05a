#pragma once

#include "analysis/flow/inspect.h"
#include "analysis/program/file_system.h"

#include <expected>
#include <filesystem>
#include <optional>
#include <string>

/// Settings in a file `.proskill.json` for the findings of the programs beside it and below it; see
/// docs/proskill.schema.json. The command line and the server read it here.
namespace proskill::lsp {

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
  std::filesystem::path file;        ///< where they were read; empty: nowhere
  std::optional<SettingsMistake> mistake;
};

/// From the file beside a program's root file, or in the nearest directory above.
[[nodiscard]] ProgramSettings settingsFor(const analysis::FileSystem& files,
                                          const std::filesystem::path& root);

/// Parses the text of such a file.
[[nodiscard]] std::expected<analysis::flow::Settings, SettingsMistake>
parseSettings(const std::string& text);

} // namespace proskill::lsp
