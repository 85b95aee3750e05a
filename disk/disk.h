#pragma once

#include "analysis/program/program.h"

#include <optional>
#include <string>

namespace proskill::disk {

/// The regular files of this machine. Nothing else is read: a pipe can keep its reader waiting for
/// ever, and a device may never end.
class DiskFileSystem : public analysis::FileSystem {
public:
  [[nodiscard]] std::expected<std::string, std::string>
  read(const std::filesystem::path& path) const override;
  [[nodiscard]] bool isFile(const std::filesystem::path& path) const override;
  [[nodiscard]] std::filesystem::path canonical(const std::filesystem::path& path) const override;
};

} // namespace proskill::disk
