#include "cli/execution/default_recording.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <unistd.h>
#include <vector>

namespace proskill::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kExtension = ".mcap";

fs::path pathIn(const char* variable) {
  const char* value = std::getenv(variable);
  const std::string_view all(value ? value : "");
  const fs::path path(all.substr(0, all.find(':'))); // systemd lists several
  return path.is_absolute() ? path : fs::path();
}

/// `20261124T101500Z`, which is also the order of the names.
std::string dateOfNow() {
  return fmt::format("{:%Y%m%dT%H%M%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(
                                              std::chrono::system_clock::now())));
}

/// The process that writes a recording; 0 if the name is not that of one of the program.
pid_t writerOf(std::string_view name, std::string_view program) {
  constexpr std::size_t kDate = std::string_view("-20261124T101500Z-").size();
  if (!name.starts_with(program) || !name.ends_with(kExtension)) return 0;
  name.remove_prefix(program.size());
  name.remove_suffix(kExtension.size());
  if (name.size() <= kDate || name[0] != '-' || name[9] != 'T' ||
      !name.substr(0, kDate).ends_with("Z-"))
    return 0;
  pid_t process = 0;
  const auto* end = name.data() + name.size();
  const auto read = std::from_chars(name.data() + kDate, end, process);
  return read.ec == std::errc() && read.ptr == end ? process : 0;
}

bool runs(pid_t process) { return ::kill(process, 0) == 0 || errno == EPERM; }

struct Recorded {
  std::string name;
  std::uint64_t bytes = 0;
};

/// The recordings of a program, the newest first.
std::vector<Recorded> recordingsIn(const fs::path& directory, const std::string& program) {
  std::error_code ignored;
  std::vector<Recorded> all;
  for (fs::directory_iterator each(directory, ignored), end; !ignored && each != end;
       each.increment(ignored))
    if (auto name = each->path().filename().string(); writerOf(name, program) != 0) {
      std::error_code gone;
      const auto bytes = each->file_size(gone);
      all.push_back({std::move(name), gone ? 0 : bytes});
    }
  std::ranges::sort(all, std::greater(), &Recorded::name);
  return all;
}

/// Leaves room for one more. The newest one stays in any case.
void deleteOldest(const fs::path& directory, const std::string& program) {
  std::size_t newer = 0;
  std::uint64_t bytes = 0;
  for (const auto& each : recordingsIn(directory, program)) {
    bytes += each.bytes;
    const bool isKept = newer == 0 || (newer + 1 < kMostRecordings && bytes <= kMostRecordedBytes);
    ++newer;
    if (isKept || runs(writerOf(each.name, program))) continue;
    std::error_code ignored;
    fs::remove(directory / each.name, ignored);
  }
}

} // namespace

fs::path recordingDirectory() {
  constexpr auto kName = "recordings";
  if (const auto own = pathIn("STATE_DIRECTORY"); !own.empty()) return own / kName;
  if (const auto state = pathIn("XDG_STATE_HOME"); !state.empty())
    return state / "proskill" / kName;
  const auto home = pathIn("HOME");
  return home.empty() ? home : home / ".local/state/proskill" / kName;
}

std::expected<std::string, std::string> newRecording(const fs::path& directory,
                                                     const fs::path& program) {
  if (directory.empty()) return std::unexpected("there is no home directory");
  std::error_code error;
  fs::create_directories(directory, error);
  if (error)
    return std::unexpected(
        fmt::format("cannot create `{}`: {}", directory.string(), error.message()));
  const auto stem = program.stem().string();
  deleteOldest(directory, stem);
  return (directory / fmt::format("{}-{}-{}{}", stem, dateOfNow(), ::getpid(), kExtension))
      .string();
}

} // namespace proskill::cli
