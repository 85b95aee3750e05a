#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace proskill::cache {

/// What outlives edits of a program, in a file that all versions of its model share: what never
/// happens in parts of it, and which version was verified last. A damaged file counts as none.
class KeptParts {
public:
  /// \param file read now, and written by save(); empty: nothing is kept
  explicit KeptParts(std::filesystem::path file);

  /// \param part a digest
  [[nodiscard]] bool contains(const std::string& part);
  void insert(const std::string& part);
  /// The file with the verdicts of the last version; empty if there is none.
  [[nodiscard]] const std::string& lastModel() const { return last; }
  void setLastModel(const std::string& file);

  /// Writes what is new, together with what other processes have written. Of too many parts, those
  /// are kept that were used or found since the file was read.
  /// \return an error message, or nothing
  [[nodiscard]] std::optional<std::string> save();

private:
  std::filesystem::path file;
  std::map<std::string, bool> parts; ///< by digest: whether it was used
  std::string last;
  bool isSaved = true;
};

} // namespace proskill::cache
