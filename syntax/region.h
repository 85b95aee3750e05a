#pragma once

#include "syntax/diagnostics/diagnostic.h"
#include "syntax/tree/ast.h"
#include "syntax/tree/tree.h"

#include <memory>
#include <memory_resource>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::syntax {

/// The text of a region as it was parsed, as long as the original, and its concrete tree.
struct ParsedText {
  std::pmr::monotonic_buffer_resource arena; ///< of the forms
  std::string text;
  Tree tree;
  bool recovered =
      false; ///< something is missing or too much, also where `text` had no room for it
};

/// A region of a text that was parsed on its own: everything in it depends on its text alone.
/// Ranges count from its begin, but those of the forms once they were shifted.
struct ParsedRegion {
  std::unique_ptr<const ParsedText> parsed; ///< the forms look into it
  std::vector<ReadForm> forms;
  std::vector<Range> comments;
  std::vector<Diagnostic> diagnostics;
};

[[nodiscard]] ParsedRegion readRegion(Parser& parser, std::string_view text);
/// The regions of many texts, in their order; large ones are shared out to the processor's cores.
[[nodiscard]] std::vector<ParsedRegion> readRegions(const std::vector<std::string_view>& texts);

} // namespace proskill::syntax
