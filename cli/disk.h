#pragma once

#include "analysis/program.h"
#include "cli/paint.h"

#include <optional>
#include <string>

namespace proskill::cli {

/// The files of this machine.
class DiskFileSystem : public analysis::FileSystem {
public:
  /// A pipe or a device may keep its reader waiting for ever: whom nobody can stop reads none.
  enum class Reads : std::uint8_t { Anything, OnlyFiles };

  explicit DiskFileSystem(Reads reads = Reads::Anything) : reads(reads) {}

  [[nodiscard]] std::expected<std::string, std::string>
  read(const std::filesystem::path& path) const override;
  [[nodiscard]] bool isFile(const std::filesystem::path& path) const override;
  [[nodiscard]] std::filesystem::path canonical(const std::filesystem::path& path) const override;

private:
  Reads reads;
};

/// The program of a root file, for commands that need one without errors: its errors and warnings
/// are printed to standard error. Nothing where it has errors or cannot be read.
[[nodiscard]] std::optional<analysis::Program> loadChecked(const std::string& root,
                                                           ColourChoice colour);

} // namespace proskill::cli
