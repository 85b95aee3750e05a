#pragma once

#include "analysis/program/program.h"

#include <optional>
#include <string>

namespace proskill::disk {

/// Reads regular files of this machine. It reads nothing else, because reading a pipe may block for
/// ever and a device may never end.
class DiskFileSystem : public analysis::FileSystem {
public:
  [[nodiscard]] std::expected<std::string, std::string>
  read(const std::filesystem::path& path) const override;
  [[nodiscard]] bool isFile(const std::filesystem::path& path) const override;
  /// Hidden folders are skipped, and at most some thousand entries read.
  [[nodiscard]] std::vector<std::filesystem::path>
  filesBelow(const std::filesystem::path& folder, std::string_view extension) const override;
  [[nodiscard]] std::filesystem::path canonical(const std::filesystem::path& path) const override;
};

} // namespace proskill::disk
