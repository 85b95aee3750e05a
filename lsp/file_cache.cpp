#include "lsp/file_cache.h"

namespace proskill::lsp {

std::optional<FileStamp> stampOnDisk(const std::filesystem::path& path) {
  std::error_code error;
  auto modified = std::filesystem::last_write_time(path, error);
  if (error) return std::nullopt;
  auto size = std::filesystem::file_size(path, error);
  if (error) return std::nullopt;
  return FileStamp{modified, size};
}

std::expected<syntax::Document, std::string>
FileCache::document(const std::filesystem::path& path) const {
  // Before the text: what changes while it is read is then read again, never kept.
  auto stamp = stampOf(path);
  if (stamp) {
    const std::lock_guard lock(mutex);
    auto found = entries.find(path);
    if (found != entries.end() && found->second.stamp == *stamp) return found->second.document;
  }
  auto document = disk->document(path);
  const std::lock_guard lock(mutex);
  if (stamp && document)
    entries.insert_or_assign(path, Entry{*stamp, *document});
  else
    entries.erase(path);
  return document;
}

} // namespace proskill::lsp
