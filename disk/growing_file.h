#pragma once

#include "disk/replacement.h"

#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace proskill::disk {

/// A file that grows but always has the same end: each addition overwrites the previous end,
/// together with a new one. So after a crash the file contains everything added until then, with
/// its end.
class GrowingFile {
public:
  /// Creates a file. An existing one stays until the first addition is written, which replaces it
  /// as a whole unless it has several hard links or nothing can be created beside it. The error is
  /// a message.
  [[nodiscard]] static std::expected<GrowingFile, std::string> create(const std::string& path);
  GrowingFile(GrowingFile&& other) noexcept;
  GrowingFile& operator=(GrowingFile&&) = delete;
  ~GrowingFile();

  /// Returns an error message, or nothing. If the disk is full, the previous content stays.
  [[nodiscard]] std::optional<std::string> add(std::string_view bytes, std::string_view end);
  /// Overwrites what was added before; its length stays. \pre it is a part of that
  void replace(std::uint64_t at, std::string_view bytes) const;
  /// Waits until the disk has what was added.
  void sync() const;
  /// Why no path leads to what was added: somebody has removed or replaced the file.
  [[nodiscard]] std::optional<std::string> lost() const;

private:
  explicit GrowingFile(std::string named) : path(std::move(named)) {}

  [[nodiscard]] bool isNamed() const;
  [[nodiscard]] int open();
  [[nodiscard]] int openBeside(const struct stat* earlier);
  [[nodiscard]] int openInPlace();
  [[nodiscard]] int begin(std::string_view bytes, std::string_view end);
  [[nodiscard]] int append(std::string_view bytes, std::string_view end);

  int descriptor = -1;
  std::string path;
  std::unique_ptr<Replacement> replacement; ///< of an earlier file, until that is replaced
  std::optional<std::int64_t> earlierSize;  ///< of a file that is overwritten in place
  bool isBegun = false;
  bool wasNamed = false;
  std::int64_t length = 0; ///< without its end
  std::string lastEnd;
};

} // namespace proskill::disk
