#pragma once

#include "analysis/program/program.h"
#include "ide/verdicts/verification.h"
#include "report/report_json.h"

#include <iosfwd>
#include <string>

/// The report of `proskill verify` in its formats. Each writer takes the same finished report.
namespace proskill::report {

void writeText(std::ostream& out, const VerifyReport& report, bool colour);
/// The schema is docs/verify.schema.json.
void writeJson(std::ostream& out, const VerifyReport& report);
/// One test case per property and one test suite per subject, for CI servers.
void writeJUnit(std::ostream& out, const VerifyReport& report);
/// SARIF 2.1.0: one result for each property that is bad or inconclusive, with its trace as a code
/// flow.
void writeSarif(std::ostream& out, const VerifyReport& report);

/// The trace of one property, as in the text report.
void writeTrace(std::ostream& out, const VerifyReport& report, const ide::VerdictRow& row,
                bool colour);

/// `path:line:column`, counted from 1.
[[nodiscard]] std::string place(const analysis::Program& program, analysis::Location location);

} // namespace proskill::report
