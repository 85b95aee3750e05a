#pragma once

#include "analysis/program/program.h"
#include "report/text/paint.h"

#include <iosfwd>
#include <span>
#include <vector>

namespace proskill::report {

struct CheckedProgram {
  analysis::Program program;
  std::vector<syntax::Diagnostic> diagnostics;
};

/// The number of findings of each severity, and of checked files.
struct FindingCounts {
  std::size_t errors = 0;
  std::size_t warnings = 0;
  std::size_t hints = 0;
  std::size_t files = 0;
};
[[nodiscard]] FindingCounts countFindings(std::span<const CheckedProgram> programs);

/// One line each: `file:line:column: severity[CODE]: message`.
void writeCheckShort(std::ostream& out, std::span<const CheckedProgram> programs);
/// As docs/json.md says.
void writeCheckJson(std::ostream& out, std::span<const CheckedProgram> programs);
/// SARIF 2.1.0.
void writeCheckSarif(std::ostream& out, std::span<const CheckedProgram> programs);

} // namespace proskill::report
