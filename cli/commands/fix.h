#pragma once

#include "report/check/check_report.h"

#include <expected>
#include <span>
#include <string>

namespace proskill::cli {

struct FixCount {
  std::size_t findings = 0;
  std::size_t files = 0;
};

/// Applies the fixes of findings to their files. A finding is fixed if it has exactly one fix, and
/// no earlier fix touches the same place. Forbidden moves are not fixed, since only the user knows
/// whether the move or the list of transitions is wrong. The error is a message for the user.
[[nodiscard]] std::expected<FixCount, std::string>
applyFixes(std::span<const report::CheckedProgram> programs);

} // namespace proskill::cli
