#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace proskill::cli {

/// Writes all bytes to the file, or to standard output where the path is empty or `-`.
/// What went wrong, in words with the system's reason, or nothing.
[[nodiscard]] std::optional<std::string> writeOutput(const std::filesystem::path& path,
                                                     std::string_view bytes);

/// Writes a file whole or not at all: a new one takes its place, with its permissions. Through a
/// symbolic link, the file that it names. What went wrong, in words, or nothing.
[[nodiscard]] std::optional<std::string> replaceFile(const std::filesystem::path& path,
                                                     std::string_view bytes);

} // namespace proskill::cli
