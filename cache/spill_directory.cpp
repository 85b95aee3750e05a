#include "cache/spill_directory.h"

#include "disk/temporary_file.h"

#include <fmt/format.h>

namespace proskill::cache {

namespace {

/// A temporary file whose errors say where it is.
class File : public verify::SpillFile {
public:
  File(disk::TemporaryFile of, const std::string& in) : file(std::move(of)), directory(in) {}

  [[nodiscard]] Done append(std::string_view bytes) override {
    return explained("write", file.append(bytes));
  }
  [[nodiscard]] Done read(std::uint64_t at, std::span<char> to) override {
    return explained("read", file.read(at, to));
  }
  [[nodiscard]] Done clear() override { return explained("write", file.clear()); }

private:
  [[nodiscard]] Done explained(std::string_view what, Done done) const {
    if (done) return done;
    return std::unexpected(fmt::format("cannot {} the files of the search in `{}`: {}", what,
                                       directory, done.error()));
  }

  disk::TemporaryFile file;
  std::string directory;
};

} // namespace

std::expected<std::unique_ptr<SpillDirectory>, std::string>
SpillDirectory::open(const std::string& directory) {
  std::unique_ptr<SpillDirectory> made(new SpillDirectory(directory)); // the constructor is private
  if (auto probe = made->create(); !probe) return std::unexpected(probe.error());
  return made;
}

std::expected<std::unique_ptr<verify::SpillFile>, std::string> SpillDirectory::create() {
  auto file = disk::TemporaryFile::create(directory);
  if (!file)
    return std::unexpected(
        fmt::format("cannot create a file of the search in `{}`: {}", directory, file.error()));
  return std::make_unique<File>(std::move(*file), directory);
}

} // namespace proskill::cache
