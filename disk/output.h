#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

/// Writing of files. The program writes files only here.
namespace proskill::disk {

using WriteTo = std::function<void(std::ostream&)>;

/// Writes a file completely or not at all: a new file replaces it with the same owner and
/// permissions. If the file has several hard links, or its directory is not writable, it is written
/// in place once there is room for all of it. A symbolic link is followed. Anything else (a pipe,
/// `/dev/stdout`) simply receives the bytes.
/// \return a message with the system's reason, or nothing
[[nodiscard]] std::optional<std::string> writeFile(const std::filesystem::path& path,
                                                   const WriteTo& write);
[[nodiscard]] std::optional<std::string> writeFile(const std::filesystem::path& path,
                                                   std::string_view bytes);

/// The same; an empty path and `-` mean standard output.
[[nodiscard]] std::optional<std::string> writeOutput(const std::filesystem::path& path,
                                                     std::string_view bytes);

/// Whether `writeOutput` does not replace a file here: it is standard output, `/dev/stdout`, a pipe
/// or the like.
[[nodiscard]] bool isStream(const std::filesystem::path& output);

/// Whether an output would replace this file, under whatever name. Standard output replaces
/// nothing.
[[nodiscard]] bool replaces(const std::filesystem::path& output, const std::filesystem::path& file);

} // namespace proskill::disk
