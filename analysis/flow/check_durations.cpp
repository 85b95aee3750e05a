#include "analysis/flow/checks.h"

#include "analysis/flow/durations.h"
#include "syntax/codes.h"

/// Bodies that take less or more time than their skill's `:time_interval` says.
namespace proskill::analysis::flow {

namespace {

using syntax::Code;
using syntax::Interval;
using syntax::Rational;

/// A body of at most `most` always ends before the interval begins.
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

std::optional<Code> verdict(const Interval& interval, const Duration& duration) {
  if (alwaysShort(interval, duration.most)) return Code::AlwaysTooShort;
  if (alwaysLong(interval, duration.least)) return Code::AlwaysTooLong;
  if (mayMiss(interval, duration)) return Code::MayMissInterval;
  return std::nullopt;
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
    if (auto code = verdict(interval, *duration))
      report.findings.report(*code, skill.at(interval.range), skill.name(), words(*duration));
  }
}

} // namespace proskill::analysis::flow
