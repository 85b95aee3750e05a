#pragma once

#include "analysis/flow/flow.h"

#include <map>
#include <optional>
#include <vector>

namespace proskill::analysis::flow {

/// How findings are weighed.
struct Settings {
  /// Instead of the severity of the table; nothing: not told at all. Errors of form, names and
  /// types stay what they are.
  std::map<syntax::Code, std::optional<syntax::Severity>> severities;
  bool style = false; ///< tell the hints of PS11xx too, where `severities` does not say
};

/// Everything that can be said about a program: what `check` says and, where that has no errors and
/// the program is whole, what its flow tells; weighed as `settings` say, without what comments ask
/// to ignore, in the order of the files.
[[nodiscard]] std::vector<syntax::Diagnostic>
inspect(const Program& program, const Analysis& analysis, const Settings& settings = {});
/// The same with the flow that is known already: null where it cannot be known.
[[nodiscard]] std::vector<syntax::Diagnostic> inspect(const Program& program,
                                                      const Analysis& analysis,
                                                      const Settings& settings, const Flow* flow);
[[nodiscard]] std::vector<syntax::Diagnostic> inspect(const Program& program,
                                                      const Settings& settings = {});
/// The same where `checkFlow` has been asked already.
[[nodiscard]] std::vector<syntax::Diagnostic> weighed(const Program& program,
                                                      const Analysis& analysis,
                                                      const std::vector<syntax::Diagnostic>& ofFlow,
                                                      const Settings& settings);
/// Those that the settings have told, with the severities that they say.
[[nodiscard]] std::vector<syntax::Diagnostic> weighed(std::vector<syntax::Diagnostic> diagnostics,
                                                      const Settings& settings);

/// Whether `settings` may have any of the hints of style told.
[[nodiscard]] bool wantsStyle(const Settings& settings);

/// The program is whole, and has no errors that would make its flow mean nothing.
[[nodiscard]] bool hasFlow(const Program& program, const Analysis& analysis);

} // namespace proskill::analysis::flow
