#pragma once

#include "analysis/program/program.h"
#include "ide/verdicts/verification.h"
#include "report/report_json.h"

#include <iosfwd>
#include <string>

/// The report of `proskill verify` in its formats. Each writer takes the same finished report.
namespace proskill::report {

enum class ShowTraces : std::uint8_t { Failed, All, None };

struct TextOptions {
  bool colour = false;
  ShowTraces traces = ShowTraces::Failed;
};

void writeText(std::ostream& out, const VerifyReport& report, const TextOptions& options);
/// The schema is docs/verify.schema.json.
void writeJson(std::ostream& out, const VerifyReport& report);
/// A test case a property, a test suite a subject, as CI servers read them.
void writeJUnit(std::ostream& out, const VerifyReport& report);
/// SARIF 2.1.0: a result for each property that is bad or inconclusive, its trace as a code flow.
void writeSarif(std::ostream& out, const VerifyReport& report);

/// One property's trace, as the text report shows it.
void writeTrace(std::ostream& out, const VerifyReport& report, const ide::VerdictRow& row,
                bool colour);

/// `path:line:column`, counted from 1.
[[nodiscard]] std::string place(const analysis::Program& program, analysis::Location location);

} // namespace proskill::report
