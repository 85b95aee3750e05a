#include "report/text/paint.h"
#include "report/text/source_place.h"
#include "report/verify_report.h"
#include "syntax/text/seconds.h"
#include "syntax/text/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <set>
#include <span>
#include <utility>

namespace proskill::report {

namespace {

using ide::Verdict;

struct Mark {
  std::string_view sign;
  Colour colour;
};

Mark markOf(const ide::VerdictRow& row) {
  if (row.verdict == Verdict::Inconclusive) return {"?", Colour::Yellow};
  if (row.good()) return {"✓", Colour::Green};
  if (row.check->weight == codegen::Weight::Warning) return {"!", Colour::Yellow};
  return {"✗", Colour::Red};
}

/// `12.5 s`, with `>` or `<` if the date is approached but not reached.
std::string momentText(const ide::Moment& moment, bool latest) {
  return fmt::format("{}{}", moment.strict ? (latest ? "<" : ">") : "",
                     syntax::toString(moment.seconds));
}

/// The interval of dates at which the step can happen, over all runs with the same steps.
std::string windowText(const ide::TraceStep& step) {
  auto earliest = momentText(step.earliest, false);
  if (!step.latest) return earliest + " s …";
  auto latest = momentText(*step.latest, true);
  return earliest == latest ? earliest + " s" : fmt::format("{} … {} s", earliest, latest);
}

using syntax::countCharacters;

std::string padded(std::string text, std::size_t width) {
  auto have = countCharacters(text);
  if (have < width) text.append(width - have, ' ');
  return text;
}

std::string changesText(const std::vector<verify::Change>& changes) {
  std::string text;
  for (const auto& change : changes)
    text += fmt::format("{}{}: {} → {}", text.empty() ? "" : ", ", change.variable, change.before,
                        change.after);
  return text;
}

/// The initial values of the state variables. Skills have no status then, so it is omitted.
std::string initialText(const std::vector<verify::Change>& initial) {
  std::string text;
  for (const auto& variable : initial)
    if (variable.variable.find('.') == std::string::npos)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", variable.variable, variable.after);
  return text;
}

/// The widths of the columns of a trace, and whether steps are marked as relevant.
struct Layout {
  std::size_t number = 1;
  std::size_t window = 0;
  std::size_t actor = 0;
  std::size_t words = 0;
  bool marks = false;
};

Layout layoutOf(const ide::Trace& trace) {
  Layout layout{std::to_string(trace.steps.size()).size()};
  for (const auto& step : trace.steps) {
    layout.window = std::max(layout.window, countCharacters(windowText(step)));
    layout.actor = std::max(layout.actor, countCharacters(step.actor));
    layout.words = std::max(layout.words, countCharacters(step.description));
  }
  layout.words = std::min<std::size_t>(layout.words, 60);
  layout.marks = !std::ranges::all_of(trace.steps, &ide::TraceStep::relevant);
  return layout;
}

void writeStep(std::ostream& out, const VerifyReport& report, const ide::TraceStep& step,
               std::size_t number, const Layout& layout, const Paint& paint) {
  auto where = step.location ? place(report.program, *step.location) : std::string();
  auto words = padded(step.description, layout.words);
  out << fmt::format(
      "  {} {:>{}}  {}  {}  {}  {}\n", layout.marks && step.relevant ? "•" : " ", number,
      layout.number, padded(windowText(step), layout.window),
      paint(step.relevant ? Colour::Cyan : Colour::Dim, padded(step.actor, layout.actor)),
      step.relevant ? words : paint(Colour::Dim, words), paint(Colour::Dim, where));
  const std::string below(4 + layout.number + 2 + layout.window + 2 + layout.actor + 2, ' ');
  if (!step.why.empty()) out << below << paint(Colour::Dim, "why: " + step.why) << '\n';
  if (!step.changes.empty()) out << below << paint(Colour::Dim, changesText(step.changes)) << '\n';
}

std::string rowText(const ide::VerdictRow& row, const Paint& paint) {
  auto mark = markOf(row);
  auto text = fmt::format("  {} {}: {}", paint(mark.colour, mark.sign), row.check->description,
                          paint(mark.colour, ide::toString(row.verdict)));
  return row.reason.empty() ? text : text + fmt::format(" ({})", row.reason);
}

bool isReachedStatement(const ide::VerdictRow& row) {
  return row.check->kind == "reachable" && row.good();
}

/// Writes the rows of one subject. Reachable statements are only counted, since they are expected.
void writeSubject(std::ostream& out, std::span<const ide::VerdictRow> rows, const Paint& paint) {
  out << paint(Colour::Bold, rows.front().check->subject) << '\n';
  auto reached = std::ranges::count_if(rows, isReachedStatement);
  for (const auto& row : rows)
    if (!isReachedStatement(row)) out << rowText(row, paint) << '\n';
  if (reached == 0) return;
  auto statements =
      std::ranges::count(rows, "reachable", [](const auto& row) { return row.check->kind; });
  auto which = statements == 1         ? "its statement"
               : reached == statements ? fmt::format("all {} statements", statements)
                                       : fmt::format("{} of {} statements", reached, statements);
  out << fmt::format("  {} {} can be reached\n", paint(Colour::Green, "✓"), which);
}

void writeRows(std::ostream& out, const VerifyReport& report, const Paint& paint) {
  std::span<const ide::VerdictRow> rows = report.result.rows;
  while (!rows.empty()) {
    auto other = [&](const auto& row) { return row.check->subject != rows.front().check->subject; };
    auto end = std::ranges::find_if(rows, other);
    auto count = static_cast<std::size_t>(end - rows.begin());
    writeSubject(out, rows.first(count), paint);
    rows = rows.subspan(count);
  }
}

std::string bytesText(std::uint64_t bytes) {
  if (bytes < 1024 * 1024) return fmt::format("{:.0f} KiB", static_cast<double>(bytes) / 1024);
  return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1024 * 1024));
}

/// Why the exploration stopped, with the option that raises the limit.
std::string withOption(const std::string& stopped) {
  for (const auto& [limit, option] : {std::pair{"time limit", "--time-limit"},
                                      {"memory limit", "--memory-limit"},
                                      {"limit of classes", "--class-limit"}})
    if (stopped.find(limit) != std::string::npos)
      return fmt::format("{}; `{}` raises it", stopped, option);
  return stopped;
}

void writeSummary(std::ostream& out, const VerifyReport& report, const Paint& paint) {
  const auto& rows = report.result.rows;
  auto count = [&](auto&& predicate) { return std::ranges::count_if(rows, predicate); };
  auto good = count([](const auto& row) { return row.good(); });
  auto open = count([](const auto& row) { return row.verdict == Verdict::Inconclusive; });
  auto errors = count(
      [](const auto& row) { return row.bad() && row.check->weight == codegen::Weight::Error; });
  auto warnings = static_cast<std::ptrdiff_t>(rows.size()) - good - open - errors;
  out << fmt::format("{} propert{}: {}", rows.size(), rows.size() == 1 ? "y" : "ies",
                     paint(Colour::Green, fmt::format("{} good", good)));
  if (errors > 0) out << ", " << paint(Colour::Red, fmt::format("{} bad", errors));
  if (warnings > 0)
    out << ", "
        << paint(Colour::Yellow, fmt::format("{} warning{}", warnings, warnings == 1 ? "" : "s"));
  if (open > 0) out << ", " << paint(Colour::Yellow, fmt::format("{} inconclusive", open));
  const auto& explored = report.result.exploration;
  out << fmt::format("\n{} classes, {} markings, {} transitions, {} in {:.3f} s{}\n",
                     explored.classes, explored.markings, explored.transitions,
                     bytesText(explored.bytes), explored.seconds,
                     explored.complete ? "" : "; stopped: " + withOption(explored.stopped));
  if (explored.ranks > 0)
    out << fmt::format("{} rank{} sent {} messages with {}\n", explored.ranks,
                       explored.ranks == 1 ? "" : "s", explored.messages,
                       bytesText(explored.sentBytes));
  if (explored.spilledBytes > 0)
    out << fmt::format("The states took {} on disk at most\n", bytesText(explored.spilledBytes));
  if (explored.known > 0)
    out << fmt::format("{} of {} verdicts were known from before\n",
                       std::min<std::uint64_t>(explored.known, rows.size()), rows.size());
}

} // namespace

std::string place(const analysis::Program& program, analysis::Location location) {
  SourcePlaces places(program);
  auto [line, column] = places.begin(location);
  return fmt::format("{}:{}:{}", syntax::printable(places.path(location.file)), line, column);
}

void writeTrace(std::ostream& out, const VerifyReport& report, const ide::VerdictRow& row,
                bool colour) {
  Paint paint{colour};
  auto layout = layoutOf(*row.trace);
  if (!row.trace->summary.empty()) out << "  " << row.trace->summary << '\n';
  if (layout.marks) out << "  " << paint(Colour::Dim, "• relevant steps") << '\n';
  std::size_t number = 0;
  for (const auto& step : row.trace->steps) writeStep(out, report, step, ++number, layout, paint);
  if (row.trace->loop)
    out << fmt::format("    and from step {} on, repeated for ever\n", *row.trace->loop + 1);
  else if (row.trace->rest == verify::Rest::Forced)
    out << "    and nothing happens any more\n";
  else if (row.trace->end && row.trace->rest == verify::Rest::Allowed)
    out << "    and nothing has to happen any more\n";
  else if (row.trace->end)
    out << fmt::format("    and nothing else until {}\n", syntax::secondsText(*row.trace->end));
}

/// Where time can stop, durations are those of the other runs.
std::string_view measuredRuns(const VerifyReport& report) {
  const bool mayStop = std::ranges::any_of(report.result.rows, [](const ide::VerdictRow& row) {
    return row.check->kind == "time_progress" && row.verdict == ide::Verdict::Violated;
  });
  return mayStop ? "over runs in which time goes on: `program.time_progress` is violated"
                 : "over all runs";
}

/// Only with `--durations`.
void writeDurations(std::ostream& out, const VerifyReport& report, const Paint& paint) {
  if (report.durations.empty()) return;
  std::size_t width = 0;
  for (const auto& each : report.durations) width = std::max(width, countCharacters(each.skill));
  out << '\n' << paint(Colour::Bold, fmt::format("durations, {}", measuredRuns(report))) << '\n';
  for (const auto& each : report.durations) {
    const auto text = ide::durationText(each);
    out << fmt::format("  {}  {}\n", padded(each.skill, width),
                       text.empty() ? paint(Colour::Yellow, "inconclusive") : text);
  }
}

/// \param said the sentences so far, none of which is repeated
void writeSizeRow(std::ostream& out, const VerifyReport& report, const ide::SizeRow& row,
                  const Paint& paint, std::set<std::string>& said) {
  const auto clocks = row.clocks == 0   ? std::string()
                      : row.clocks == 1 ? std::string(", 1 clock")
                                        : fmt::format(", {} clocks", row.clocks);
  out << fmt::format("  {:>8} × {}: {} values{}", fmt::format("{:.1f}", row.factor),
                     paint(Colour::Cyan, row.name), row.values, clocks);
  if (row.location) out << "  " << paint(Colour::Dim, place(report.program, *row.location));
  out << '\n';
  for (const auto& sentence : row.advice)
    if (said.insert(sentence).second)
      out << std::string(13, ' ') << paint(Colour::Dim, sentence) << '\n';
}

/// Only with `--explain-size`.
void writeSize(std::ostream& out, const VerifyReport& report, const Paint& paint) {
  if (!report.size) return;
  constexpr std::size_t kMostRows = 20;
  std::set<std::string> said;
  constexpr double kLittle = 1.095; ///< is printed as 1.1
  out << '\n' << paint(Colour::Bold, "where the states come from") << '\n';
  for (const auto& sentence : sizeSummary(*report.size)) out << "  " << sentence << '\n';
  for (const auto& row : report.size->kinds)
    if (row.factor > kLittle) writeSizeRow(out, report, row, paint, said);
  std::size_t shown = 0;
  for (const auto& row : report.size->rows) {
    if (row.factor < kLittle || shown == kMostRows) break;
    if (shown++ == 0) out << "  one by one:\n";
    writeSizeRow(out, report, row, paint, said);
  }
  if (const auto rest = report.size->rows.size() - shown; rest > 0)
    out << fmt::format("  and {} more with smaller factors\n", rest);
}

void writeText(std::ostream& out, const VerifyReport& report, bool colour) {
  Paint paint{colour};
  writeRows(out, report, paint);
  bool first = true;
  for (const auto& row : report.result.rows) {
    if (!shownTrace(row, report.traces)) continue;
    if (std::exchange(first, false))
      out << "\nevery trace begins with: " << initialText(row.trace->initial) << '\n';
    auto mark = markOf(row);
    out << fmt::format("\n{} {}\n", paint(mark.colour, ide::toString(row.verdict)),
                       paint(Colour::Bold, row.check->description));
    if (row.location) out << "  --> " << place(report.program, *row.location) << '\n';
    if (row.original) out << "  from " << syntax::printable(toString(*row.original)) << '\n';
    writeTrace(out, report, row, colour);
  }
  writeDurations(out, report, paint);
  writeSize(out, report, paint);
  out << '\n';
  writeSummary(out, report, paint);
}

} // namespace proskill::report
