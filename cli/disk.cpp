#include "cli/disk.h"

#include "cli/render.h"
#include "ide/fiacre_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <iostream>
#include <span>
#include <system_error>
#include <unistd.h>

namespace proskill::cli {

namespace fs = std::filesystem;

namespace {

/// Places in a text are counted in 32 bits.
constexpr std::size_t kLargestFile = (std::size_t{1} << 32) - 1;

std::string reason(int error) {
  std::string words = std::generic_category().message(error);
  if (!words.empty() && words[0] >= 'A' && words[0] <= 'Z')
    words[0] = static_cast<char>(words[0] - 'A' + 'a');
  return words;
}

/// A descriptor of a file that is read, or none.
class OpenFile {
public:
  OpenFile(const fs::path& path, int flags)
      : descriptor(open(path.c_str(), O_RDONLY | O_CLOEXEC | flags)) {}
  ~OpenFile() {
    if (isOpen()) close(descriptor);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  [[nodiscard]] bool isOpen() const { return descriptor >= 0; }
  /// Bytes that were read; 0 at the end, -1 with `errno` where it cannot be read.
  ssize_t next(std::span<char> into) const {
    ssize_t count = 0;
    do count = ::read(descriptor, into.data(), into.size());
    while (count < 0 && errno == EINTR);
    return count;
  }

private:
  int descriptor;
};

} // namespace

std::expected<std::string, std::string> DiskFileSystem::read(const fs::path& path) const {
  std::error_code error;
  if (fs::is_directory(path, error)) return std::unexpected(reason(EISDIR));
  if (reads == Reads::OnlyFiles && fs::exists(path, error) && !isFile(path))
    return std::unexpected("it is a pipe or a device, not a file");
  // What calls itself a file and has nothing to say, as some below /proc, keeps nobody waiting.
  const OpenFile file(path, reads == Reads::OnlyFiles ? O_NONBLOCK : 0);
  if (!file.isOpen()) return std::unexpected(reason(errno));
  std::string text;
  const auto size = fs::file_size(path, error);
  if (!error && size <= kLargestFile) text.reserve(size);
  std::array<char, std::size_t{1} << 16> chunk;
  ssize_t count = 0;
  while ((count = file.next(chunk)) > 0) {
    text.append(chunk.data(), static_cast<std::size_t>(count));
    if (text.size() > kLargestFile) return std::unexpected("it is larger than 4 GiB");
  }
  if (count < 0) return std::unexpected(reason(errno));
  return text;
}

bool DiskFileSystem::isFile(const fs::path& path) const {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

fs::path DiskFileSystem::canonical(const fs::path& path) const {
  std::error_code error;
  const fs::path found = fs::weakly_canonical(path, error);
  return error ? path.lexically_normal() : found;
}

std::optional<analysis::Program> loadChecked(const std::string& root, ColourChoice colour) {
  if (ide::isFiacre(root)) {
    std::cerr << "error: `" << root << "` is a model in Fiacre, which only `check`, `verify` and "
              << "`fmt` read\n";
    return std::nullopt;
  }
  const DiskFileSystem disk;
  auto document = disk.document(root);
  if (!document) {
    std::cerr << "error: cannot read `" << root << "`: " << document.error() << '\n';
    return std::nullopt;
  }
  auto program = analysis::load(disk, root, std::move(*document));
  auto diagnostics = analysis::check(program);
  std::erase_if(diagnostics,
                [](const syntax::Diagnostic& it) { return it.severity == syntax::Severity::Hint; });
  render(std::cerr, program, diagnostics, Paint{wantsColour(colour, STDERR_FILENO)});
  const bool broken = std::ranges::any_of(diagnostics, [](const syntax::Diagnostic& it) {
    return it.severity == syntax::Severity::Error;
  });
  if (broken) return std::nullopt;
  return program;
}

} // namespace proskill::cli
