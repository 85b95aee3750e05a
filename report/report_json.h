#pragma once

#include "ide/verdicts/verification.h"
#include "report/ordered_json.h"

/// The JSON report of a verification, printed by `proskill verify --format json` and sent by the
/// process that verifies for the language server. The schema is docs/verify.schema.json.
namespace proskill::report {

struct VerifyReport {
  const analysis::Program& program;
  const codegen::Model& model;
  const ide::VerificationReport& result;
  std::string mainSkill; ///< empty: a library of skills
  std::string backend{}; ///< the backend: `tina`, `both`; empty: the engine alone
};

[[nodiscard]] OrderedJson reportJson(const VerifyReport& report);
/// One of the report's properties.
[[nodiscard]] OrderedJson propertyJson(const analysis::Program& program,
                                       const ide::VerdictRow& row);
[[nodiscard]] OrderedJson stepJson(const analysis::Program& program, const ide::TraceStep& step);
[[nodiscard]] OrderedJson traceJson(const analysis::Program& program, const ide::Trace& trace);
[[nodiscard]] OrderedJson explorationJson(const verify::Exploration& exploration);

} // namespace proskill::report
