#pragma once

#include "syntax/document.h"

#include <expected>
#include <filesystem>
#include <string>

namespace proskill::analysis {

/// The one way to the disk for everything below the command line and the server. Tests replace it.
class FileSystem {
public:
  virtual ~FileSystem() = default;
  /// The file's bytes, or why they cannot be had, in words for a user.
  [[nodiscard]] virtual std::expected<std::string, std::string>
  read(const std::filesystem::path& path) const = 0;
  /// There is something to read: no directory.
  [[nodiscard]] virtual bool isFile(const std::filesystem::path& path) const {
    return read(path).has_value();
  }
  /// One spelling for each file, so that two includes of it are seen to be the same.
  [[nodiscard]] virtual std::filesystem::path
  canonical(const std::filesystem::path& path) const = 0;
  /// The name by which a file is shown: whoever holds it by another one, as an editor does, gives
  /// that.
  [[nodiscard]] virtual std::filesystem::path nameOf(const std::filesystem::path& path) const {
    return path;
  }
  /// The file parsed; whoever holds it parsed already, as an editor does, gives that.
  [[nodiscard]] virtual std::expected<syntax::Document, std::string>
  document(const std::filesystem::path& path) const {
    auto text = read(path);
    if (!text) return std::unexpected(std::move(text.error()));
    return syntax::Document::parse(std::move(*text));
  }
};

} // namespace proskill::analysis
