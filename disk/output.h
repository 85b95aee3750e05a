#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

/// The one place where the program writes files.
namespace proskill::disk {

using WriteTo = std::function<void(std::ostream&)>;

/// Writes a file whole or not at all: a new one takes its place, its owner and its permissions. A
/// file that has several names (hard links), or whose directory lets nothing be created, is
/// written in place, once there is room for all of it. A symbolic link stands for the file that it
/// names. What is not a file (a pipe, `/dev/stdout`) gets the bytes.
/// \return what went wrong, with the system's reason, or nothing
[[nodiscard]] std::optional<std::string> writeFile(const std::filesystem::path& path,
                                                   const WriteTo& write);
[[nodiscard]] std::optional<std::string> writeFile(const std::filesystem::path& path,
                                                   std::string_view bytes);

/// The same, to standard output where the path is empty or `-`.
[[nodiscard]] std::optional<std::string> writeOutput(const std::filesystem::path& path,
                                                     std::string_view bytes);

} // namespace proskill::disk
