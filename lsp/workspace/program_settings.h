#pragma once

#include "analysis/flow/inspect.h"
#include "analysis/program/file_system.h"

#include <expected>
#include <filesystem>
#include <optional>
#include <string>

/// What a file `.proskill.json` says about the findings of the programs beside it and below it; see
/// docs/proskill.schema.json. The command line and the server read it here.
namespace proskill::lsp {

inline constexpr const char* kSettingsFile = ".proskill.json";

/// What is wrong with the text of such a file, and where.
struct SettingsMistake {
  std::string description; ///< for the user
  std::string text;        ///< of the file
  syntax::Range at;
  friend bool operator==(const SettingsMistake&, const SettingsMistake&) = default;
};

struct ProgramSettings {
  analysis::flow::Settings
      settings;               ///< those of the table where there is no file, or a mistaken one
  std::filesystem::path file; ///< where they were read; empty: nowhere
  std::optional<SettingsMistake> mistake;
};

/// From the file beside a program's root file, or in the nearest directory above.
[[nodiscard]] ProgramSettings settingsFor(const analysis::FileSystem& files,
                                          const std::filesystem::path& root);

/// The text of such a file, or what is wrong with it.
[[nodiscard]] std::expected<analysis::flow::Settings, SettingsMistake>
parseSettings(const std::string& text);

} // namespace proskill::lsp
