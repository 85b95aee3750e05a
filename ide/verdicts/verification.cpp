#include "ide/verdicts/verification.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>

namespace proskill::ide {

namespace {

using syntax::Rational;

std::optional<analysis::Location> locate(const fiacre::Origin& origin) {
  if (origin.begin == origin.end) return std::nullopt;
  return analysis::Location{origin.file, {origin.begin, origin.end}};
}

Moment moment(const verify::Date& date, Rational unit) {
  return {seconds(date.value, 1, unit), date.strict};
}

Trace translate(const verify::Trace& raw, const codegen::Model& model) {
  Trace trace{raw.initial, {}};
  Rational before;
  for (const auto& rawStep : raw.steps) {
    auto step = inWords(rawStep, model.provenance);
    step.earliest = moment(rawStep.earliest, model.unit);
    if (rawStep.latest) step.latest = moment(*rawStep.latest, model.unit);
    step.date = seconds(rawStep.date, raw.scale, model.unit);
    step.delay = difference(step.date, before);
    before = step.date;
    trace.steps.push_back(std::move(step));
  }
  trace.loop = raw.loop;
  const auto last = raw.steps.empty() ? 0 : raw.steps.back().date;
  if (raw.end > last) trace.end = seconds(raw.end, raw.scale, model.unit);
  return trace;
}

/// A check that hopes for reachability asks `absent`, and is glad of a "no".
Verdict verdictOf(const codegen::Check& check, verify::Truth truth) {
  if (truth == verify::Truth::Unknown) return Verdict::Inconclusive;
  bool holds = truth == verify::Truth::True;
  if (check.good == codegen::Expectation::Holds) return holds ? Verdict::Holds : Verdict::Violated;
  return holds ? Verdict::Unreachable : Verdict::Reachable;
}

VerdictRow row(const codegen::Check& check, const verify::Answer& answer,
               const codegen::Model& model) {
  VerdictRow result;
  result.check = &check;
  result.verdict = verdictOf(check, answer.truth);
  result.location = locate(model.provenance.origins[check.origin]);
  if (answer.trace) result.trace = translate(*answer.trace, model);
  result.reason = answer.reason;
  return result;
}

} // namespace

syntax::Rational seconds(std::int64_t units, std::int64_t scale, Rational unit) {
  auto scaled = syntax::multiply(Rational{units, 1}, unit);
  auto result = scaled ? syntax::multiply(*scaled, Rational{1, scale}) : std::nullopt;
  return result.value_or(Rational{INT64_MAX, 1});
}

syntax::Rational difference(Rational later, Rational earlier) {
  return syntax::add(later, Rational{-earlier.numerator, earlier.denominator}).value_or(Rational{});
}

/// The last origin that says something names the step; the last one with a place locates it.
TraceStep inWords(const verify::Step& raw, const fiacre::Provenance& provenance) {
  TraceStep step;
  for (auto id : raw.origins) {
    const auto& origin = provenance.origins[id];
    if (!origin.actor.empty()) step.actor = origin.actor;
    if (!origin.words.empty()) step.words = origin.words;
    if (auto location = locate(origin)) step.location = location;
  }
  if (provenance.byHand) step.actor = fmt::format("{}", fmt::join(raw.instances, ", "));
  if (!raw.failure.empty()) step.words += (step.words.empty() ? "" : ": ") + raw.failure;
  step.changes = raw.changes;
  step.transitions = raw.transitions;
  step.origins = raw.origins;
  return step;
}

std::string_view toString(Verdict verdict) {
  switch (verdict) {
  case Verdict::Holds: return "holds";
  case Verdict::Violated: return "violated";
  case Verdict::Reachable: return "reachable";
  case Verdict::Unreachable: return "unreachable";
  case Verdict::Inconclusive: return "inconclusive";
  }
  assert(false);
  return "";
}

bool VerdictRow::good() const { return verdict == Verdict::Holds || verdict == Verdict::Reachable; }

bool selects(const std::vector<std::string>& names, const codegen::Check& check) {
  if (names.empty()) return true;
  return std::ranges::any_of(names, [&](const std::string& name) {
    return check.name.starts_with(name) &&
           (check.name.size() == name.size() || check.name[name.size()] == '.');
  });
}

Asked askedOf(const codegen::Model& model, const std::vector<std::string>& names) {
  Asked asked;
  for (const auto& check : model.checks)
    if (selects(names, check)) {
      asked.checks.push_back(&check);
      asked.questions.push_back({check.property});
    }
  return asked;
}

VerificationReport reportOf(const codegen::Model& model, const Asked& asked,
                            const verify::Result& result) {
  VerificationReport report{{}, result.exploration};
  for (std::size_t i = 0; i < asked.checks.size(); ++i)
    report.rows.push_back(row(*asked.checks[i], result.answers[i], model));
  return report;
}

std::expected<VerificationReport, verify::Unsupported>
verifyModel(const codegen::Model& model, const std::vector<std::string>& names,
            const verify::Options& options) {
  const auto asked = askedOf(model, names);
  auto result = verify::verify(model.fiacre, model.provenance, asked.questions, options);
  if (!result) return std::unexpected(result.error());
  return reportOf(model, asked, *result);
}

} // namespace proskill::ide
