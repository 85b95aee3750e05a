#pragma once

#include "ide/verdicts/verification.h"
#include "report/ordered_json.h"

/// The JSON report of a verification, as `proskill verify --format json` prints it and as the
/// process that verifies for the language server sends it. The schema is docs/verify.schema.json.
namespace proskill::report {

struct VerifyReport {
  const analysis::Program& program;
  const codegen::Model& model;
  const ide::VerificationReport& result;
  std::string mainSkill; ///< empty: a library of skills
  std::string backend{}; ///< who verified: `tina`, `both`; empty: the engine alone
};

[[nodiscard]] OrderedJson reportJson(const VerifyReport& report);
/// One of the report's properties.
[[nodiscard]] OrderedJson propertyJson(const analysis::Program& program,
                                       const ide::VerdictRow& row);
[[nodiscard]] OrderedJson stepJson(const analysis::Program& program, const ide::TraceStep& step);
[[nodiscard]] OrderedJson traceJson(const analysis::Program& program, const ide::Trace& trace);
[[nodiscard]] OrderedJson explorationJson(const verify::Exploration& exploration);

} // namespace proskill::report
