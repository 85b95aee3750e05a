#include "disk/output.h"

#include "disk/descriptor.h"
#include "disk/replacement.h"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <fcntl.h>
#include <fstream>
#include <iostream>
#include <sstream>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace proskill::disk {
namespace {

namespace fs = std::filesystem;

std::string failure(std::string_view where, int error) {
  return fmt::format("{} cannot be written: {}", where, std::generic_category().message(error));
}

/// \return an error number of the system, or 0
int writeThrough(Descriptor& to, const WriteTo& write) {
  std::ostream out(&to);
  if (to.error() == 0) write(out);
  return to.finish();
}

/// The descriptor of this process that a path such as `/dev/stdout` names.
std::optional<int> ownDescriptor(const fs::path& path) {
  const auto name = path.filename().native();
  if (path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  if (path.parent_path() != "/dev/fd" && path.parent_path() != "/proc/self/fd") return std::nullopt;
  int number = 0;
  const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
  return read.ec == std::errc() ? std::optional(number) : std::nullopt;
}

/// \return an error number of the system, or 0
int replaceFile(const fs::path& target, const struct stat* earlier, const WriteTo& write) {
  Replacement fresh(target);
  Descriptor file(fresh.create(earlier));
  const int error = writeThrough(file, write);
  return error == 0 ? fresh.replaceTarget() : error;
}

std::string contentOf(const fs::path& path) {
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  return content.str();
}

/// Writes bytes from the beginning of a file, and truncates the rest.
/// \return an error number of the system, or 0
int fill(const fs::path& target, std::string_view bytes) {
  Descriptor file(open(target.c_str(), O_WRONLY | O_CLOEXEC));
  std::ostream(&file) << bytes << std::flush;
  if (file.error() == 0 && ftruncate(file.number(), std::ssize(bytes)) != 0) return errno;
  return file.finish();
}

/// \return an error number of the system, or 0
int reserve(const fs::path& target, off_t size) {
  const Descriptor file(open(target.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.error() != 0 || size == 0) return file.error();
  return posix_fallocate(file.number(), 0, size);
}

/// Overwrites a file in place. Reserves the space for all of the new content first, and restores
/// the old content if writing fails.
/// \return an error number of the system, or 0
int overwriteFile(const fs::path& target, const WriteTo& write) {
  std::ostringstream content;
  write(content);
  const auto old = contentOf(target);
  int error = reserve(target, std::ssize(content.view()));
  if (error == 0) error = fill(target, content.view());
  if (error != 0 && access(target.c_str(), R_OK) == 0) (void)fill(target, old);
  return error;
}

/// Overwrites a file with several hard links in place.
/// \return an error number of the system, or 0
int writeRegularFile(const fs::path& target, const WriteTo& write) {
  struct stat earlier {};
  if (stat(target.c_str(), &earlier) != 0)
    return errno == ENOENT ? replaceFile(target, nullptr, write) : errno;
  if (access(target.c_str(), W_OK) != 0) return errno;
  if (earlier.st_nlink > 1) return overwriteFile(target, write);
  const int error = replaceFile(target, &earlier, write);
  return forbidsReplacing(error) ? overwriteFile(target, write) : error;
}

bool isStandardOutput(const fs::path& output) { return output.empty() || output == "-"; }

} // namespace

std::optional<std::string> writeFile(const fs::path& path, const WriteTo& write) {
  struct stat found {};
  int error = 0;
  if (const auto own = ownDescriptor(path)) {
    std::cout.flush();
    Descriptor stream(dup(*own));
    error = writeThrough(stream, write);
  } else if (stat(path.c_str(), &found) == 0 && !S_ISREG(found.st_mode)) {
    Descriptor device(open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
    error = writeThrough(device, write);
  } else {
    error = writeRegularFile(followLinks(path), write);
  }
  return error == 0 ? std::nullopt : std::optional(failure(path.string(), error));
}

std::optional<std::string> writeFile(const fs::path& path, std::string_view bytes) {
  return writeFile(path, [bytes](std::ostream& out) { out << bytes; });
}

std::optional<std::string> writeOutput(const fs::path& path, std::string_view bytes) {
  if (!isStandardOutput(path)) return writeFile(path, bytes);
  std::cout << bytes << std::flush;
  return std::cout ? std::nullopt : std::optional(failure("standard output", errno));
}

bool isStream(const fs::path& output) {
  if (isStandardOutput(output) || ownDescriptor(output)) return true;
  std::error_code missing;
  return fs::is_other(output, missing);
}

bool replaces(const fs::path& output, const fs::path& file) {
  if (isStandardOutput(output)) return false;
  std::error_code missing;
  return fs::equivalent(output, file, missing);
}

} // namespace proskill::disk
