#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace proskill::verify {

/// A file that one search writes and reads again, and that nobody needs afterwards. The errors are
/// messages.
class SpillFile {
public:
  using Done = std::expected<void, std::string>;

  SpillFile() = default;
  virtual ~SpillFile() = default;
  SpillFile(const SpillFile&) = delete;
  SpillFile& operator=(const SpillFile&) = delete;

  /// Adds bytes at the end.
  [[nodiscard]] virtual Done append(std::string_view bytes) = 0;
  /// Reads bytes that were added. Fewer than these are an error.
  [[nodiscard]] virtual Done read(std::uint64_t at, std::span<char> to) = 0;
  /// Removes everything that was added.
  [[nodiscard]] virtual Done clear() = 0;
};

/// Where searches keep what does not fit into memory.
class SpillStore {
public:
  SpillStore() = default;
  virtual ~SpillStore() = default;
  SpillStore(const SpillStore&) = delete;
  SpillStore& operator=(const SpillStore&) = delete;

  /// An empty file, which exists as long as the object. The error is a message.
  [[nodiscard]] virtual std::expected<std::unique_ptr<SpillFile>, std::string> create() = 0;
};

} // namespace proskill::verify
