#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace proskill::disk {

/// A file that is always whole, even if the process is killed or the machine loses power while it
/// is written: the new content goes to a file beside it (`.new` is added to the name), which
/// replaces it when the disk has all of it. Takes no memory.
class DurableFile {
public:
  /// Receives a piece of the content. \return false: writing has failed, so the rest is not needed
  using Put = std::function<bool(std::string_view)>;

  /// Follows symbolic links.
  explicit DurableFile(const std::filesystem::path& named);

  /// Where it is written.
  [[nodiscard]] const std::filesystem::path& path() const { return target; }
  /// Whether it can be written. \return an error message, or nothing
  [[nodiscard]] std::optional<std::string> obstacle() const;
  /// \return an error message, or nothing. After an error the previous content remains.
  [[nodiscard]] std::optional<std::string>
  replace(const std::function<void(const Put&)>& write) const;
  /// Removes it, if it is there.
  void remove() const;

private:
  std::filesystem::path target;
  std::filesystem::path beside;
};

} // namespace proskill::disk
