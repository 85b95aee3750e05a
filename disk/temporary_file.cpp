#include "disk/temporary_file.h"

#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace proskill::disk {

namespace {

std::string messageOf(int error) { return std::generic_category().message(error); }

/// Some file systems have no files without names: there the name is removed at once.
int openNamed(const std::string& directory) {
  const std::string pattern = directory + "/proskill-XXXXXX";
  std::vector<char> path(pattern.c_str(), pattern.c_str() + pattern.size() + 1);
  const int opened = ::mkostemp(path.data(), O_CLOEXEC);
  if (opened >= 0) ::unlink(path.data());
  return opened;
}

int openNameless(const std::string& directory) {
#ifdef O_TMPFILE
  constexpr mode_t kOwnerOnly = 0600;
  const int opened = ::open(directory.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kOwnerOnly);
  if (opened >= 0 || (errno != EOPNOTSUPP && errno != EISDIR)) return opened;
#endif
  return openNamed(directory);
}

} // namespace

std::expected<TemporaryFile, std::string> TemporaryFile::create(const std::string& directory) {
  const int opened = openNameless(directory);
  if (opened < 0) return std::unexpected(messageOf(errno));
  return TemporaryFile(opened);
}

TemporaryFile::TemporaryFile(TemporaryFile&& other) noexcept
    : descriptor(std::exchange(other.descriptor, -1)), length(other.length) {}

TemporaryFile::~TemporaryFile() {
  if (descriptor >= 0) ::close(descriptor);
}

TemporaryFile::Done TemporaryFile::append(std::string_view bytes) {
  while (!bytes.empty()) {
    const auto count = ::pwrite(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(length));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return std::unexpected(messageOf(errno));
    length += static_cast<std::uint64_t>(count);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return {};
}

TemporaryFile::Done TemporaryFile::read(std::uint64_t at, std::span<char> to) const {
  while (!to.empty()) {
    const auto count = ::pread(descriptor, to.data(), to.size(), static_cast<off_t>(at));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return std::unexpected(messageOf(errno));
    if (count == 0) return std::unexpected("another program has shortened a file");
    at += static_cast<std::uint64_t>(count);
    to = to.subspan(static_cast<std::size_t>(count));
  }
  return {};
}

TemporaryFile::Done TemporaryFile::clear() {
  length = 0;
  if (::ftruncate(descriptor, 0) != 0) return std::unexpected(messageOf(errno));
  return {};
}

} // namespace proskill::disk
