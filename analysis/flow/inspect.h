#pragma once

#include "analysis/flow/flow.h"

#include <map>
#include <optional>
#include <vector>

namespace proskill::analysis::flow {

/// The severities of findings.
struct Settings {
  /// Replaces the severity of the table; nullopt: the diagnostic is not reported. Errors of form,
  /// names and types keep their severity.
  std::map<syntax::Code, std::optional<syntax::Severity>> severities;
  bool style = false; ///< also report the hints of PS11xx, unless `severities` says otherwise
};

/// All diagnostics of a program: those of `check` and, if there are no errors and the program is
/// whole, those of its flow. Applies `settings` and comments that ignore diagnostics. In the order
/// of the files.
[[nodiscard]] std::vector<syntax::Diagnostic>
inspect(const Program& program, const Analysis& analysis, const Settings& settings = {});
/// The same with a known flow; null if it cannot be computed.
[[nodiscard]] std::vector<syntax::Diagnostic> inspect(const Program& program,
                                                      const Analysis& analysis,
                                                      const Settings& settings, const Flow* flow);
[[nodiscard]] std::vector<syntax::Diagnostic> inspect(const Program& program,
                                                      const Settings& settings = {});
/// The same with the diagnostics of `checkFlow`.
[[nodiscard]] std::vector<syntax::Diagnostic> weighed(const Program& program,
                                                      const Analysis& analysis,
                                                      const std::vector<syntax::Diagnostic>& ofFlow,
                                                      const Settings& settings);
/// The diagnostics that the settings report, with the severities of the settings.
[[nodiscard]] std::vector<syntax::Diagnostic> weighed(std::vector<syntax::Diagnostic> diagnostics,
                                                      const Settings& settings);

/// Whether `settings` may report a hint of style.
[[nodiscard]] bool wantsStyle(const Settings& settings);

/// Whether the program is whole and has no errors that would make its flow meaningless.
[[nodiscard]] bool hasFlow(const Program& program, const Analysis& analysis);

} // namespace proskill::analysis::flow
