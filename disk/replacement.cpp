#include "disk/replacement.h"

#include <fmt/format.h>

#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

namespace proskill::disk {

namespace fs = std::filesystem;

namespace {

/// Linux follows no more than this many.
constexpr int kMostLinks = 40;

/// An unused name in the same directory.
fs::path nameBeside(const fs::path& target) {
  fs::path name;
  std::error_code error;
  for (int i = 0; i == 0 || fs::exists(fs::symlink_status(name, error)); ++i)
    name = target.parent_path() / fmt::format(".proskill-{}-{}", getpid(), i);
  return name;
}

/// Gives a new file the owner, group and permissions of an earlier one. \return whether it could
bool giveTo(int file, const struct stat& earlier) {
  return fchown(file, earlier.st_uid, earlier.st_gid) == 0 &&
         fchmod(file, earlier.st_mode & 07777) == 0;
}

} // namespace

fs::path followLinks(fs::path path) {
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(path, error); ++i)
    path = path.parent_path() / fs::read_symlink(path, error);
  return path;
}

Replacement::Replacement(const fs::path& replaced) : target(replaced) {}

Replacement::~Replacement() {
  if (!fresh.empty()) unlink(fresh.c_str());
}

int Replacement::create(const struct stat* earlier) {
  const auto name = nameBeside(target);
  const mode_t mode = earlier ? earlier->st_mode & 0777 : 0666;
  const int file = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  if (file < 0) return file;
  fresh = name;
  if (!earlier || giveTo(file, *earlier)) return file;
  close(file);
  errno = EPERM;
  return -1;
}

int Replacement::replaceTarget() {
  if (rename(fresh.c_str(), target.c_str()) != 0) return errno;
  fresh.clear();
  return 0;
}

bool forbidsReplacing(int error) {
  return error == EACCES || error == EPERM || error == EROFS || error == EBUSY;
}

} // namespace proskill::disk
