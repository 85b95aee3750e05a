#pragma once

#include "ide/verdicts/durations.h"
#include "ide/verdicts/size_explanation.h"
#include "ide/verdicts/verification.h"
#include "report/ordered_json.h"

/// The JSON report of a verification, printed by `proskill verify --format json` and sent by the
/// process that verifies for the language server. The schema is docs/verify.schema.json.
namespace proskill::report {

/// Which traces a report contains: of failed properties, all, or none.
enum class ShowTraces : std::uint8_t { Failed, All, None };

/// The trace of a property if a report contains it, otherwise null.
[[nodiscard]] const ide::Trace* shownTrace(const ide::VerdictRow& row, ShowTraces traces);

struct VerifyReport {
  const analysis::Program& program;
  const codegen::Model& model;
  const ide::VerificationReport& result;
  std::string mainSkill; ///< empty: a library of skills
  std::string backend{}; ///< the backend: `tina`, `both`; empty: the engine alone
  ShowTraces traces = ShowTraces::All;
  std::vector<ide::SkillDuration> durations{}; ///< if they were asked for
  std::optional<ide::SizeExplanation> size{};  ///< likewise
};

[[nodiscard]] OrderedJson reportJson(const VerifyReport& report);
/// The members before the properties.
[[nodiscard]] OrderedJson reportHeadJson(const VerifyReport& report);
/// One of the report's properties.
[[nodiscard]] OrderedJson propertyJson(const analysis::Program& program, const ide::VerdictRow& row,
                                       ShowTraces traces = ShowTraces::All);
[[nodiscard]] OrderedJson locationJson(const analysis::Program& program,
                                       analysis::Location location);
/// Seconds as an exact string and as a number.
[[nodiscard]] OrderedJson secondsJson(syntax::Rational value);
[[nodiscard]] OrderedJson momentJson(const ide::Moment& moment);
[[nodiscard]] OrderedJson stepJson(const analysis::Program& program, const ide::TraceStep& step);
[[nodiscard]] OrderedJson traceJson(const analysis::Program& program, const ide::Trace& trace);
/// The same with an empty list of steps.
[[nodiscard]] OrderedJson traceJsonWithoutSteps(const analysis::Program& program,
                                                const ide::Trace& trace);
[[nodiscard]] OrderedJson explorationJson(const verify::Exploration& exploration);
[[nodiscard]] OrderedJson durationsJson(const std::vector<ide::SkillDuration>& durations);

} // namespace proskill::report
