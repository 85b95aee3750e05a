#pragma once

#include <filesystem>
#include <sys/stat.h>

namespace proskill::disk {

/// Follows symbolic links, even to a file that does not exist.
[[nodiscard]] std::filesystem::path followLinks(std::filesystem::path path);

/// A new file in the directory of another one, which it replaces when its content is there. It is
/// removed if it does not come to that.
class Replacement {
public:
  /// \param target without links
  explicit Replacement(const std::filesystem::path& target);
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;
  ~Replacement();

  /// Creates the file, with the owner, group and permissions of the target if that exists.
  /// \return a descriptor, which the caller closes, or -1 with `errno`
  [[nodiscard]] int create(const struct stat* target);
  /// Replaces the target. \return an error number of the system, or 0
  [[nodiscard]] int replaceTarget();

private:
  std::filesystem::path target;
  std::filesystem::path fresh; ///< empty unless it is to be removed
};

/// Whether a file cannot be replaced by another, though it may be writable: somebody else owns it
/// or its directory, or it is a mount point.
[[nodiscard]] bool forbidsReplacing(int error);

} // namespace proskill::disk
