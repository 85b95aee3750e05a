#pragma once

#include <cstdint>
#include <expected>
#include <filesystem>
#include <functional>
#include <string>

namespace proskill::disk {

/// A file of any size, of which parts are read. It may grow meanwhile.
class LargeFile {
public:
  /// The error is a message.
  [[nodiscard]] static std::expected<LargeFile, std::string>
  open(const std::filesystem::path& path);
  LargeFile(LargeFile&& other) noexcept;
  LargeFile& operator=(LargeFile&&) = delete;
  ~LargeFile();

  /// Number of bytes when it was opened.
  [[nodiscard]] std::uint64_t size() const { return length; }
  /// Fewer bytes are returned at the end of the file.
  [[nodiscard]] std::string read(std::uint64_t at, std::uint64_t bytes) const;
  /// The same as a function, which must not outlive this.
  [[nodiscard]] std::function<std::string(std::uint64_t at, std::uint64_t bytes)> reader() const {
    return [this](std::uint64_t at, std::uint64_t bytes) { return read(at, bytes); };
  }

private:
  LargeFile(int opened, std::uint64_t bytes) : descriptor(opened), length(bytes) {}

  int descriptor = -1;
  std::uint64_t length = 0;
};

} // namespace proskill::disk
