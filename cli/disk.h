#pragma once

#include "analysis/program.h"
#include "cli/paint.h"

#include <optional>
#include <string>

namespace proskill::cli {

/// The regular files of this machine. Nothing else is read: a pipe can keep its reader waiting for
/// ever, and a device may never end.
class DiskFileSystem : public analysis::FileSystem {
public:
  [[nodiscard]] std::expected<std::string, std::string>
  read(const std::filesystem::path& path) const override;
  [[nodiscard]] bool isFile(const std::filesystem::path& path) const override;
  [[nodiscard]] std::filesystem::path canonical(const std::filesystem::path& path) const override;
};

/// The program of a root file, for commands that need one without errors: its errors and warnings
/// are printed to standard error. Nothing where it has errors or cannot be read.
[[nodiscard]] std::optional<analysis::Program> loadChecked(const std::string& root,
                                                           ColourChoice colour);

} // namespace proskill::cli
