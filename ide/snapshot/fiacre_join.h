#pragma once

#include "codegen/model.h"
#include "syntax/diagnostics/diagnostic.h"

#include <optional>
#include <string_view>

namespace proskill::ide {

/// Some dialects allow several `from` for one state, Fiacre only one. Returns the edit that merges
/// both with `select`; nothing if `second` is not such a `from`.
/// \param second the origin of the later one
[[nodiscard]] std::optional<syntax::Fix> joinedFrom(const codegen::Model& model,
                                                    fiacre::OriginId second, std::string_view text);

} // namespace proskill::ide
