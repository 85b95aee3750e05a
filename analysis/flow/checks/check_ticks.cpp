#include "analysis/flow/checks/checks.h"
#include "analysis/names/walk.h"
#include "syntax/diagnostics/codes.h"
#include "syntax/tree/statements.h"

#include <cstdint>
#include <fmt/format.h>
#include <optional>

/// Finds bounds of time that the executor's default rate cannot represent.
namespace proskill::analysis::flow {

namespace {

using syntax::Rational;

constexpr std::int64_t kUsualRate = 100; ///< in ticks per second

/// The least multiple of ten for which the bound is an integer number of ticks.
std::optional<std::int64_t> rateFor(Rational bound) {
  for (std::int64_t rate = kUsualRate; rate <= 1'000'000; rate *= 10)
    if (rate % bound.denominator == 0) return rate;
  return std::nullopt;
}

/// The nearest tick; nullopt if that is 0.
std::optional<Rational> rounded(Rational bound) {
  const syntax::Wide ticks = (syntax::Wide{bound.numerator} * kUsualRate * 2 + bound.denominator) /
                             (syntax::Wide{bound.denominator} * 2);
  if (ticks > INT32_MAX || (ticks == 0 && bound.numerator > 0)) return std::nullopt;
  return syntax::parseRational(fmt::format("{}.{:02}",
                                           static_cast<std::int64_t>(ticks) / kUsualRate,
                                           static_cast<std::int64_t>(ticks) % kUsualRate));
}

/// The interval rounded to ticks, in the notation of the user: `0.33`, `[0.33,1]`.
std::optional<std::string> inTicks(const syntax::Interval& interval, bool plain) {
  const auto lower = rounded(interval.lower);
  const auto upper = interval.upper ? rounded(*interval.upper) : std::nullopt;
  if (!lower || (interval.upper && !upper)) return std::nullopt;
  if (plain) return toString(*lower);
  if (upper == lower && (interval.lowerOpen || interval.upperOpen)) return std::nullopt;
  return fmt::format("{}{},{}{}", interval.lowerOpen ? "]" : "[", toString(*lower),
                     upper ? toString(*upper) : "...", interval.upperOpen ? "[" : "]");
}

template <class Skill>
void checkInterval(Report& report, const Skill& owner, const syntax::Interval& interval) {
  for (Rational bound : {interval.lower, interval.upper.value_or(interval.lower)}) {
    if (kUsualRate % bound.denominator == 0) continue;
    auto rate = rateFor(bound);
    const Location at = owner.at(interval.range);
    const std::string& text = report.program.files[at.file].document.text();
    Finding finding =
        report.findings.report(syntax::Code::NotInTicks, at, toString(bound), kUsualRate,
                               rate ? fmt::format("{} a second", *rate) : std::string("none"));
    const bool plain = text[at.range.begin] != '[' && text[at.range.begin] != ']';
    if (const auto right = inTicks(interval, plain))
      finding.fix(fmt::format("write {}, in whole ticks", *right), at, *right);
    return;
  }
}

template <class Owner>
void checkBody(Report& report, const Owner& owner, const syntax::Block& body) {
  forEachStatement(body, [&](const syntax::Statement& statement) {
    if (syntax::hasDuration(statement)) checkInterval(report, owner, statement.duration);
  });
}

} // namespace

void checkTicks(Report& report) {
  for (const auto& skill : report.program.skills.all) {
    if (skill->timeInterval) checkInterval(report, skill, *skill->timeInterval);
    if (skill->body) checkBody(report, skill, *skill->body);
  }
  for (const auto& event : report.program.events.all)
    if (event->every) checkInterval(report, event, *event->every);
}

} // namespace proskill::analysis::flow
