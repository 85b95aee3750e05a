#include "disk/growing_file.h"

#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace proskill::disk {

namespace {

std::string notWritten(const std::string& path, int error) {
  return path + " cannot be written: " + std::generic_category().message(error);
}

/// \return an error number of the system, or 0
int writeAt(int descriptor, std::string_view bytes, std::int64_t at) {
  while (!bytes.empty()) {
    const auto count = pwrite(descriptor, bytes.data(), bytes.size(), at);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count < 0 ? errno : EIO;
    bytes.remove_prefix(static_cast<std::size_t>(count));
    at += count;
  }
  return 0;
}

} // namespace

std::expected<GrowingFile, std::string> GrowingFile::create(const std::string& path) {
  const int opened = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (opened < 0) return std::unexpected(notWritten(path, errno));
  return GrowingFile(opened, path);
}

GrowingFile::GrowingFile(GrowingFile&& other) noexcept
    : descriptor(std::exchange(other.descriptor, -1)),
      path(std::move(other.path)),
      length(other.length) {}

GrowingFile::~GrowingFile() {
  if (descriptor >= 0) close(descriptor);
}

std::optional<std::string> GrowingFile::add(std::string_view bytes, std::string_view end) {
  buffer.assign(bytes);
  buffer += end;
  if (const int error = writeAt(descriptor, buffer, length)) {
    // restore the previous end, which needs no new space
    (void)writeAt(descriptor, end, length);
    (void)ftruncate(descriptor, length + static_cast<std::int64_t>(end.size()));
    return notWritten(path, error);
  }
  length += static_cast<std::int64_t>(bytes.size());
  return std::nullopt;
}

void GrowingFile::sync() const { (void)fdatasync(descriptor); }

} // namespace proskill::disk
