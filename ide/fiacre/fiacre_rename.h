#pragma once

#include "syntax/text/source.h"

#include <expected>
#include <string>
#include <string_view>
#include <vector>

/// Renaming within a text in Fiacre; comments stay.
namespace proskill::ide {

/// The name at a place, or in words for a user why it cannot be renamed.
[[nodiscard]] std::expected<syntax::Range, std::string> renameableInFiacre(std::string_view text,
                                                                           syntax::Offset at);

/// Where the new name is to be written, in the order of the text. Refused, in words for a user,
/// where the new name is none, or would make any name mean something else than before, or the model
/// wrong: the renamed text is read, and every name in it must mean what it meant.
[[nodiscard]] std::expected<std::vector<syntax::Range>, std::string>
renameInFiacre(std::string_view text, syntax::Offset at, std::string_view newName);

} // namespace proskill::ide
