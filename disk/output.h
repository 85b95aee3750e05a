#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

/// The one place where the program writes files.
namespace proskill::cli {

using WriteTo = std::function<void(std::ostream&)>;

/// Writes a file whole or not at all: a new one takes its place and its permissions. Through a
/// symbolic link, the file that it names. What is no file (a pipe, `/dev/stdout`) gets the bytes.
/// What went wrong, in words with the system's reason, or nothing.
[[nodiscard]] std::optional<std::string> writeFile(const std::filesystem::path& path,
                                                   const WriteTo& write);
[[nodiscard]] std::optional<std::string> writeFile(const std::filesystem::path& path,
                                                   std::string_view bytes);

/// The same, to standard output where the path is empty or `-`.
[[nodiscard]] std::optional<std::string> writeOutput(const std::filesystem::path& path,
                                                     std::string_view bytes);

} // namespace proskill::cli
