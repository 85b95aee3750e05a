#include "disk/disk.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <span>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace proskill::disk {

namespace fs = std::filesystem;

namespace {

/// In bytes. A larger file was not written by a person.
constexpr std::size_t kLargestFile = std::size_t{256} << 20;
constexpr std::string_view kTooLarge = "it is larger than 256 MiB";

std::string reason(int error) {
  std::string words = std::generic_category().message(error);
  if (!words.empty() && words[0] >= 'A' && words[0] <= 'Z')
    words[0] = static_cast<char>(words[0] - 'A' + 'a');
  return words;
}

/// Why the file at a path cannot be read; nullopt if it is a regular file.
std::optional<std::string> unreadable(const struct stat& found) {
  switch (found.st_mode & S_IFMT) {
  case S_IFREG: break;
  case S_IFDIR: return reason(EISDIR);
  case S_IFIFO: return "it is a pipe, and only regular files are read";
  case S_IFSOCK: return "it is a socket, and only regular files are read";
  default: return "it is a device, and only regular files are read";
  }
  if (static_cast<std::size_t>(found.st_size) > kLargestFile) return std::string(kTooLarge);
  return std::nullopt;
}

/// Descriptor of a file opened for reading, or none.
class OpenFile {
public:
  /// Non-blocking, since some files below /proc would block.
  explicit OpenFile(const fs::path& path)
      : descriptor(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {}
  ~OpenFile() {
    if (isOpen()) close(descriptor);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  [[nodiscard]] bool isOpen() const { return descriptor >= 0; }
  [[nodiscard]] bool look(struct stat& found) const { return fstat(descriptor, &found) == 0; }
  /// \return number of bytes read; 0 at the end, -1 with `errno` on an error
  ssize_t next(std::span<char> into) const {
    ssize_t count = 0;
    do count = ::read(descriptor, into.data(), into.size());
    while (count < 0 && errno == EINTR);
    return count;
  }

private:
  int descriptor;
};

/// Reads a whole file, which may grow meanwhile.
std::expected<std::string, std::string> readAll(const OpenFile& file, std::size_t expected) {
  std::string text;
  text.reserve(expected);
  std::array<char, std::size_t{1} << 16> chunk;
  ssize_t count = 0;
  while ((count = file.next(chunk)) > 0) {
    text.append(chunk.data(), static_cast<std::size_t>(count));
    if (text.size() > kLargestFile) return std::unexpected(std::string(kTooLarge));
  }
  if (count < 0) return std::unexpected(reason(errno));
  return text;
}

} // namespace

/// Checks the type of the file before it opens it, since opening alone can wake a device or the
/// other end of a pipe. Checks again afterwards, since the path may have changed meanwhile.
std::expected<std::string, std::string> DiskFileSystem::read(const fs::path& path) const {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0) return std::unexpected(reason(errno));
  if (auto why = unreadable(found)) return std::unexpected(std::move(*why));
  const OpenFile file(path);
  if (!file.isOpen() || !file.look(found)) return std::unexpected(reason(errno));
  if (auto why = unreadable(found)) return std::unexpected(std::move(*why));
  return readAll(file, static_cast<std::size_t>(found.st_size));
}

bool DiskFileSystem::isFile(const fs::path& path) const {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

std::vector<fs::path> DiskFileSystem::filesBelow(const fs::path& folder,
                                                 std::string_view extension) const {
  constexpr int kMostEntries = 5000;
  std::vector<fs::path> found;
  std::error_code error;
  fs::recursive_directory_iterator walk(folder, fs::directory_options::skip_permission_denied,
                                        error);
  const fs::recursive_directory_iterator end;
  for (int entries = 0; !error && walk != end && entries < kMostEntries; ++entries) {
    const auto& path = walk->path();
    if (walk.depth() > 0 || path.filename().native().starts_with('.'))
      walk.disable_recursion_pending();
    if (path.extension() == extension && isFile(path)) found.push_back(path);
    walk.increment(error);
  }
  std::ranges::sort(found);
  return found;
}

fs::path DiskFileSystem::canonical(const fs::path& path) const {
  std::error_code error;
  const fs::path found = fs::weakly_canonical(path, error);
  return error ? path.lexically_normal() : found;
}

} // namespace proskill::disk
