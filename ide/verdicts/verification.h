#pragma once

#include "codegen/model.h"
#include "verify/verify.h"

#include <expected>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// From a model to verdicts in the words of the program that it was made from.
namespace proskill::ide {

enum class Verdict : std::uint8_t { Holds, Violated, Reachable, Unreachable, Inconclusive };

[[nodiscard]] std::string_view toString(Verdict verdict);

/// A date or a delay in seconds; `strict`: not quite reached.
struct Moment {
  syntax::Rational seconds;
  bool strict = false;
};

/// One step of a trace, as a reader of the program sees it.
struct TraceStep {
  std::string actor;       ///< a skill, a branch, an event, the environment
  std::string description; ///< "succeeds with `at_altitude`"
  std::optional<analysis::Location> location;
  Moment earliest;
  std::optional<Moment> latest; ///< nothing: as late as one likes
  syntax::Rational date;        ///< in the run that was replayed, seconds since the start
  syntax::Rational delay;       ///< since the step before, in that run
  std::vector<verify::Change> changes;
  std::vector<std::string> transitions;  ///< of the Fiacre model
  std::vector<fiacre::OriginId> origins; ///< of what was passed, for places in the model's text
  std::string why; ///< why it came, or came so: "`energy` is 0 since step 15"; may be empty
  std::vector<std::size_t> causes; ///< steps that it depends on directly, from 0, ascending
  bool relevant = true;            ///< to what the trace shows: see verify/trace/causes.h
};

/// Who takes a step, and what it is, in the program's words.
struct StepName {
  std::string actor;
  std::string description;
};

[[nodiscard]] StepName nameOf(const verify::Step& step, const fiacre::Provenance& provenance);

/// A step in the program's words, without its dates.
[[nodiscard]] TraceStep inWords(verify::Step step, const fiacre::Provenance& provenance);

/// An interval of units of time in seconds: "2 to 8 s", "more than 3 s".
[[nodiscard]] std::string inSeconds(const fiacre::Interval& interval, syntax::Rational unit);

/// Seconds of a number of units, each 1/scale of the model's unit; a date that does not fit is as
/// good as the largest that does.
[[nodiscard]] syntax::Rational seconds(std::int64_t units, std::int64_t scale,
                                       syntax::Rational unit);
[[nodiscard]] syntax::Rational difference(syntax::Rational later, syntax::Rational earlier);

struct Trace {
  std::vector<verify::Change> initial;
  std::vector<TraceStep> steps;
  std::optional<std::size_t> loop; ///< the steps from this one on are repeated for ever
  /// Until when nothing else happens, where that is what is shown: seconds since the start.
  std::optional<syntax::Rational> end;
  verify::Rest rest = verify::Rest::No; ///< behind the last step
  std::string summary;                  ///< what the trace shows, in a sentence
};

/// The verdict on one property.
struct VerdictRow {
  const codegen::Check* check = nullptr; ///< lives in the model
  Verdict verdict = Verdict::Inconclusive;
  std::optional<analysis::Location> location;
  std::optional<Trace> trace;
  std::string
      reason; ///< why inconclusive; else what the verdict rests on, if not on the model alone

  /// Whether this is what one hopes for. An inconclusive verdict is neither good nor bad.
  [[nodiscard]] bool good() const;
  [[nodiscard]] bool bad() const { return verdict != Verdict::Inconclusive && !good(); }
};

struct VerificationReport {
  std::vector<VerdictRow> rows;
  verify::Exploration exploration;
};

/// Whether a check is asked for; an empty list of names asks for all. A name selects the check of
/// that name and all whose name it begins, up to a dot: `takeoff`, `takeoff.can_succeed`,
/// `takeoff.can_succeed.at_altitude`.
[[nodiscard]] bool selects(const std::vector<std::string>& names, const codegen::Check& check);

/// Selected checks of a model, in the model's order, and the question of each.
struct Asked {
  std::vector<const codegen::Check*> checks; ///< live in the model
  std::vector<verify::Question> questions;
};
[[nodiscard]] Asked askedOf(const codegen::Model& model, const std::vector<std::string>& names);

/// The verdicts that answers to these questions are, whoever gave them.
[[nodiscard]] VerificationReport reportOf(const codegen::Model& model, const Asked& asked,
                                          verify::Result result);

/// Gets a row of the report to come, by its place, as soon as its property is decided.
using OnRow = std::function<void(std::size_t, const VerdictRow&)>;

/// Which traces somebody looks at; the others are not made.
enum class WantedTraces : std::uint8_t {
  All,
  Findings, ///< of what may be bad
  None,
};

/// Verdicts on the selected checks of the model, in the model's order, from one exploration.
/// \param options its `decided` is not called
[[nodiscard]] std::expected<VerificationReport, verify::Unsupported>
verifyModel(const codegen::Model& model, const std::vector<std::string>& names,
            verify::Options options, const OnRow& onRow = {},
            WantedTraces wanted = WantedTraces::All);

} // namespace proskill::ide
