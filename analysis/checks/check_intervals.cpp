#include "analysis/checks/checks.h"

#include "analysis/names/walk.h"
#include "syntax/diagnostics/codes.h"
#include "syntax/tree/statements.h"

namespace proskill::analysis {

using syntax::Code;
using syntax::Interval;

namespace {

std::string asWritten(const syntax::Name& constant, const syntax::Rational& bound) {
  return constant ? std::string(constant.text) : toString(bound);
}

void checkInterval(Context& context, FileId file, const Interval& interval) {
  if (!interval.upper || interval.range.empty()) return;
  const Location at{file, interval.range};
  if (*interval.upper < interval.lower) {
    const auto bracket = [](bool open, char outward, char inward) {
      return std::string(1, open ? outward : inward);
    };
    const std::string swapped =
        bracket(interval.upperOpen, ']', '[') + asWritten(interval.upperName, *interval.upper) +
        "," + asWritten(interval.lowerName, interval.lower) + bracket(interval.lowerOpen, '[', ']');
    context.findings
        .report(Code::ReversedInterval, at, toString(*interval.upper), toString(interval.lower))
        .fix("swap the bounds: `" + swapped + "`", at, swapped);
  } else if (*interval.upper == interval.lower && (interval.lowerOpen || interval.upperOpen)) {
    const std::string bound = toString(interval.lower);
    const std::string closed = "[" + asWritten(interval.lowerName, interval.lower) + "," +
                               asWritten(interval.upperName, *interval.upper) + "]";
    context.findings.report(Code::EmptyInterval, at, bound)
        .fix("include the bounds: `" + closed + "`", at, closed);
  }
}

/// An event that must occur again and again at once would stop time.
void checkEvery(Context& context, const Definition<syntax::Event>& event) {
  const Interval& every = *event->every;
  checkInterval(context, event.file, every);
  if (every.upper && *every.upper == syntax::Rational{} && !every.range.empty())
    context.findings.report(Code::EveryNoTime, event.at(every.range), event.name());
}

} // namespace

void checkIntervals(Context& context) {
  context.each(context.program.events, [&](const auto& event) {
    if (event->every) checkEvery(context, event);
  });
  context.each(context.program.skills, [&](const auto& skill) {
    if (skill->timeInterval) checkInterval(context, skill.file, *skill->timeInterval);
  });
  context.eachBody([&](const Body& body) {
    forEachStatement(body.block, [&](const syntax::Statement& statement) {
      if (syntax::hasDuration(statement)) checkInterval(context, body.file, statement.duration);
    });
  });
  context.each(context.program.properties, [&](const auto& property) {
    if (property->within) checkInterval(context, property.file, *property->within);
    if (property->forDuration) checkInterval(context, property.file, *property->forDuration);
  });
}

} // namespace proskill::analysis
