#pragma once

#include "lsp/protocol/convert.h"
#include "lsp/verification/verified.h"
#include "report/ordered_json.h"
#include "worker/run_worker.h"

/// The shapes of docs/lsp.md for verdicts and traces.
namespace proskill::lsp {

/// The texts of a program with their versions, as an answer bears them.
[[nodiscard]] Json textsJson(const analysis::Program& program, const ide::OpenTexts& open);
/// Those that verdicts are for.
[[nodiscard]] Json textsJson(const ide::ProgramVerdicts& verdicts, const Converter& convert);

[[nodiscard]] Json verdictJson(const ide::PropertyVerdict& property, const Converter& convert);
[[nodiscard]] Json verdictsJson(const ide::ProgramVerdicts& verdicts, const Converter& convert);
/// Those that differ. \pre both have the same names in the same order
[[nodiscard]] Json changedVerdictsJson(const ide::ProgramVerdicts& before,
                                       const ide::ProgramVerdicts& now, const Converter& convert);
[[nodiscard]] Json countsJson(const std::vector<ide::PropertyVerdict>& properties);
[[nodiscard]] Json explorationSummary(const verify::Exploration& exploration);
[[nodiscard]] Json progressJson(const worker::WorkerProgress& progress);

/// Steps of a trace, in the form of reports, as `proskill/trace` has them.
[[nodiscard]] Json stepsJson(const analysis::Program& program, const OrderedJson& steps,
                             const Converter& convert);
/// Who acts in such steps, in the order in which they come.
[[nodiscard]] Json actorsJson(const analysis::Program& program, const OrderedJson& steps);
/// `takeoff.status` is the skill's, all that bears a variable's name is the program's own.
[[nodiscard]] Json variablesJson(const analysis::Program& program, const OrderedJson& initial);

/// `proskill/trace`. \pre there is a trace of that name
[[nodiscard]] Json traceOf(const Verified& verified, const std::string& name, bool stale,
                           const Converter& convert);

/// What is bad of a file in the programs that it belongs to, as diagnostics; of verdicts that are
/// for just these texts.
[[nodiscard]] Json verdictDiagnostics(const ide::Verdicts& verdicts, const ide::Snapshot& snapshot,
                                      const std::filesystem::path& file,
                                      const ClientFeatures& client);

} // namespace proskill::lsp
