#include "lsp/file_cache.h"

#include <sys/stat.h>

#include <chrono>

namespace proskill::lsp {

namespace {

/// Clocks of files are coarse: what was changed just now may change again without another stamp.
bool isSettled(const FileStamp& stamp) {
  using std::chrono::nanoseconds;
  constexpr nanoseconds kCoarse = std::chrono::milliseconds(100);
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return nanoseconds(stamp.modified) + kCoarse < now;
}

} // namespace

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
  const auto stamp = stampOf(path);
  {
    const std::lock_guard lock(mutex);
    const auto found = byPath.find(path.native());
    if (found != byPath.end() && stamp && found->second->stamp == *stamp) {
      entries.splice(entries.begin(), entries, found->second);
      return found->second->document;
    }
    if (found != byPath.end()) drop(found->second);
  }
  auto document = disk->document(path);
  if (stamp && document && isSettled(*stamp)) keep({path.native(), *stamp, *document});
  return document;
}

void FileCache::followAnew() {
  const std::lock_guard lock(mutex);
  followed.clear();
}

/// Another thread may have been quicker.
void FileCache::keep(Entry entry) const {
  const std::lock_guard lock(mutex);
  if (const auto found = byPath.find(entry.path); found != byPath.end()) drop(found->second);
  bytes += entry.document.text().size();
  entries.push_front(std::move(entry));
  byPath.emplace(entries.front().path, entries.begin());
  while (bytes > mostBytes) drop(std::prev(entries.end()));
}

/// \pre the mutex is held
void FileCache::drop(Entries::iterator entry) const {
  bytes -= entry->document.text().size();
  byPath.erase(entry->path);
  entries.erase(entry);
}

} // namespace proskill::lsp
