#pragma once

#include <cstdint>
#include <expected>
#include <span>
#include <string>
#include <string_view>

namespace proskill::disk {

/// A file without a name, which is gone when it is closed, however the process ends. The errors are
/// messages.
class TemporaryFile {
public:
  using Done = std::expected<void, std::string>;

  /// Creates a file on the file system of a directory.
  [[nodiscard]] static std::expected<TemporaryFile, std::string>
  create(const std::string& directory);
  TemporaryFile(TemporaryFile&& other) noexcept;
  TemporaryFile& operator=(TemporaryFile&&) = delete;
  ~TemporaryFile();

  /// Adds bytes at the end.
  [[nodiscard]] Done append(std::string_view bytes);
  /// Reads bytes. It is an error if the file has fewer.
  [[nodiscard]] Done read(std::uint64_t at, std::span<char> to) const;
  /// Removes the content.
  [[nodiscard]] Done clear();

private:
  explicit TemporaryFile(int opened) : descriptor(opened) {}

  int descriptor = -1;
  std::uint64_t length = 0;
};

} // namespace proskill::disk
