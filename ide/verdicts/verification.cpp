#include "ide/verdicts/verification.h"

#include "ide/verdicts/idle_steps.h"
#include "ide/verdicts/times.h"
#include "ide/verdicts/waits.h"
#include "ide/verdicts/why.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace proskill::ide {

namespace {

using syntax::Rational;

Moment moment(const verify::Date& date, Rational unit) {
  return {seconds(date.value, 1, unit), date.strict};
}

/// Removes the model's loop for a mission that has ended, which is not a step of the program.
void dropIdleLoop(Trace& trace) {
  if (!trace.loop) return;
  const auto first = trace.steps.begin() + static_cast<std::ptrdiff_t>(*trace.loop);
  const bool isIdle = std::all_of(first, trace.steps.end(), [](const TraceStep& step) {
    return step.description.empty() && step.changes.empty();
  });
  if (!isIdle) {
    trace.rest = verify::Rest::No;
    return;
  }
  trace.steps.erase(first, trace.steps.end());
  trace.loop.reset();
}

Trace translate(verify::Trace raw, const codegen::Model& model) {
  Trace trace{std::move(raw.initial), {}};
  trace.steps.reserve(raw.steps.size());
  auto reasons = whyOf(raw, model);
  const auto last = raw.steps.empty() ? 0 : raw.steps.back().date;
  Rational before;
  for (auto& rawStep : raw.steps) {
    const auto earliest = moment(rawStep.earliest, model.unit);
    const auto latest = rawStep.latest;
    const auto date = seconds(rawStep.date, raw.scale, model.unit);
    auto step = inWords(std::move(rawStep), model.provenance);
    step.why = std::move(reasons[trace.steps.size()]);
    step.earliest = earliest;
    if (latest) step.latest = moment(*latest, model.unit);
    step.date = date;
    step.delay = difference(step.date, before);
    before = step.date;
    trace.steps.push_back(std::move(step));
  }
  trace.loop = raw.loop;
  trace.rest = raw.rest;
  dropIdleLoop(trace);
  if (!raw.loop && raw.end > last) trace.end = seconds(raw.end, raw.scale, model.unit);
  return trace;
}

/// A check for reachability asks `absent`, so "violated" is the good answer.
Verdict verdictOf(const codegen::Check& check, verify::Truth truth) {
  if (truth == verify::Truth::Unknown) return Verdict::Inconclusive;
  bool holds = truth == verify::Truth::True;
  if (check.good == codegen::Expectation::Holds) return holds ? Verdict::Holds : Verdict::Violated;
  return holds ? Verdict::Unreachable : Verdict::Reachable;
}

/// Whether the verdict on a property of the program depends on which infinite runs count.
bool isOfAllRuns(const codegen::Model& model, const codegen::Check& check) {
  return check.kind == "property" && !check.fair && !model.provenance.byHand &&
         fiacre::isAboutEndlessRuns(model.fiacre.properties[check.property].pattern);
}

VerdictRow row(const codegen::Check& check, verify::Answer answer, const codegen::Model& model) {
  VerdictRow result;
  result.check = &check;
  result.verdict = verdictOf(check, answer.truth);
  result.location = locate(model.provenance.origins[check.origin]);
  if (answer.trace) {
    auto raw = withoutIdleSteps(std::move(*answer.trace), model.provenance);
    const auto support = raw.support;
    const auto waits = waitsText(raw.waits, model);
    result.trace = translate(std::move(raw), model);
    result.trace->summary = summaryOf(check, model, *result.trace, support);
    if (!waits.empty())
      result.trace->summary.replace(result.trace->summary.size() - 1, 1, ": " + waits + ".");
  }
  result.steps = result.trace ? result.trace->steps.size() : answer.steps;
  result.reason = answer.reason;
  if (answer.duration) {
    const auto kind = model.fiacre.properties[check.property].pattern.kind;
    result.time = measuredTime(*answer.duration, model.unit);
    result.reason = timeText(check, kind, *result.time);
    if (result.trace && result.time->bounded)
      result.trace->summary = timeSummary(check, kind, *result.time);
  }
  if (result.reason.empty() && isOfAllRuns(model, check))
    result.reason = "of all runs, fair or not";
  if (result.reason.empty() && result.good()) result.reason = check.note;
  return result;
}

// --- Time that does not pass

bool isProgress(const codegen::Check& check) { return check.kind == "time_progress"; }

/// Whether the answer depends on how much time passes.
bool isBounded(const codegen::Model& model, const codegen::Check& check) {
  if (check.kind == "no_undershoot" || check.kind == "no_overshoot" || check.fair) return true;
  const auto& pattern = model.fiacre.properties[check.property].pattern;
  const bool asksForTime =
      pattern.kind == fiacre::PatternKind::Longest || pattern.kind == fiacre::PatternKind::Shortest;
  return asksForTime || pattern.within || pattern.forInterval || pattern.lasting;
}

/// The question whether time can always go on, if bounds are checked without it.
std::optional<verify::Question> progressBeside(const codegen::Model& model, const Asked& asked) {
  const auto bounded = [&](const auto* check) { return isBounded(model, *check); };
  const auto progress = [](const auto* check) { return isProgress(*check); };
  if (std::ranges::none_of(asked.checks, bounded) || std::ranges::any_of(asked.checks, progress))
    return std::nullopt;
  const auto found = std::ranges::find_if(model.checks, isProgress);
  if (found == model.checks.end()) return std::nullopt;
  return verify::Question{found->property};
}

constexpr std::string_view kOfRunsWithTime = "for runs in which time goes on";

/// In a fair run, an action without a time limit ends eventually.
std::string unlessForEver(const codegen::Model& model, const codegen::Check& check) {
  constexpr std::size_t kMost = 3;
  std::set<std::string> names;
  for (const auto& [process, of] : model.obliged)
    if (!check.exempt.contains(process)) names.insert(of.description);
  if (names.empty()) return "";
  if (names.size() > kMost)
    return fmt::format("unless one of {} actions and waits without a time limit never ends",
                       names.size());
  return fmt::format("unless {} never ends", fmt::join(names, " or "));
}

std::string ofRunsWithTime(verify::Truth progress) {
  return fmt::format("{}: `program.time_progress` is {}", kOfRunsWithTime,
                     progress == verify::Truth::False ? "violated" : "not decided");
}

/// Runs in which time stops violate no bound; says that they do not count.
/// \param progress whether time can always go on
void sayTimePasses(const codegen::Model& model, verify::Truth progress, VerdictRow& row) {
  if (row.verdict != Verdict::Holds || !isBounded(model, *row.check)) return;
  if (const auto said = row.reason.find(kOfRunsWithTime); said != std::string::npos)
    row.reason.erase(said < 2 ? 0 : said - 2);
  if (progress == verify::Truth::True) {
    if (row.check->fair) row.reason = unlessForEver(model, *row.check);
    return;
  }
  const auto note = ofRunsWithTime(progress);
  row.reason = row.time ? fmt::format("{}, {}", row.reason, note) : note;
}

/// Index of the question whether time can go on; nullopt if it is not asked.
std::optional<std::size_t> placeOfProgress(const Asked& asked, std::size_t questions) {
  const auto found =
      std::ranges::find_if(asked.checks, [](const auto* it) { return isProgress(*it); });
  if (found != asked.checks.end()) return found - asked.checks.begin();
  if (questions > asked.checks.size()) return asked.checks.size();
  return std::nullopt;
}

/// Progress in all questions that are asked, while the engine searches for the answers to some.
/// \param answered number of questions that earlier searches decided
verify::Progress inAll(verify::Progress now, std::size_t answered, std::size_t asked) {
  now.decided = std::min<std::uint64_t>(asked, answered + now.decided);
  now.questions = asked;
  return now;
}

} // namespace

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
      asked.questions.push_back({check.property, check.fair, check.exempt, check.rests});
    }
  return asked;
}

VerificationReport reportOf(const codegen::Model& model, const Asked& asked,
                            verify::Result result) {
  VerificationReport report{{}, result.exploration};
  for (std::size_t i = 0; i < asked.checks.size(); ++i)
    report.rows.push_back(row(*asked.checks[i], std::move(result.answers[i]), model));
  return report;
}

std::expected<VerificationReport, verify::Unsupported>
verifyModel(const codegen::Model& model, const std::vector<std::string>& names,
            verify::Options options, const OnRow& onRow, WantedTraces wanted) {
  const auto asked = askedOf(model, names);
  auto questions = asked.questions;
  if (const auto beside = progressBeside(model, asked)) questions.push_back(*beside);
  const auto progressAt = placeOfProgress(asked, questions.size());
  auto progress = verify::Truth::Unknown;
  std::vector<std::optional<VerdictRow>> rows(questions.size());
  std::size_t steps = 0; // of all traces
  std::size_t answered = 0;
  if (const auto tell = options.progress)
    options.progress = [&, tell](const verify::Progress& now) {
      tell(inAll(now, answered, asked.checks.size()));
    };
  options.decided = [&](std::size_t i, verify::Answer answer) {
    if (progressAt == i) progress = answer.truth;
    if (i >= asked.checks.size()) return;
    if (!rows[i]) ++answered;
    rows[i] = row(*asked.checks[i], std::move(answer), model);
    if (rows[i]->trace) steps += rows[i]->trace->steps.size();
    if (progressAt) sayTimePasses(model, progress, *rows[i]);
    if (onRow) onRow(i, *rows[i]);
  };
  for (const auto& [process, _] : model.obliged) options.obliged.insert(process);
  options.wantsTrace = [&](std::size_t i) {
    if (i >= asked.checks.size()) return false;
    const bool mayBeBad = asked.checks[i]->good == codegen::Expectation::Holds;
    return steps < wanted.steps || (wanted.findings && mayBeBad);
  };
  auto result = verify::verify(model.fiacre, model.provenance, questions, options);
  if (!result) return std::unexpected(result.error());
  if (progressAt) progress = result->answers[*progressAt].truth;
  auto report = reportOf(model, asked, std::move(*result));
  for (std::size_t i = 0; i < asked.checks.size(); ++i)
    if (rows[i]) report.rows[i] = std::move(*rows[i]);
  for (auto& each : report.rows)
    if (progressAt) sayTimePasses(model, progress, each);
  return report;
}

void noteOriginals(const analysis::Program& program, VerificationReport& report) {
  analysis::ProgramOriginals originals(program);
  for (auto& row : report.rows)
    if (row.location) row.original = originals.of(*row.location);
}

} // namespace proskill::ide
