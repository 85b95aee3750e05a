#pragma once

#include "ide/snapshot/snapshot.h"

#include <expected>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// Renaming in all files and all programs that know a name. Strings and comments do not change.
namespace proskill::ide {

/// The name at a place, or the reason, for the user, why it cannot be renamed.
[[nodiscard]] std::expected<analysis::Occurrence, std::string> renameable(const View& view,
                                                                          syntax::Offset at);

/// The places of the new name, by file, in the order of the texts.
using Renaming = std::map<std::filesystem::path, std::vector<syntax::Range>>;

struct RenamePlan {
  std::string text; ///< the current text of each place
  Renaming places;
};

/// Refused, with a reason for the user, if the new name is not a name, is taken, or would change
/// the meaning of any name of the program. This is not guessed: the renamed program is analysed,
/// and every name in it must have its old meaning.
[[nodiscard]] std::expected<RenamePlan, std::string>
rename(const Snapshot& snapshot, const View& view, syntax::Offset at, std::string_view newName);

/// The places of a label or a tag that are edited together, including the one at the place. Empty
/// if there is none, or if some of them are in other files.
[[nodiscard]] std::vector<syntax::Range> linkedPlaces(const View& view, syntax::Offset at);

} // namespace proskill::ide
