#pragma once

#include "lsp/convert.h"
#include "lsp/run_worker.h"
#include "lsp/verified.h"

/// The shapes of docs/lsp.md for verdicts and traces.
namespace proskill::lsp {

/// The texts of a program with their versions, as an answer bears them.
[[nodiscard]] Json textsJson(const analysis::Program& program, const ide::OpenTexts& open);
/// Those that verdicts are for.
[[nodiscard]] Json textsJson(const ide::ProgramVerdicts& verdicts, const Converter& convert);

[[nodiscard]] Json verdictJson(const ide::PropertyVerdict& property, const Converter& convert);
[[nodiscard]] Json verdictsJson(const ide::ProgramVerdicts& verdicts, const Converter& convert);
[[nodiscard]] Json countsJson(const std::vector<ide::PropertyVerdict>& properties);
[[nodiscard]] Json explorationSummary(const verify::Exploration& exploration);
[[nodiscard]] Json progressJson(const WorkerProgress& progress);

/// `proskill/trace`. \pre there is a trace of that name
[[nodiscard]] Json traceOf(const Verified& verified, const std::string& name, bool stale,
                           const Converter& convert);

/// The bad ones of a file's properties, as diagnostics.
[[nodiscard]] Json verdictDiagnostics(const Verified& verified, analysis::FileId file,
                                      const Converter& convert, bool withTraces);

} // namespace proskill::lsp
