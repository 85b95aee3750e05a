#pragma once

#include "analysis/program/program.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace proskill::runtime {

/// What a platform file says to a reader. Words in backquotes are code.
struct PlatformSummary {
  std::string sentence; ///< who performs the actions: "The program `robot` performs the actions."
  /// By basic skill, in the order of the program: "service `/motors`". Only those about
  /// which the file says more than the sentence.
  std::vector<std::pair<std::string, std::string>> actions;
};

/// Nothing if the text is not a platform file. Errors in its parts are ignored.
[[nodiscard]] std::optional<PlatformSummary> platformSummary(std::string_view text,
                                                             const analysis::Program& program);

} // namespace proskill::runtime
