#include "lsp/file_cache.h"

#include <sys/stat.h>

namespace proskill::lsp {

std::optional<FileStamp> stampOnDisk(const std::filesystem::path& path) {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0) return std::nullopt;
  constexpr std::int64_t kSecond = 1'000'000'000;
  return FileStamp{found.st_dev, found.st_ino,
                   found.st_mtim.tv_sec * kSecond + found.st_mtim.tv_nsec,
                   static_cast<std::uintmax_t>(found.st_size)};
}

std::filesystem::path FileCache::canonical(const std::filesystem::path& path) const {
  const auto stamp = stampOf(path);
  if (!stamp) return disk->canonical(path);
  {
    const std::lock_guard lock(mutex);
    const auto found = followed.find(path.native());
    if (found != followed.end() && found->second.device == stamp->device &&
        found->second.inode == stamp->inode)
      return found->second.canonical;
  }
  auto canonical = disk->canonical(path);
  const std::lock_guard lock(mutex);
  followed.insert_or_assign(path.native(), Followed{stamp->device, stamp->inode, canonical});
  return canonical;
}

std::expected<syntax::Document, std::string>
FileCache::document(const std::filesystem::path& path) const {
  // Before the text: what changes while it is read is then read again, never kept.
  auto stamp = stampOf(path);
  if (stamp) {
    const std::lock_guard lock(mutex);
    auto found = entries.find(path.native());
    if (found != entries.end() && found->second.stamp == *stamp) return found->second.document;
  }
  auto document = disk->document(path);
  const std::lock_guard lock(mutex);
  if (stamp && document)
    entries.insert_or_assign(path.native(), Entry{*stamp, *document});
  else
    entries.erase(path.native());
  return document;
}

} // namespace proskill::lsp
