#include "cli/terminal/progress.h"

#include <fmt/format.h>

#include <cstdio>
#include <unistd.h>

namespace proskill::cli {

ProgressLine::ProgressLine() : terminal(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (shown) fmt::print(stderr, "\r\x1b[K");
}

std::function<void(const verify::Progress&)>
ProgressLine::callback(std::function<std::string()> more) {
  if (!terminal) return {};
  return [this, more = std::move(more)](const verify::Progress& progress) {
    show(progress, more ? more() : "");
  };
}

void ProgressLine::show(const verify::Progress& progress, const std::string& more) {
  auto rate = progress.seconds > 0 ? static_cast<double>(progress.classes) / progress.seconds : 0;
  say(fmt::format("{} classes, {} markings, {} waiting, {:.0f} classes/s, {} MiB, {:.0f} s{}",
                  progress.classes, progress.markings, progress.waiting, rate,
                  progress.bytes / (1024 * 1024), progress.seconds, more));
}

void ProgressLine::say(const std::string& line) {
  if (!terminal) return;
  shown = true;
  fmt::print(stderr, "\r\x1b[K{}", line);
  std::fflush(stderr);
}

} // namespace proskill::cli
