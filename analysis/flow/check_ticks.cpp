#include "analysis/flow/checks.h"
#include "analysis/walk.h"
#include "syntax/codes.h"

#include <fmt/format.h>
#include <optional>

/// Bounds of time that the executor's usual rate cannot express.
namespace proskill::analysis::flow {

namespace {

using syntax::Rational;

constexpr std::int64_t kUsualRate = 100; ///< ticks a second

/// The least multiple of ten at which the bound is a whole number of ticks.
std::optional<std::int64_t> rateFor(Rational bound) {
  for (std::int64_t rate = kUsualRate; rate <= 1'000'000; rate *= 10)
    if (rate % bound.denominator == 0) return rate;
  return std::nullopt;
}

template <class Skill>
void checkInterval(Report& report, const Skill& owner, const syntax::Interval& interval) {
  for (Rational bound : {interval.lower, interval.upper.value_or(interval.lower)}) {
    if (kUsualRate % bound.denominator == 0) continue;
    auto rate = rateFor(bound);
    report.findings.report(syntax::Code::NotInTicks, owner.at(interval.range), toString(bound),
                           kUsualRate,
                           rate ? fmt::format("{} a second", *rate) : std::string("none"));
    return;
  }
}

template <class Owner>
void checkBody(Report& report, const Owner& owner, const syntax::Block& body) {
  forEachStatement(body, [&](const syntax::Statement& statement) {
    if (statement.kind == syntax::StatementKind::WaitTime)
      checkInterval(report, owner, statement.duration);
  });
}

} // namespace

void checkTicks(Report& report) {
  for (const auto& skill : report.program.skills.all) {
    if (skill->timeInterval) checkInterval(report, skill, *skill->timeInterval);
    if (skill->body) checkBody(report, skill, *skill->body);
  }
}

} // namespace proskill::analysis::flow
