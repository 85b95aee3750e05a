#include "ide/verdicts/times.h"

#include <fmt/format.h>

namespace proskill::ide {

namespace {

bool isLongest(fiacre::PatternKind kind) { return kind == fiacre::PatternKind::Longest; }

std::string quoted(const codegen::Check& check, std::size_t operand) {
  return "`" + check.operands.at(operand) + "`";
}

} // namespace

MeasuredTime measuredTime(const verify::Duration& duration, syntax::Rational unit) {
  return {duration.happens,
          duration.bounded,
          {seconds(duration.value.value, 1, unit), duration.value.strict}};
}

std::string timeText(const codegen::Check& check, fiacre::PatternKind kind,
                     const MeasuredTime& time) {
  const auto value = syntax::toString(time.value.seconds);
  if (isLongest(kind)) {
    if (!time.happens) return quoted(check, 0) + " never becomes true";
    if (!time.bounded) return "no upper bound";
    return fmt::format("{} {} s", time.value.strict ? "less than" : "at most", value);
  }
  if (!time.happens) return fmt::format("{} never follows {}", quoted(check, 1), quoted(check, 0));
  return fmt::format("{} {} s", time.value.strict ? "more than" : "at least", value);
}

std::string timeSummary(const codegen::Check& check, fiacre::PatternKind kind,
                        const MeasuredTime& time) {
  return fmt::format("A run with {} {} time from {} to {}: {}.",
                     time.value.strict ? "nearly the" : "the",
                     isLongest(kind) ? "longest" : "shortest", quoted(check, 0), quoted(check, 1),
                     timeText(check, kind, time));
}

} // namespace proskill::ide
