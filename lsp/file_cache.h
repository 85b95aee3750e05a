#pragma once

#include "analysis/file_system.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>

namespace proskill::lsp {

/// What tells a file from others, whatever links lead to it, and one state of it from another
/// without reading it.
struct FileStamp {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::int64_t modified = 0; ///< nanoseconds
  std::uintmax_t size = 0;   ///< bytes
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};
/// Nothing where it cannot be known: what was read is not kept then.
using StampOf = std::function<std::optional<FileStamp>(const std::filesystem::path&)>;
/// Of a file of this machine.
[[nodiscard]] std::optional<FileStamp> stampOnDisk(const std::filesystem::path& path);

/// Files as trees, read again only where they have changed, and the ends of links, followed again
/// only where they lead to another file. Any thread may use it.
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
  [[nodiscard]] std::filesystem::path canonical(const std::filesystem::path& path) const override;
  [[nodiscard]] std::expected<syntax::Document, std::string>
  document(const std::filesystem::path& path) const override;

private:
  struct Entry {
    FileStamp stamp;
    syntax::Document document;
  };
  struct Followed {
    std::uint64_t device;
    std::uint64_t inode;
    std::filesystem::path canonical;
  };

  std::shared_ptr<const analysis::FileSystem> disk;
  StampOf stampOf;
  mutable std::mutex mutex;
  mutable std::unordered_map<std::string, Entry> entries;
  mutable std::unordered_map<std::string, Followed> followed;
};

} // namespace proskill::lsp
