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
  std::string mainSkill; ///< empty: none
  /// By name of the property, as `traceJson` writes them. Of a large program only some are kept:
  /// see ide::kTracesOfEditor.
  std::map<std::string, std::shared_ptr<const std::string>> traces;
};

/// Reads a report (docs/verify.schema.json) on this program; nothing if it has another form. If a
/// limit is the reason of a verdict, the reason names the setting that raises it.
[[nodiscard]] std::optional<Verified>
readReport(const OrderedJson& report, std::shared_ptr<const ide::AnalysedProgram> program,
           const ide::OpenTexts& open, const LimitSettings& limits);

/// Reads the durations of a report that has nothing else; nothing if it has another form.
[[nodiscard]] std::optional<std::vector<ide::SkillDuration>>
readDurations(const OrderedJson& report);

/// A report that grows while its program is verified.
class GrowingReport {
public:
  GrowingReport(std::shared_ptr<const ide::AnalysedProgram> of, const ide::OpenTexts& now,
                LimitSettings raisedBy)
      : program(std::move(of)), open(now), limits(raisedBy) {}

  /// The verdicts when these rows of the report are decided; the others are pending. Nothing if the
  /// report is invalid.
  [[nodiscard]] std::optional<Verified> with(const OrderedJson& report,
                                             const std::vector<std::size_t>& rows);

private:
  std::shared_ptr<const ide::AnalysedProgram> program;
  const ide::OpenTexts& open;
  LimitSettings limits;
  std::optional<Verified> known;
};

/// The same verdicts, which are about all properties of the program.
[[nodiscard]] Verified ofWholeProgram(Verified verified);
/// The verdicts after some properties have been verified again: the newer verdict of each property
/// if both are for the same texts, unless only the older one is decided; otherwise only the newer
/// ones.
[[nodiscard]] Verified merged(const Verified& older, Verified newer);

/// The location in `json`, a part of a report on this program.
[[nodiscard]] std::optional<analysis::Location> locationIn(const analysis::Program& program,
                                                           const OrderedJson& json);

} // namespace proskill::lsp
