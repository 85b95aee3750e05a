#include "disk/durable_file.h"

#include "disk/descriptor.h"
#include "disk/replacement.h"

#include <fmt/format.h>

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace proskill::disk {

namespace {

namespace fs = std::filesystem;

std::string notWritten(const fs::path& path, int error) {
  const auto reason = error == EWOULDBLOCK ? "another process is writing it"
                                           : std::generic_category().message(error);
  return fmt::format("`{}` cannot be written: {}", path.string(), reason);
}

/// Another process may have replaced the file between opening and locking it.
bool isStill(int file, const fs::path& path) {
  struct stat opened {};
  struct stat named {};
  return fstat(file, &opened) == 0 && stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

/// Locks the file and empties it. \return an error number of the system, or 0
int take(int file, const fs::path& path) {
  if (flock(file, LOCK_EX | LOCK_NB) != 0) return errno;
  if (!isStill(file, path)) return EWOULDBLOCK;
  return ftruncate(file, 0) == 0 ? 0 : errno;
}

int openToWrite(const fs::path& path) {
  return open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
}

/// Makes sure that the new name is on the disk.
void syncDirectory(const fs::path& of) {
  const auto parent = of.parent_path();
  const int directory = open(parent.empty() ? "." : parent.c_str(), O_RDONLY | O_CLOEXEC);
  if (directory < 0) return;
  (void)fsync(directory);
  (void)close(directory);
}

} // namespace

DurableFile::DurableFile(const fs::path& named) : target(followLinks(named)), beside(target) {
  beside += ".new";
}

std::optional<std::string> DurableFile::obstacle() const {
  std::error_code error;
  const auto status = fs::status(target, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    return fmt::format("`{}` is not a regular file", target.string());
  const bool wasThere = fs::exists(beside, error);
  Descriptor file(openToWrite(beside));
  if (file.error() != 0) return notWritten(target, file.error());
  if (!wasThere) unlink(beside.c_str());
  return std::nullopt;
}

std::optional<std::string>
DurableFile::replace(const std::function<void(const Put&)>& write) const {
  Descriptor file(openToWrite(beside));
  if (file.error() != 0) return notWritten(target, file.error());
  int error = take(file.number(), beside);
  if (error != 0) return notWritten(target, error);
  write([&](std::string_view piece) {
    file.sputn(piece.data(), static_cast<std::streamsize>(piece.size()));
    return file.error() == 0;
  });
  file.pubsync();
  error = file.error();
  if (error == 0 && fsync(file.number()) != 0) error = errno;
  if (error == 0 && rename(beside.c_str(), target.c_str()) != 0) error = errno;
  if (error != 0) unlink(beside.c_str());
  if (error == 0) error = file.finish();
  if (error != 0) return notWritten(target, error);
  syncDirectory(target);
  return std::nullopt;
}

void DurableFile::remove() const {
  unlink(beside.c_str());
  unlink(target.c_str());
}

} // namespace proskill::disk
