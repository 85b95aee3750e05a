#pragma once

#include <expected>
#include <optional>
#include <string>
#include <string_view>

namespace proskill::disk {

/// A file that grows but always has the same end: each addition overwrites the previous end,
/// together with a new one. So after a crash the file contains everything added until then, with
/// its end.
class GrowingFile {
public:
  /// Creates a file or empties an existing one. The error is a message.
  [[nodiscard]] static std::expected<GrowingFile, std::string> create(const std::string& path);
  GrowingFile(GrowingFile&& other) noexcept;
  GrowingFile& operator=(GrowingFile&&) = delete;
  ~GrowingFile();

  /// Returns an error message, or nothing. If the disk is full, the previous content stays.
  [[nodiscard]] std::optional<std::string> add(std::string_view bytes, std::string_view end);
  /// Waits until the disk has what was added.
  void sync() const;

private:
  GrowingFile(int opened, std::string named) : descriptor(opened), path(std::move(named)) {}

  int descriptor = -1;
  std::string path;
  std::int64_t length = 0; ///< without its end
  std::string buffer;
};

} // namespace proskill::disk
