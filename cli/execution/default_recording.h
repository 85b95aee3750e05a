#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <filesystem>
#include <string>

namespace proskill::cli {

/// Number of recordings of a program that are kept, and their bytes together: a day with 100 steps
/// per second takes 12 GB. The last one is kept in any case.
inline constexpr std::size_t kMostRecordings = 20;
inline constexpr std::uint64_t kMostRecordedBytes = std::uint64_t{8} << 30;

/// The directory of recordings for which the user names no file: in `$STATE_DIRECTORY` (which
/// systemd sets), `$XDG_STATE_HOME/proskill` or `~/.local/state/proskill`; empty if there is none.
[[nodiscard]] std::filesystem::path recordingDirectory();

/// The path of a new recording, named after the program and the time. Deletes the oldest recordings
/// of the program, but none of a process that still runs. The error is a message.
[[nodiscard]] std::expected<std::string, std::string>
newRecording(const std::filesystem::path& directory, const std::filesystem::path& program);

} // namespace proskill::cli
