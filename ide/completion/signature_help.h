#pragma once

#include "ide/description/markup.h"
#include "ide/snapshot/snapshot.h"

#include <optional>
#include <string>
#include <vector>

namespace proskill::ide {

struct SignatureParameter {
  syntax::Range label; ///< in the signature, in bytes
  std::string documentation;
};

struct Signature {
  std::string label;
  Markup documentation;
  std::vector<SignatureParameter> parameters;
  std::optional<std::size_t> active; ///< which of them is being written
};

/// How the call, the form or the field around a place is written, innermost first: of a call the
/// inputs of the skill, of a clause its fields, of a statement or an operator its parts.
[[nodiscard]] std::optional<Signature> signatureHelp(const View& view, syntax::Offset at);

} // namespace proskill::ide
