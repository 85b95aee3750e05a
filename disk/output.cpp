#include "disk/output.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <fcntl.h>
#include <iostream>
#include <streambuf>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace proskill::cli {
namespace {

namespace fs = std::filesystem;

/// No system follows more.
constexpr int kMostLinks = 40;

std::string failure(std::string_view where, int error) {
  return fmt::format("{} cannot be written: {}", where, std::generic_category().message(error));
}

/// A descriptor that is closed with its owner, and what is written to it.
class Descriptor : public std::streambuf {
public:
  explicit Descriptor(int opened) : descriptor(opened), failed(opened < 0 ? errno : 0) { rewind(); }
  ~Descriptor() override { (void)finish(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  /// The system's number of the first error, 0 where there is none.
  [[nodiscard]] int error() const { return failed; }
  /// Some errors are known only when a file is closed. \return error()
  [[nodiscard]] int finish() {
    if (descriptor < 0) return failed;
    sync();
    if (close(std::exchange(descriptor, -1)) != 0 && failed == 0) failed = errno;
    return failed;
  }
  /// As an earlier file was, as far as the system allows.
  void resemble(const struct stat& earlier) const {
    if (fchown(descriptor, earlier.st_uid, earlier.st_gid) != 0) errno = 0;
    if (fchmod(descriptor, earlier.st_mode & 07777) != 0) errno = 0;
  }

protected:
  int_type overflow(int_type byte) override {
    if (sync() != 0) return traits_type::eof();
    if (!traits_type::eq_int_type(byte, traits_type::eof())) sputc(traits_type::to_char_type(byte));
    return traits_type::not_eof(byte);
  }

  int sync() override {
    const char* from = pbase();
    while (failed == 0 && from < pptr()) {
      const auto count = ::write(descriptor, from, static_cast<std::size_t>(pptr() - from));
      if (count >= 0)
        from += count;
      else if (errno != EINTR)
        failed = errno;
    }
    rewind();
    return failed == 0 ? 0 : -1;
  }

private:
  void rewind() { setp(buffer.data(), buffer.data() + buffer.size()); }

  std::array<char, std::size_t{1} << 16> buffer;
  int descriptor;
  int failed;
};

/// \return the system's number of what went wrong, or 0
int writeThrough(Descriptor& to, const WriteTo& write) {
  std::ostream out(&to);
  if (to.error() == 0) write(out);
  return to.finish();
}

/// The descriptor of this process that a path names, as `/dev/stdout` does.
std::optional<int> ownDescriptor(const fs::path& path) {
  const auto name = path.filename().native();
  if (path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  if (path.parent_path() != "/dev/fd" && path.parent_path() != "/proc/self/fd") return std::nullopt;
  int number = 0;
  const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
  return read.ec == std::errc() ? std::optional(number) : std::nullopt;
}

/// Where symbolic links lead, even where there is nothing yet.
fs::path followLinks(fs::path path) {
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(path, error); ++i)
    path = path.parent_path() / fs::read_symlink(path, error);
  return path;
}

/// A name that no file beside it has.
fs::path nameBeside(const fs::path& target) {
  fs::path name;
  std::error_code error;
  for (int i = 0; i == 0 || fs::exists(fs::symlink_status(name, error)); ++i)
    name = target.parent_path() / fmt::format(".proskill-{}-{}", getpid(), i);
  return name;
}

/// \return the system's number of what went wrong, or 0
int replaceFile(const fs::path& path, const WriteTo& write) {
  const auto target = followLinks(path);
  struct stat earlier {};
  const bool exists = stat(target.c_str(), &earlier) == 0;
  if (exists && access(target.c_str(), W_OK) != 0) return errno;
  const auto fresh = nameBeside(target);
  const mode_t mode = exists ? earlier.st_mode & 0777 : 0666;
  Descriptor file(open(fresh.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
  if (file.error() != 0) return file.error();
  if (exists) file.resemble(earlier);
  int error = writeThrough(file, write);
  if (error == 0 && rename(fresh.c_str(), target.c_str()) != 0) error = errno;
  if (error != 0) unlink(fresh.c_str());
  return error;
}

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
    error = replaceFile(path, write);
  }
  return error == 0 ? std::nullopt : std::optional(failure(path.string(), error));
}

std::optional<std::string> writeFile(const fs::path& path, std::string_view bytes) {
  return writeFile(path, [bytes](std::ostream& out) { out << bytes; });
}

std::optional<std::string> writeOutput(const fs::path& path, std::string_view bytes) {
  if (!path.empty() && path != "-") return writeFile(path, bytes);
  std::cout << bytes << std::flush;
  return std::cout ? std::nullopt : std::optional(failure("standard output", errno));
}

} // namespace proskill::cli
