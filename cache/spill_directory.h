#pragma once

#include "verify/spill_store.h"

#include <expected>
#include <memory>
#include <string>

namespace proskill::cache {

/// A directory for the files of searches on disk. These have no names: nothing is left of them when
/// the process ends, and several processes may use the directory.
class SpillDirectory : public verify::SpillStore {
public:
  /// Makes sure that files can be created there. The error is a message.
  [[nodiscard]] static std::expected<std::unique_ptr<SpillDirectory>, std::string>
  open(const std::string& directory);

  [[nodiscard]] std::expected<std::unique_ptr<verify::SpillFile>, std::string> create() override;

private:
  explicit SpillDirectory(std::string path) : directory(std::move(path)) {}

  std::string directory;
};

} // namespace proskill::cache
