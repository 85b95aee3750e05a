#pragma once

#include "report/check_report.h"

#include <expected>
#include <span>
#include <string>

namespace proskill::cli {

struct FixCount {
  std::size_t findings = 0;
  std::size_t files = 0;
};

/// Writes the edits that findings carry to their files: where a finding has exactly one, and no
/// earlier one touches the same place. Forbidden moves are left alone: whether the move or the
/// transition is wrong is for a person to say. An error is a sentence for the user.
[[nodiscard]] std::expected<FixCount, std::string>
applyFixes(std::span<const report::CheckedProgram> programs);

} // namespace proskill::cli
