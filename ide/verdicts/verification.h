#pragma once

#include "analysis/program/originals.h"
#include "codegen/model.h"
#include "verify/verify.h"

#include <expected>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// From a model to verdicts in the program's terms.
namespace proskill::ide {

enum class Verdict : std::uint8_t { Holds, Violated, Reachable, Unreachable, Inconclusive };

[[nodiscard]] std::string_view toString(Verdict verdict);

/// A date or a delay in seconds. `strict`: the value itself is excluded.
struct Moment {
  syntax::Rational seconds;
  bool strict = false;

  bool operator==(const Moment&) const = default;
};

/// A step of a trace in the program's terms.
struct TraceStep {
  std::string actor;       ///< a skill, a branch, an event, the environment
  std::string description; ///< "succeeds with `at_altitude`"
  std::optional<analysis::Location> location;
  Moment earliest;
  std::optional<Moment> latest; ///< nullopt: unbounded
  syntax::Rational date;        ///< in the replayed run, in seconds since the start
  syntax::Rational delay;       ///< since the previous step in that run
  std::vector<verify::Change> changes;
  std::vector<std::string> transitions; ///< of the Fiacre model
  /// Of the passed statements, for places in the model's text.
  std::vector<fiacre::OriginId> origins;
  /// The reason for the step or its result: "`energy` is 0 since step 15"; may be empty.
  std::string why;
  std::vector<std::size_t> causes; ///< steps on which it directly depends, from 0, ascending
  bool relevant = true;            ///< to what the trace shows: see verify/trace/causes.h
};

/// The actor and the description of a step, in the program's terms.
struct StepName {
  std::string actor;
  std::string description;
};

[[nodiscard]] StepName nameOf(const verify::Step& step, const fiacre::Provenance& provenance);

/// The place of an origin in the program, if it has one.
[[nodiscard]] std::optional<analysis::Location> locate(const fiacre::Origin& origin);

/// A step in the program's terms, without dates.
[[nodiscard]] TraceStep inWords(verify::Step step, const fiacre::Provenance& provenance);

/// An interval in time units as text in seconds: "2 to 8 s", "more than 3 s".
[[nodiscard]] std::string inSeconds(const fiacre::Interval& interval, syntax::Rational unit);

/// Converts a number of units, each 1/scale of the model's unit, to seconds. A date that does not
/// fit becomes the greatest one that does.
[[nodiscard]] syntax::Rational seconds(std::int64_t units, std::int64_t scale,
                                       syntax::Rational unit);
[[nodiscard]] syntax::Rational difference(syntax::Rational later, syntax::Rational earlier);

struct Trace {
  std::vector<verify::Change> initial;
  std::vector<TraceStep> steps;
  std::optional<std::size_t> loop; ///< the steps from this one on repeat for ever
  /// The end of the time without further steps that the trace shows, in seconds since the start;
  /// nothing if the steps alone show it.
  std::optional<syntax::Rational> end;
  verify::Rest rest = verify::Rest::No; ///< what may follow the last step
  std::string summary;                  ///< what the trace shows, as a sentence
};

/// The answer to a property that asks for a time.
struct MeasuredTime {
  bool happens = false; ///< there is something to measure; otherwise nothing else is set
  bool bounded = true;  ///< the longest time is finite
  Moment value;         ///< strict: times come arbitrarily close to it, but none is equal

  bool operator==(const MeasuredTime&) const = default;
};

/// The verdict on one property.
struct VerdictRow {
  const codegen::Check* check = nullptr; ///< owned by the model
  Verdict verdict = Verdict::Inconclusive;
  std::optional<analysis::Location> location;
  /// Of an imported program: the place in the other language; see noteOriginals.
  std::optional<analysis::Original> original;
  std::optional<Trace> trace;
  /// Number of steps of its witness, also if the trace was not wanted.
  std::optional<std::size_t> steps;
  std::string reason; ///< why the verdict is inconclusive; otherwise the time that was asked for,
                      ///< or what the verdict depends on besides the model
  std::optional<MeasuredTime> time; ///< if the property asks for one

  /// Whether the verdict is the expected one. An inconclusive verdict is neither good nor bad.
  [[nodiscard]] bool good() const;
  [[nodiscard]] bool bad() const { return verdict != Verdict::Inconclusive && !good(); }
};

struct VerificationReport {
  std::vector<VerdictRow> rows;
  verify::Exploration exploration;
};

/// Sets where the place of each property of an imported program comes from.
void noteOriginals(const analysis::Program& program, VerificationReport& report);

/// Whether a check is selected; an empty list selects all. A name selects the check with this name
/// and all checks whose name continues it after a dot: `takeoff`, `takeoff.can_succeed`,
/// `takeoff.can_succeed.at_altitude`.
[[nodiscard]] bool selects(const std::vector<std::string>& names, const codegen::Check& check);

/// Selected checks of a model, in the model's order, with their questions.
struct Asked {
  std::vector<const codegen::Check*> checks; ///< owned by the model
  std::vector<verify::Question> questions;
};
[[nodiscard]] Asked askedOf(const codegen::Model& model, const std::vector<std::string>& names);

/// The report for answers to these questions, from any backend.
[[nodiscard]] VerificationReport reportOf(const codegen::Model& model, const Asked& asked,
                                          verify::Result result);

/// Receives each row of the report and its index as soon as its property is decided.
using OnRow = std::function<void(std::size_t, const VerdictRow&)>;

/// The traces that are needed; no others are built. Thousands of traces of hundreds of steps take
/// gigabytes.
struct WantedTraces {
  bool findings = true; ///< those of verdicts that may be bad
  /// Others are built until all traces together have so many steps.
  std::size_t steps = std::numeric_limits<std::size_t>::max();
};

inline constexpr WantedTraces kAllTraces{};
inline constexpr WantedTraces kFindings{true, 0};
inline constexpr WantedTraces kNoTraces{false, 0};
/// Some 20 MB of JSON, which browsers open at once.
inline constexpr WantedTraces kTracesOfPage{true, 20'000};
/// Some 3 MB of JSON. An editor requests any other trace when the user wants to see it.
inline constexpr WantedTraces kTracesOfEditor{true, 2'000};

/// Verifies the selected checks in one exploration; verdicts are in the order of the model.
/// \param options `options.decided` is not called
[[nodiscard]] std::expected<VerificationReport, verify::Unsupported>
verifyModel(const codegen::Model& model, const std::vector<std::string>& names,
            verify::Options options, const OnRow& onRow = {}, WantedTraces wanted = kAllTraces);

} // namespace proskill::ide
