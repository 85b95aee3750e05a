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

/// The text of a region as it was parsed, of the same length as the original, and its concrete
/// tree.
struct ParsedText {
  std::pmr::monotonic_buffer_resource arena; ///< memory of the forms
  std::string text;
  Tree tree;
  bool recovered =
      false; ///< Something is missing or surplus, even if `text` had no room to repair it.
};

/// A region of a text that is parsed separately, so everything in it depends only on its own text.
/// Ranges count from its begin, except those of forms that were shifted.
struct ParsedRegion {
  std::unique_ptr<const ParsedText> parsed; ///< the forms refer to it
  std::vector<ReadForm> forms;
  std::vector<Range> comments;
  std::vector<Diagnostic> diagnostics;
};

[[nodiscard]] ParsedRegion readRegion(Parser& parser, std::string_view text);
/// Parses the regions of many texts, in order; large regions are distributed over the cores.
[[nodiscard]] std::vector<ParsedRegion> readRegions(const std::vector<std::string_view>& texts);

} // namespace proskill::syntax
