#include "analysis/flow/inspect.h"

#include "analysis/flow/ignores.h"
#include "analysis/names/findings.h"

#include <algorithm>
#include <iterator>

namespace proskill::analysis::flow {

namespace {

using syntax::Diagnostic;
using syntax::Severity;

bool isError(const Diagnostic& diagnostic) { return diagnostic.severity == Severity::Error; }

bool isStyle(const Diagnostic& diagnostic) {
  return syntax::info(diagnostic.code).id.starts_with("PS11");
}

/// Whether the error concerns form, names or types, a Fiacre model, or the platform.
bool isFatal(const Diagnostic& diagnostic) {
  const auto id = syntax::info(diagnostic.code).id;
  return isError(diagnostic) && (id < "PS0500" || id >= "PS1300");
}

/// \return whether it is reported
bool weigh(Diagnostic& diagnostic, const Settings& settings) {
  auto found = settings.severities.find(diagnostic.code);
  if (found == settings.severities.end()) return settings.style || !isStyle(diagnostic);
  if (isFatal(diagnostic)) return true;
  if (found->second) diagnostic.severity = *found->second;
  return found->second.has_value();
}

} // namespace

bool wantsStyle(const Settings& settings) {
  return settings.style || std::ranges::any_of(settings.severities, [](const auto& entry) {
           return syntax::info(entry.first).id.starts_with("PS11");
         });
}

bool hasFlow(const Program& program, const Analysis& analysis) {
  return program.extent == Extent::Whole && std::ranges::none_of(analysis.diagnostics, isError);
}

std::vector<Diagnostic> inspect(const Program& program, const Analysis& analysis,
                                const Settings& settings) {
  if (!hasFlow(program, analysis)) return inspect(program, analysis, settings, nullptr);
  const Flow flow(program);
  return inspect(program, analysis, settings, &flow);
}

std::vector<Diagnostic> inspect(const Program& program, const Analysis& analysis,
                                const Settings& settings, const Flow* flow) {
  return weighed(program, analysis,
                 flow ? checkFlow(*flow, analysis.index, wantsStyle(settings))
                      : std::vector<Diagnostic>(),
                 settings);
}

std::vector<Diagnostic> weighed(std::vector<Diagnostic> diagnostics, const Settings& settings) {
  std::erase_if(diagnostics, [&](Diagnostic& each) { return !weigh(each, settings); });
  return diagnostics;
}

std::vector<Diagnostic> weighed(const Program& program, const Analysis& analysis,
                                const std::vector<Diagnostic>& ofFlow, const Settings& settings) {
  std::vector<Diagnostic> all = analysis.diagnostics;
  all.insert(all.end(), ofFlow.begin(), ofFlow.end());
  return withoutIgnored(program, weighed(std::move(all), settings));
}

std::vector<Diagnostic> inspect(const Program& program, const Settings& settings) {
  return inspect(program, analyse(program), settings);
}

} // namespace proskill::analysis::flow
