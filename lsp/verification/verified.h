#pragma once

#include "ide/verdicts/verdicts.h"
#include "lsp/verification/verification_settings.h"
#include "report/ordered_json.h"
#include "report/report_json.h"
#include "rpc/rpc.h"

#include <map>
#include <memory>
#include <string>

namespace proskill::lsp {

/// A finished verification as the server keeps it: the verdicts, and the traces as unparsed
/// JSON.
struct Verified {
  std::shared_ptr<const ide::ProgramVerdicts> verdicts;
  std::string mainSkill;                     ///< empty: none
  std::map<std::string, std::string> traces; ///< by the property's name, as `traceJson` writes it
};

/// Reads a report (docs/verify.schema.json) on this program. Nothing if it has another form.
/// A reason that is a limit says which setting raises it.
[[nodiscard]] std::optional<Verified>
readReport(const OrderedJson& report, std::shared_ptr<const ide::AnalysedProgram> program,
           const ide::OpenTexts& open, const LimitSettings& limits);

/// A report that grows while its program is verified.
class GrowingReport {
public:
  GrowingReport(std::shared_ptr<const ide::AnalysedProgram> of, const ide::OpenTexts& now,
                LimitSettings raisedBy)
      : program(std::move(of)), open(now), limits(raisedBy) {}

  /// What is known with these rows of the report decided; the others are pending. Nothing where the
  /// report has not the form that it should have.
  [[nodiscard]] std::optional<Verified> with(const OrderedJson& report,
                                             const std::vector<std::size_t>& rows);

private:
  std::shared_ptr<const ide::AnalysedProgram> program;
  const ide::OpenTexts& open;
  LimitSettings limits;
  std::optional<Verified> known;
};

/// What is known after some properties have been verified again: the newer verdict of each, where
/// both are for the same texts; else the newer ones alone.
[[nodiscard]] Verified merged(const Verified& older, Verified newer);

/// The place that a report gives in `json`, in the program that it is about.
[[nodiscard]] std::optional<analysis::Location> locationIn(const analysis::Program& program,
                                                           const OrderedJson& json);

} // namespace proskill::lsp
