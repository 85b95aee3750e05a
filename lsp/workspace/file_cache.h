#pragma once

#include "analysis/program/file_system.h"
#include "ide/snapshot/lru_cache.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>

namespace proskill::lsp {

/// Identity of a file, independent of links, and of its version,
/// without reading it.
struct FileStamp {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::int64_t modified = 0; ///< nanoseconds
  std::int64_t changed = 0;  ///< likewise; whoever sets the other one sets this to the present
  std::uintmax_t size = 0;   ///< bytes
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};
/// Nothing if unknown: then the file is not cached.
using StampOf = std::function<std::optional<FileStamp>(const std::filesystem::path&)>;
/// Of a file of this machine.
[[nodiscard]] std::optional<FileStamp> stampOnDisk(const std::filesystem::path& path);

/// LRU cache of parsed files, read again only after a change, so that programs share what they
/// include; and of the targets of links, resolved again only if they lead to another file.
/// Any thread may use it.
class FileCache : public analysis::FileSystem {
public:
  /// A tree takes some twenty times as much as its text.
  static constexpr std::size_t kMostBytes = 4 << 20;

  /// \param mostBytes of the texts of the trees that are kept
  explicit FileCache(std::shared_ptr<const analysis::FileSystem> disk,
                     StampOf stampOf = stampOnDisk, std::size_t mostBytes = kMostBytes)
      : disk(std::move(disk)), stampOf(std::move(stampOf)), entries(mostBytes) {}

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
  /// Follows links again, also those that lead to the same file, which may have been moved.
  void followAnew();

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
  mutable ide::LruCache<Entry> entries;
  mutable std::unordered_map<std::string, Followed> followed;
};

} // namespace proskill::lsp
