#pragma once

#include "analysis/file_system.h"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

namespace proskill::lsp {

/// What tells one state of a file from another without reading it.
struct FileStamp {
  std::filesystem::file_time_type modified;
  std::uintmax_t size = 0; ///< bytes
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};
/// Nothing where it cannot be known: what was read is not kept then.
using StampOf = std::function<std::optional<FileStamp>(const std::filesystem::path&)>;
/// Of a file of this machine.
[[nodiscard]] std::optional<FileStamp> stampOnDisk(const std::filesystem::path& path);

/// Files as trees, read again only where they have changed. Any thread may use it.
class FileCache : public analysis::FileSystem {
public:
  explicit FileCache(std::shared_ptr<const analysis::FileSystem> disk,
                     StampOf stampOf = stampOnDisk)
      : disk(std::move(disk)), stampOf(std::move(stampOf)) {}

  [[nodiscard]] std::expected<std::string, std::string>
  read(const std::filesystem::path& path) const override {
    return disk->read(path);
  }
  [[nodiscard]] bool isFile(const std::filesystem::path& path) const override {
    return disk->isFile(path);
  }
  [[nodiscard]] std::filesystem::path canonical(const std::filesystem::path& path) const override {
    return disk->canonical(path);
  }
  [[nodiscard]] std::expected<syntax::Document, std::string>
  document(const std::filesystem::path& path) const override;

private:
  struct Entry {
    FileStamp stamp;
    syntax::Document document;
  };

  std::shared_ptr<const analysis::FileSystem> disk;
  StampOf stampOf;
  mutable std::mutex mutex;
  mutable std::map<std::filesystem::path, Entry> entries;
};

} // namespace proskill::lsp
