#pragma once

#include "ide/verification.h"

#include <nlohmann/json.hpp>

/// The parts of the JSON report, for the formats that reuse them. The schema is
/// docs/verify.schema.json.
namespace proskill::cli {

struct VerifyReport;

[[nodiscard]] nlohmann::ordered_json reportJson(const VerifyReport& report);
[[nodiscard]] nlohmann::ordered_json traceJson(const analysis::Program& program,
                                               const ide::Trace& trace);
[[nodiscard]] nlohmann::ordered_json explorationJson(const verify::Exploration& exploration);

} // namespace proskill::cli
