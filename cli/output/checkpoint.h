#pragma once

#include "cache/checkpoint_file.h"

#include <expected>
#include <memory>
#include <string>

namespace proskill::cli {

struct CheckpointArguments {
  std::string file;  ///< empty: nothing is saved
  double every = 60; ///< seconds
};

/// The file that keeps the state of a verification; null if none is wanted. Says on standard error
/// where the search goes on, and what is wrong with writing. The error is a message.
[[nodiscard]] std::expected<std::unique_ptr<cache::CheckpointFile>, std::string>
openCheckpoint(const CheckpointArguments& arguments, cache::CheckpointKey key);

/// For the line of progress: when the state was last saved. \pre the file outlives it, or is null
[[nodiscard]] std::function<std::string()> timeOfCheckpoint(const cache::CheckpointFile* file);

/// Call this when the results have been delivered. Removes the file of a finished verification, and
/// says of another one how to go on. \param file may be null
void closeCheckpoint(cache::CheckpointFile* file);

} // namespace proskill::cli
