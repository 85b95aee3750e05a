#pragma once

#include "syntax/document.h"

#include <expected>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::analysis {

/// Access to files for everything below the command line and the server. Tests replace it.
class FileSystem {
public:
  virtual ~FileSystem() = default;
  /// The file's bytes, or for the user why they cannot be read.
  [[nodiscard]] virtual std::expected<std::string, std::string>
  read(const std::filesystem::path& path) const = 0;
  /// Whether the path is a readable file rather than a directory.
  [[nodiscard]] virtual bool isFile(const std::filesystem::path& path) const {
    return read(path).has_value();
  }
  /// Files with this extension, such as `.json`, in a folder and the folders directly below it, in
  /// order. Implementations that cannot list folders return none.
  [[nodiscard]] virtual std::vector<std::filesystem::path>
  filesBelow(const std::filesystem::path& /*folder*/, std::string_view /*extension*/) const {
    return {};
  }
  /// A unique spelling for each file, so that two includes of the same file are recognised.
  [[nodiscard]] virtual std::filesystem::path
  canonical(const std::filesystem::path& path) const = 0;
  /// The name by which a file is shown. Implementations that know it by another name, such as an
  /// editor's, return that.
  [[nodiscard]] virtual std::filesystem::path nameOf(const std::filesystem::path& path) const {
    return path;
  }
  /// The parsed file. Implementations that have it parsed already, such as an editor's, return
  /// that.
  [[nodiscard]] virtual std::expected<syntax::Document, std::string>
  document(const std::filesystem::path& path) const {
    auto text = read(path);
    if (!text) return std::unexpected(std::move(text.error()));
    return syntax::Document::parse(std::move(*text));
  }
};

/// For a text that is read alone: its includes are not found.
class NoFiles final : public FileSystem {
public:
  [[nodiscard]] std::expected<std::string, std::string>
  read(const std::filesystem::path& /*path*/) const override {
    return std::unexpected("no such file");
  }
  [[nodiscard]] std::filesystem::path canonical(const std::filesystem::path& path) const override {
    return path.lexically_normal();
  }
};

} // namespace proskill::analysis
