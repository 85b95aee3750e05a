#pragma once

#include "ide/snapshot/snapshot.h"

#include <expected>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// Renaming, over all files and all programs that a name is known in; strings and comments stay.
namespace proskill::ide {

/// The name at a place, or in words for a user why it cannot be renamed.
[[nodiscard]] std::expected<analysis::Occurrence, std::string> renameable(const View& view,
                                                                          syntax::Offset at);

/// Where the new name is to be written, by file, in the order of the texts.
using Renaming = std::map<std::filesystem::path, std::vector<syntax::Range>>;

struct RenamePlan {
  std::string text; ///< of each place
  Renaming places;
};

/// Refused, in words for a user, where the new name is none, is taken, or would make any name of
/// the program mean something else than before. The latter is not guessed: the renamed program is
/// analysed, and every name in it must mean what it meant.
[[nodiscard]] std::expected<RenamePlan, std::string>
rename(const Snapshot& snapshot, const View& view, syntax::Offset at, std::string_view newName);

/// The places of a label or a tag that are edited as one, the one at the place among them; empty
/// where there is none, or where some of them are in other files.
[[nodiscard]] std::vector<syntax::Range> linkedPlaces(const View& view, syntax::Offset at);

} // namespace proskill::ide
