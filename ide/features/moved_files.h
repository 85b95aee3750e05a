#pragma once

#include "ide/snapshot/snapshot.h"
#include "syntax/text/edit.h"

#include <filesystem>
#include <map>
#include <vector>

namespace proskill::ide {

/// A file, or a folder with all that is in it, that gets another name.
struct Move {
  std::filesystem::path from;
  std::filesystem::path to;
};

/// What includes must say instead so that they lead to the same files after all of the moves, by
/// the files' names before them.
[[nodiscard]] std::map<std::filesystem::path, std::vector<syntax::TextEdit>>
includesAfter(const Snapshot& snapshot, const std::vector<Move>& moves);

} // namespace proskill::ide
