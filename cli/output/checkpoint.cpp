#include "cli/output/checkpoint.h"

#include "syntax/text/utf8.h"

#include <fmt/format.h>

#include <iostream>
#include <system_error>
#include <unistd.h>

namespace proskill::cli {

namespace {

/// Prints a line, in place of the line of progress if there is one.
void say(const std::string& line) {
  std::cerr << (isatty(STDERR_FILENO) == 1 ? "\r\x1b[K" : "") << syntax::printable(line) << '\n';
}

} // namespace

std::expected<std::unique_ptr<cache::CheckpointFile>, std::string>
openCheckpoint(const CheckpointArguments& arguments, cache::CheckpointKey key) {
  if (arguments.file.empty()) return nullptr;
  return cache::CheckpointFile::open(arguments.file, arguments.every, std::move(key), say);
}

std::function<std::string()> timeOfCheckpoint(const cache::CheckpointFile* file) {
  if (!file) return {};
  return [file]() -> std::string {
    const auto saved = file->savedAt();
    if (!saved) return ", not saved yet";
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - *saved;
    return fmt::format(", saved {:.0f} s ago", since.count());
  };
}

void closeCheckpoint(cache::CheckpointFile* file) {
  if (!file) return;
  file->removeIfFinished();
  std::error_code missing;
  const auto bytes = std::filesystem::file_size(file->path(), missing);
  if (!file->isNeeded() || missing) return;
  constexpr double kMegabyte = 1e6;
  say(fmt::format("the state of the search is in `{}` ({:.1f} MB): the same command goes on from "
                  "there",
                  file->path().string(), static_cast<double>(bytes) / kMegabyte));
}

} // namespace proskill::cli
