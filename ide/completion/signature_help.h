#pragma once

#include "ide/description/markup.h"
#include "ide/snapshot/snapshot.h"

#include <optional>
#include <string>
#include <vector>

namespace proskill::ide {

struct SignatureParameter {
  syntax::Range label; ///< within the signature, in bytes
  std::string documentation;
};

struct Signature {
  std::string label;
  Markup documentation;
  std::vector<SignatureParameter> parameters;
  std::optional<std::size_t> active; ///< the parameter at the place
};

/// The signature of the innermost call, form or field around a place: the inputs of a skill, the
/// fields of a clause, or the parts of a statement or an operator.
[[nodiscard]] std::optional<Signature> signatureHelp(const View& view, syntax::Offset at);

} // namespace proskill::ide
