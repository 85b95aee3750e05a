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
#include <unordered_set>

namespace proskill::lsp {

/// Identifies a file, independent of links, and its version, without reading it.
struct FileStamp {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::int64_t modified = 0; ///< nanoseconds
  std::int64_t changed = 0;  ///< nanoseconds; tools that set `modified` cannot set this
  std::uintmax_t size = 0;   ///< bytes
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};
/// Nothing if unknown: then the file is not cached.
using StampOf = std::function<std::optional<FileStamp>(const std::filesystem::path&)>;
/// The stamp of a file of this machine.
[[nodiscard]] std::optional<FileStamp> stampOnDisk(const std::filesystem::path& path);

/// LRU cache of parsed files, so that programs share what they include. A file is read again only
/// after a change. Also caches the targets of links, which are resolved again only if they lead to
/// another file. Thread-safe.
class FileCache : public analysis::FileSystem {
public:
  /// The tree of a text takes about twenty times its memory.
  static constexpr std::size_t kMostBytes = 4 << 20;

  /// \param mostBytes total length of the texts whose trees are kept
  explicit FileCache(std::shared_ptr<const analysis::FileSystem> disk,
                     StampOf stampOf = stampOnDisk, std::size_t mostBytes = kMostBytes)
      : disk(std::move(disk)), stampOf(std::move(stampOf)), entries(mostBytes) {}

  [[nodiscard]] std::expected<std::string, std::string>
  read(const std::filesystem::path& path) const override;
  [[nodiscard]] std::vector<std::filesystem::path>
  filesBelow(const std::filesystem::path& folder, std::string_view extension) const override {
    return disk->filesBelow(folder, extension);
  }
  [[nodiscard]] bool isFile(const std::filesystem::path& path) const override {
    return disk->isFile(path);
  }
  [[nodiscard]] std::filesystem::path canonical(const std::filesystem::path& path) const override;
  [[nodiscard]] std::expected<syntax::Document, std::string>
  document(const std::filesystem::path& path) const override;
  /// Reads a text instead of a file that holds data, until it is null: the text that is edited.
  void replaceData(const std::filesystem::path& path, std::optional<std::string> text);
  /// Whether the file at this path was ever read as data, such as a platform file, or would have
  /// been if it had existed: answers may depend on it.
  [[nodiscard]] bool wasRead(const std::filesystem::path& path) const;
  /// Resolves all links again, also those that lead to the same file, which may have been moved.
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
  std::unordered_map<std::string, std::string> edited; ///< data, by canonical name
  mutable std::unordered_set<std::string> dataFiles;   ///< canonical names of what was read
};

} // namespace proskill::lsp
