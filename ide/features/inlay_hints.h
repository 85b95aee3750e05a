#pragma once

#include "ide/snapshot/snapshot.h"

#include <optional>
#include <string>
#include <vector>

namespace proskill::ide {

enum class HintKind : std::uint8_t { ArgumentType, Values, Duration };

/// A word that an editor shows in a text without its being there.
struct InlayHint {
  HintKind kind = HintKind::Values;
  syntax::Offset at = 0; ///< shown before what stands here
  std::string label;
  std::string tooltip;
  std::optional<analysis::Location>
      about; ///< the name of what it speaks about, where it is defined
};

/// In the order of the text: the types of the inputs of calls that are given literals, what a
/// tested variable can be there where that is less than it can be elsewhere, and how long bodies
/// take. What is not known yet of a large program is left out.
[[nodiscard]] std::vector<InlayHint> inlayHints(const View& view, syntax::Range range);

/// A name whose value a debugger shows beside it.
struct InlineVariable {
  syntax::Range range;
  std::string name;
};

/// The state variables that are named in a range, each once a line.
[[nodiscard]] std::vector<InlineVariable> inlineVariables(const View& view, syntax::Range range);

} // namespace proskill::ide
