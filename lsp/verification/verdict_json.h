#pragma once

#include "analysis/program/originals.h"
#include "lsp/protocol/convert.h"
#include "lsp/verification/verified.h"
#include "report/ordered_json.h"
#include "worker/run_worker.h"

/// Verdicts and traces in the formats of docs/lsp.md.
namespace proskill::lsp {

/// The texts of a program with their versions, for answers.
[[nodiscard]] Json textsJson(const analysis::Program& program, const ide::OpenTexts& open);
/// The texts for which the verdicts were reached.
[[nodiscard]] Json textsJson(const ide::ProgramVerdicts& verdicts, const Converter& convert);

[[nodiscard]] Json verdictJson(const ide::PropertyVerdict& property, const Converter& convert);
[[nodiscard]] Json verdictsJson(const ide::ProgramVerdicts& verdicts, const Converter& convert);
/// The verdicts that differ. \pre both have the same names in the same order
[[nodiscard]] Json changedVerdictsJson(const ide::ProgramVerdicts& before,
                                       const ide::ProgramVerdicts& now, const Converter& convert);
[[nodiscard]] Json countsJson(const std::vector<ide::PropertyVerdict>& properties);
[[nodiscard]] Json explorationSummary(const verify::Exploration& exploration);
[[nodiscard]] Json progressJson(const worker::WorkerProgress& progress);

/// The original of a place, as an entry of `relatedInformation`.
[[nodiscard]] Json relatedOriginal(const analysis::Original& original);

/// The steps of a trace for `proskill/trace`, from those of a report.
[[nodiscard]] Json stepsJson(const analysis::Program& program, const OrderedJson& steps,
                             const Converter& convert);
/// The actors of such steps, in order of appearance.
[[nodiscard]] Json actorsJson(const analysis::Program& program, const OrderedJson& steps);
/// The variables of a trace: `takeoff.status` belongs to the skill, a state variable to the
/// program.
[[nodiscard]] Json variablesJson(const analysis::Program& program, const OrderedJson& initial);

/// `proskill/trace`. \pre there is a trace of that name
[[nodiscard]] Json traceOf(const Verified& verified, const std::string& name, bool stale,
                           const Converter& convert);

/// Bad verdicts about a file in its programs, as diagnostics; only verdicts for exactly these
/// texts.
[[nodiscard]] Json verdictDiagnostics(const ide::Verdicts& verdicts, const ide::Snapshot& snapshot,
                                      const std::filesystem::path& file,
                                      const ClientFeatures& client);

} // namespace proskill::lsp
