#include "disk/growing_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace proskill::disk {

namespace {

std::string notWritten(const std::string& path, int error) {
  return path + " cannot be written: " + std::generic_category().message(error);
}

iovec partOf(std::string_view bytes) {
  return {const_cast<char*>(bytes.data()), bytes.size()}; // which is only read
}

/// Writes both parts, one after the other. \return an error number of the system, or 0
int writeAt(int descriptor, std::string_view bytes, std::string_view end, std::int64_t at) {
  while (!bytes.empty() || !end.empty()) {
    const std::array parts{partOf(bytes), partOf(end)};
    const auto count = pwritev(descriptor, parts.data(), static_cast<int>(parts.size()), at);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count < 0 ? errno : EIO;
    const auto first = std::min(static_cast<std::size_t>(count), bytes.size());
    bytes.remove_prefix(first);
    end.remove_prefix(static_cast<std::size_t>(count) - first);
    at += count;
  }
  return 0;
}

/// What was written to a pipe cannot be overwritten, and opening it waits for a reader.
bool isPipe(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 && (S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode));
}

} // namespace

std::expected<GrowingFile, std::string> GrowingFile::create(const std::string& path) {
  if (isPipe(path))
    return std::unexpected(path + " cannot be written: it is a pipe, in which no end can be "
                                  "overwritten");
  GrowingFile file(path);
  if (const int error = file.open()) return std::unexpected(notWritten(path, error));
  return file;
}

/// \return an error number of the system, or 0; as all that follow
int GrowingFile::open() {
  struct stat earlier {};
  if (stat(path.c_str(), &earlier) != 0) return errno == ENOENT ? openBeside(nullptr) : errno;
  if (!S_ISREG(earlier.st_mode)) return openInPlace();
  if (access(path.c_str(), W_OK) != 0) return errno;
  const int error = earlier.st_nlink > 1 ? EPERM : openBeside(&earlier);
  if (!forbidsReplacing(error)) return error;
  replacement.reset();
  earlierSize = earlier.st_size;
  return openInPlace();
}

int GrowingFile::openBeside(const struct stat* earlier) {
  replacement = std::make_unique<Replacement>(followLinks(path));
  descriptor = replacement->create(earlier);
  return descriptor < 0 ? errno : 0;
}

int GrowingFile::openInPlace() {
  descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  return descriptor < 0 ? errno : 0;
}

GrowingFile::GrowingFile(GrowingFile&& other) noexcept
    : descriptor(std::exchange(other.descriptor, -1)),
      path(std::move(other.path)),
      replacement(std::move(other.replacement)),
      earlierSize(other.earlierSize),
      isBegun(other.isBegun),
      wasNamed(other.wasNamed),
      length(other.length),
      lastEnd(std::move(other.lastEnd)) {}

GrowingFile::~GrowingFile() {
  if (descriptor >= 0) close(descriptor);
}

std::optional<std::string> GrowingFile::add(std::string_view bytes, std::string_view end) {
  if (const int error = isBegun ? append(bytes, end) : begin(bytes, end))
    return notWritten(path, error);
  if (!std::exchange(isBegun, true)) wasNamed = isNamed();
  length += static_cast<std::int64_t>(bytes.size());
  lastEnd = end;
  return std::nullopt;
}

/// Gives up an earlier content only when the first addition is written, or has its space.
int GrowingFile::begin(std::string_view bytes, std::string_view end) {
  const auto size = static_cast<std::int64_t>(bytes.size() + end.size());
  if (earlierSize && size > 0)
    if (const int error = posix_fallocate(descriptor, 0, size)) {
      (void)ftruncate(descriptor, *earlierSize);
      return error;
    }
  if (const int error = writeAt(descriptor, bytes, end, 0)) return error;
  if (replacement) return replacement->replaceTarget();
  (void)ftruncate(descriptor, size); // a device has no size
  return 0;
}

/// After an error, restores the previous end, which needs no new space.
int GrowingFile::append(std::string_view bytes, std::string_view end) {
  const int error = writeAt(descriptor, bytes, end, length);
  if (error == 0) return 0;
  (void)writeAt(descriptor, lastEnd, {}, length);
  (void)ftruncate(descriptor, length + static_cast<std::int64_t>(lastEnd.size()));
  return error;
}

void GrowingFile::replace(std::uint64_t at, std::string_view bytes) const {
  (void)writeAt(descriptor, bytes, {}, static_cast<std::int64_t>(at));
}

void GrowingFile::sync() const { (void)fdatasync(descriptor); }

std::optional<std::string> GrowingFile::lost() const {
  if (!wasNamed || isNamed()) return std::nullopt;
  return path + " was removed or replaced during the run";
}

/// Whether a path leads to the file. A file in memory never had one.
bool GrowingFile::isNamed() const {
  struct stat found {};
  return fstat(descriptor, &found) == 0 && found.st_nlink > 0;
}

} // namespace proskill::disk
