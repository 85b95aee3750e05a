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

/// What tells a file from others, whatever links lead to it, and one state of it from another
/// without reading it.
struct FileStamp {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::int64_t modified = 0; ///< nanoseconds
  std::int64_t changed = 0;  ///< likewise; whoever sets the other one sets this to the present
  std::uintmax_t size = 0;   ///< bytes
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};
/// Nothing where it cannot be known: what was read is not kept then.
using StampOf = std::function<std::optional<FileStamp>(const std::filesystem::path&)>;
/// Of a file of this machine.
[[nodiscard]] std::optional<FileStamp> stampOnDisk(const std::filesystem::path& path);

/// Files as trees, read again only where they have changed, so that programs share what they
/// include; and the ends of links, followed again only where they lead to another file. Of the
/// trees it keeps those that were used last. Any thread may use it.
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
