#pragma once

#include "syntax/text/source.h"

#include <expected>
#include <string>
#include <string_view>
#include <vector>

/// Renaming within a Fiacre text. Comments do not change.
namespace proskill::ide {

/// The name at a place, or the reason, for the user, why it cannot be renamed.
[[nodiscard]] std::expected<syntax::Range, std::string> renameableInFiacre(std::string_view text,
                                                                           syntax::Offset at);

/// The places of the new name, in the order of the text. Refused, with a reason for the user, if
/// the new name is not a name, would change the meaning of any name, or would make the model
/// invalid. The renamed text is parsed, and every name in it must have its old meaning.
[[nodiscard]] std::expected<std::vector<syntax::Range>, std::string>
renameInFiacre(std::string_view text, syntax::Offset at, std::string_view newName);

} // namespace proskill::ide
