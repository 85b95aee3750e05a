#include "report/run/run_json.h"
#include "report/text/paint.h"
#include "report/text/source_place.h"
#include "runtime/executor/description.h"
#include "syntax/text/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

namespace proskill::report {

using runtime::End;
using runtime::Nanoseconds;
using runtime::RemarkKind;

namespace {

/// Seconds as a decimal: `2.5`.
std::string secondsText(Nanoseconds date) {
  return syntax::toString(ide::seconds(date, 1, {1, runtime::kSecond}));
}

/// Dates that were drawn have nine decimals; six are shown.
std::string dateText(Nanoseconds date) {
  auto text = fmt::format("{}.{:06}", date / runtime::kSecond, date % runtime::kSecond / 1000);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string column(std::string text, std::size_t width) {
  const auto have = syntax::countCharacters(text);
  if (have < width) text.append(width - have, ' ');
  return text;
}

class RunText final : public runtime::Observer {
public:
  RunText(std::ostream& to, RunSubject of, bool colour)
      : out(to), subject(of), places(of.program), paint{colour} {
    for (const auto& origin : of.executable.model.provenance.origins)
      width = std::max(width, syntax::countCharacters(origin.actor));
    width = std::min<std::size_t>(width, 30);
  }

  void onStep(const runtime::Machine& machine, verify::TransitionId step, Nanoseconds date,
              Nanoseconds lag) override {
    static_cast<void>(lag);
    auto made = runStep(subject, machine, step, date, before);
    if (const auto message = runtime::printedMessage(subject.executable, machine))
      made.description = "prints \"" + *message + "\"";
    write(made, date, Colour::Cyan);
    std::string changes;
    for (const auto& [variable, was, is] : made.changes)
      changes += fmt::format("{}{}: {} → {}", changes.empty() ? "" : ", ", variable, was, is);
    if (!changes.empty()) writeBelow(changes, Colour::Dim);
  }

  void onRemark(const runtime::Remark& remark) override {
    if (remark.kind == RemarkKind::GuardFailed) return; // already reported with its step
    if (remark.kind == RemarkKind::Started)
      return writeBelow("→ " + runtime::commandText(remark.start->call, remark.subject),
                        Colour::Blue);
    if (remark.kind == RemarkKind::Asked)
      return writeBelow("→ stop " + std::string(remark.subject), Colour::Blue);
    write(runStep(subject, remark, before), remark.date, colourOf(remark.kind));
  }

private:
  static Colour colourOf(RemarkKind kind) {
    if (kind == RemarkKind::Holds) return Colour::Green;
    return isBad(kind) ? Colour::Red : Colour::Yellow;
  }

  void write(const ide::TraceStep& step, Nanoseconds date, Colour colour) {
    constexpr std::size_t kWords = 44;
    std::string where;
    if (step.location) {
      const auto at = places.begin(*step.location);
      where = fmt::format("{}:{}:{}", syntax::printable(places.path(step.location->file)), at.line,
                          at.column);
    }
    out << fmt::format("{:>12} s  {}  {}", dateText(date), paint(colour, column(step.actor, width)),
                       column(syntax::printable(step.description), where.empty() ? 0 : kWords));
    if (!where.empty()) out << "  " << paint(Colour::Dim, where);
    out << '\n';
    before = date;
  }

  void writeBelow(const std::string& text, Colour colour) {
    out << std::string(16 + width + 2, ' ') << paint(colour, text) << '\n';
  }

  std::ostream& out;
  RunSubject subject;
  SourcePlaces places;
  Paint paint;
  std::size_t width = 0;
  Nanoseconds before = 0;
};

/// What the run has decided about the program's own properties.
void writeVerdicts(std::ostream& out, RunSubject subject, const runtime::RunResult& result,
                   Paint paint) {
  using runtime::Verdict;
  for (const auto& [property, verdict, date] : result.verdicts) {
    const auto& of = subject.executable.properties[property];
    const auto& check = subject.executable.model.checks[of.check];
    const auto why = whyNotMonitored(of);
    auto words = std::string(toString(verdict));
    if (verdict != Verdict::NotYet) words += fmt::format(" since {} s", secondsText(date));
    if (!why.empty()) words += " (not monitored: " + why + ")";
    const auto colour = verdict == Verdict::True    ? Colour::Green
                        : verdict == Verdict::False ? Colour::Red
                                                    : Colour::Dim;
    const auto* mark = verdict == Verdict::True ? "✓" : verdict == Verdict::False ? "✗" : "…";
    out << fmt::format("  {} {}: {}\n", paint(colour, mark), syntax::printable(check.name), words);
  }
}

} // namespace

std::unique_ptr<runtime::Observer> runText(std::ostream& out, RunSubject subject, bool colour) {
  return std::make_unique<RunText>(out, subject, colour);
}

std::string_view toWords(End end) {
  switch (end) {
  case End::Mission: return "the mission has ended";
  case End::Until: return "the time limit was reached";
  case End::Stopped: return "stopped: every action has ended";
  case End::Abandoned: return "stopped, but not every action has ended";
  case End::Stuck: return "no step is possible any more";
  case End::NoTime: return "the program takes endless steps without time passing";
  case End::Failed: return "a step failed, which is an error of the model";
  case End::Lost: return "the platform has ended before the mission did";
  }
  return "";
}

void writeRunSummary(std::ostream& out, RunSubject subject, const runtime::RunResult& result,
                     bool colour) {
  const Paint paint{colour};
  out << fmt::format("{} after {} s and {} steps", toWords(result.end), secondsText(result.date),
                     result.steps);
  const auto& status = result.missionStatus;
  if (!status.empty())
    out << fmt::format("; {}: {}", subject.executable.model.mainSkill,
                       paint(status == "success" ? Colour::Green : Colour::Yellow, status));
  if (!result.failure.empty()) out << ": " << result.failure;
  out << '\n';
  writeVerdicts(out, subject, result, paint);
  if (result.bad > 0)
    out << paint(Colour::Red, fmt::format("{} thing{} should not have happened", result.bad,
                                          result.bad == 1 ? "" : "s"))
        << '\n';
}

} // namespace proskill::report
