#pragma once

#include "codegen/model.h"
#include "codegen/term/context.h"

#include <vector>

namespace proskill::codegen {

/// The message of a `printf`, with its arguments in the places of the directives. An argument that
/// the model does not contain, such as an input of type `float`, is `?`.
[[nodiscard]] std::vector<MessagePart> messageOf(Context& context, const syntax::Statement& printf);

} // namespace proskill::codegen
