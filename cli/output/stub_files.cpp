#include "cli/output/stub_files.h"

#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "disk/disk.h"
#include "disk/output.h"
#include "syntax/text/utf8.h"

#include <fmt/format.h>

#include <iostream>

namespace proskill::cli {

namespace {

enum class Fate : std::uint8_t { Write, Keep, Refuse };

/// Files of users, and generated files that users have changed, are never overwritten.
Fate fateOf(const runtime::StubFile& file, const std::filesystem::path& path) {
  std::error_code none;
  if (!std::filesystem::exists(std::filesystem::symlink_status(path, none))) return Fate::Write;
  if (file.isUsers) return Fate::Keep;
  const auto text = disk::DiskFileSystem().read(path);
  return text && runtime::isUnchangedStub(*text) ? Fate::Write : Fate::Refuse;
}

} // namespace

int writeStubFiles(const std::vector<runtime::StubFile>& files,
                   const std::filesystem::path& directory) {
  for (const auto& file : files)
    if (fateOf(file, directory / file.name) == Fate::Refuse)
      return fail(fmt::format("`{}` is not as it was generated: move your changes elsewhere, and "
                              "remove it",
                              (directory / file.name).generic_string()));
  std::error_code problem;
  std::filesystem::create_directories(directory, problem);
  if (problem)
    return fail(
        fmt::format("cannot create `{}`: {}", directory.generic_string(), problem.message()));
  for (const auto& file : files) {
    const auto path = directory / file.name;
    std::filesystem::create_directories(path.parent_path(), problem); // writing the file reports
                                                                      // errors
    const bool writes = fateOf(file, path) == Fate::Write;
    if (writes)
      if (const auto why = disk::writeFile(path, file.text)) return fail(*why);
    std::cout << (writes ? "written: " : "kept:    ") << syntax::printable(path.generic_string())
              << '\n';
  }
  return kDone;
}

} // namespace proskill::cli
