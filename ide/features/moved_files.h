#pragma once

#include "ide/snapshot/snapshot.h"
#include "syntax/text/edit.h"

#include <filesystem>
#include <map>
#include <vector>

namespace proskill::ide {

/// A file, or a folder with its content, that is renamed.
struct Move {
  std::filesystem::path from;
  std::filesystem::path to;
};

/// The edits of includes after which they refer to the same files as before the moves. By the
/// files' old names.
[[nodiscard]] std::map<std::filesystem::path, std::vector<syntax::TextEdit>>
includesAfter(const Snapshot& snapshot, const std::vector<Move>& moves);

} // namespace proskill::ide
