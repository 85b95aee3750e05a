#pragma once

#include "analysis/file_system.h"
#include "analysis/flow/inspect.h"

#include <expected>
#include <filesystem>
#include <string>

/// What a file `.proskill.json` says about the findings of the programs beside it and below it; see
/// docs/proskill.schema.json. The command line and the server read it here.
namespace proskill::lsp {

inline constexpr const char* kSettingsFile = ".proskill.json";

struct ProgramSettings {
  analysis::flow::Settings
      settings;               ///< those of the table where there is no file, or a mistaken one
  std::filesystem::path file; ///< where they were read; empty: nowhere
  std::string mistake;        ///< in the file, in words for the user; empty: none
};

/// From the file beside a program's root file, or in the nearest directory above.
[[nodiscard]] ProgramSettings settingsFor(const analysis::FileSystem& files,
                                          const std::filesystem::path& root);

/// The text of such a file, or what is wrong with it.
[[nodiscard]] std::expected<analysis::flow::Settings, std::string>
parseSettings(const std::string& text);

} // namespace proskill::lsp
