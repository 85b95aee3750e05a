#include "analysis/flow/checks/checks.h"

#include "analysis/flow/result/durations.h"
#include "syntax/diagnostics/codes.h"

#include <fmt/format.h>

/// Finds bodies that take less or more time than their skill's `:time_interval`.
namespace proskill::analysis::flow {

namespace {

using syntax::Code;
using syntax::Interval;
using syntax::Rational;
using Told = syntax::CodeFor<2>;

constexpr std::size_t kMostParts = 5;

/// Whether a body that takes at most `most` always ends before the interval begins.
bool alwaysShort(const Interval& interval, const std::optional<Rational>& most) {
  return most && (*most < interval.lower || (*most == interval.lower && interval.lowerOpen));
}

bool alwaysLong(const Interval& interval, Rational least) {
  if (!interval.upper) return false;
  return least > *interval.upper || (least == *interval.upper && interval.upperOpen);
}

bool mayMiss(const Interval& interval, const Duration& duration) {
  return duration.least < interval.lower ||
         (interval.upper && duration.most && *duration.most > *interval.upper);
}

std::optional<Told> verdict(const Interval& interval, const Duration& duration) {
  if (alwaysShort(interval, duration.most)) return Told(Code::AlwaysTooShort);
  if (alwaysLong(interval, duration.least)) return Told(Code::AlwaysTooLong);
  if (mayMiss(interval, duration)) return Told(Code::MayMissInterval);
  return std::nullopt;
}

std::string asInterval(const Duration& duration) {
  if (!duration.most) return fmt::format("[{},...[", toString(duration.least));
  return fmt::format("[{},{}]", toString(duration.least), toString(*duration.most));
}

/// Adds the first few steps of the body that take time, with their durations.
void addParts(Finding& finding, const Report& report, Durations& durations, ProcessId id) {
  std::size_t left = kMostParts;
  for (NodeId node = 0; left > 0 && node < report.system()[id].actions.size(); ++node) {
    const Node& each = (*report.system()[id].graph)[node];
    if (!each.waits() || !each.statement || !report.solver.reachable(id, node)) continue;
    Duration part = durations.ofNode(id, node);
    if (part.most && *part.most == Rational{0, 1}) continue;
    finding.related(report.at(id, node), fmt::format("takes {}", words(part)));
    --left;
  }
}

} // namespace

void checkDurations(Report& report) {
  Durations durations(report.solver);
  for (std::size_t i = 0; i < report.program.skills.all.size(); ++i) {
    const auto& skill = report.program.skills.all[i];
    ProcessId id = report.system().ofSkill(i);
    if (!skill->isComposite() || !skill->timeInterval || !report.solver.started(id)) continue;
    auto duration = durations.of(id);
    if (!duration) continue;
    const Interval& interval = *skill->timeInterval;
    auto code = verdict(interval, *duration);
    if (!code) continue;
    // A skill that can be stopped may end before its body does. Then only some runs take too long,
    // and a later start of the interval would make the others too short.
    const bool isStopped = code->code == Code::AlwaysTooLong && durations.mayEndEarly(id);
    if (isStopped) code = Told(Code::MayMissInterval);
    Finding finding =
        report.findings.report(*code, skill.at(interval.range), skill.name(), words(*duration));
    addParts(finding, report, durations, id);
    std::string right =
        asInterval(isStopped ? Duration{interval.lower, duration->most} : *duration);
    finding.fix(fmt::format("write {}", right), skill.at(interval.range), right);
  }
}

} // namespace proskill::analysis::flow
