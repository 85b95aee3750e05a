#include "lsp/workspace/file_cache.h"

#include <sys/stat.h>

#include <algorithm>
#include <chrono>

namespace proskill::lsp {

namespace {

/// File time stamps are coarse: a file that has just changed may change again without another
/// stamp.
bool isSettled(const FileStamp& stamp) {
  using std::chrono::nanoseconds;
  constexpr nanoseconds kCoarse = std::chrono::milliseconds(100);
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return nanoseconds(std::max(stamp.modified, stamp.changed)) + kCoarse < now;
}

} // namespace

std::optional<FileStamp> stampOnDisk(const std::filesystem::path& path) {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0) return std::nullopt;
  auto nanoseconds = [](const timespec& time) {
    constexpr std::int64_t kSecond = 1'000'000'000;
    return time.tv_sec * kSecond + time.tv_nsec;
  };
  return FileStamp{found.st_dev, found.st_ino, nanoseconds(found.st_mtim),
                   nanoseconds(found.st_ctim), static_cast<std::uintmax_t>(found.st_size)};
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

std::expected<std::string, std::string> FileCache::read(const std::filesystem::path& path) const {
  auto identity = disk->canonical(path).native();
  {
    const std::lock_guard lock(mutex);
    const auto found = edited.find(identity);
    dataFiles.insert(std::move(identity));
    if (found != edited.end()) return found->second;
  }
  return disk->read(path);
}

void FileCache::replaceData(const std::filesystem::path& path, std::optional<std::string> text) {
  const auto identity = disk->canonical(path).native();
  const std::lock_guard lock(mutex);
  if (text)
    edited.insert_or_assign(identity, std::move(*text));
  else
    edited.erase(identity);
}

bool FileCache::wasRead(const std::filesystem::path& path) const {
  const auto identity = disk->canonical(path).native();
  const std::lock_guard lock(mutex);
  return dataFiles.contains(identity);
}

std::expected<syntax::Document, std::string>
FileCache::document(const std::filesystem::path& path) const {
  // read before the text: a change in between then causes another read
  const auto stamp = stampOf(path);
  {
    const std::lock_guard lock(mutex);
    const auto* known = entries.use(path.native());
    if (known && stamp && known->stamp == *stamp) return known->document;
    entries.drop(path.native());
  }
  auto document = disk->document(path);
  if (stamp && document && isSettled(*stamp)) {
    const std::lock_guard lock(mutex);
    entries.put(path.native(), {*stamp, *document}, document->text().size());
  }
  return document;
}

void FileCache::followAnew() {
  const std::lock_guard lock(mutex);
  followed.clear();
}

} // namespace proskill::lsp
