#pragma once

#include "ide/snapshot/snapshot.h"
#include "ide/verdicts/verdicts.h"

#include <optional>
#include <string>
#include <vector>

namespace proskill::ide {

enum class HintKind : std::uint8_t { ArgumentType, Values, Duration };

/// A word that an editor shows in a text without inserting it.
struct InlayHint {
  HintKind kind = HintKind::Values;
  syntax::Offset at = 0; ///< shown before this offset
  std::string label;
  std::string tooltip;
  std::optional<analysis::Location> about; ///< the name that it is about, where it is defined
};

/// In the order of the text: the types of inputs of calls with literals, the possible values of a
/// tested variable if they are fewer than elsewhere, and the durations of bodies. Facts about a
/// large program that are not computed yet are omitted. While a program has errors, the last two
/// are those of its last version without errors, except where the text has changed. A duration that
/// was measured for exactly these texts is shown as in lenses and hovers.
[[nodiscard]] std::vector<InlayHint> inlayHints(const View& view, syntax::Range range,
                                                const Verdicts& verdicts = {});

/// A name whose value a debugger shows next to it.
struct InlineVariable {
  syntax::Range range;
  std::string name;
};

/// The state variables that are named in a range, each once per line.
[[nodiscard]] std::vector<InlineVariable> inlineVariables(const View& view, syntax::Range range);

} // namespace proskill::ide
