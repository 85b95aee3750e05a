#include "disk/large_file.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace proskill::disk {

std::expected<LargeFile, std::string> LargeFile::open(const std::filesystem::path& path) {
  // Non-blocking, since opening a pipe would wait for its other end.
  const int opened = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (opened < 0) return std::unexpected(std::generic_category().message(errno));
  LargeFile file(opened, 0);
  struct stat found {};
  if (fstat(opened, &found) != 0 || !S_ISREG(found.st_mode))
    return std::unexpected("it is not a regular file");
  file.length = static_cast<std::uint64_t>(found.st_size);
  return file;
}

LargeFile::LargeFile(LargeFile&& other) noexcept
    : descriptor(std::exchange(other.descriptor, -1)), length(other.length) {}

LargeFile::~LargeFile() {
  if (descriptor >= 0) close(descriptor);
}

std::string LargeFile::read(std::uint64_t at, std::uint64_t bytes) const {
  if (at >= length) return {};
  std::string made(static_cast<std::size_t>(std::min(bytes, length - at)), '\0');
  std::size_t done = 0;
  while (done < made.size()) {
    const auto count =
        pread(descriptor, made.data() + done, made.size() - done, static_cast<off_t>(at + done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    done += static_cast<std::size_t>(count);
  }
  made.resize(done);
  return made;
}

} // namespace proskill::disk
