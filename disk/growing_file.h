#pragma once

#include <expected>
#include <optional>
#include <string>
#include <string_view>

namespace proskill::disk {

/// A file that grows, and whose end is always the same: each addition is written together with that
/// end over the former one. A process that is killed leaves what was added by then, with its end.
class GrowingFile {
public:
  /// A file that is there is emptied. What went wrong is in words.
  [[nodiscard]] static std::expected<GrowingFile, std::string> create(const std::string& path);
  GrowingFile(GrowingFile&& other) noexcept;
  GrowingFile& operator=(GrowingFile&&) = delete;
  ~GrowingFile();

  /// What went wrong, in words, or nothing. Where there is no room, what was there before stays.
  [[nodiscard]] std::optional<std::string> add(std::string_view bytes, std::string_view end);

private:
  GrowingFile(int opened, std::string named) : descriptor(opened), path(std::move(named)) {}

  int descriptor = -1;
  std::string path;
  std::int64_t length = 0; ///< without the end
  std::string buffer;
};

} // namespace proskill::disk
