#pragma once

#include "codegen/model.h"
#include "syntax/diagnostics/diagnostic.h"

#include <optional>
#include <string_view>

namespace proskill::ide {

/// Some dialects have several `from` of one state; Fiacre has one. \param second the origin of the
/// later one. \return the edit that makes one of the two, with `select`; nothing where `second` is
/// no such `from`
[[nodiscard]] std::optional<syntax::Fix> joinedFrom(const codegen::Model& model,
                                                    fiacre::OriginId second, std::string_view text);

} // namespace proskill::ide
