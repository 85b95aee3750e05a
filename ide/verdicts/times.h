#pragma once

#include "ide/verdicts/verification.h"

namespace proskill::ide {

/// The answer to a question for a time, in seconds.
[[nodiscard]] MeasuredTime measuredTime(const verify::Duration& duration, syntax::Rational unit);

/// The answer as text: "at most 25 s", "more than 3 s", "no upper bound".
[[nodiscard]] std::string timeText(const codegen::Check& check, fiacre::PatternKind kind,
                                   const MeasuredTime& time);

/// What the run that shows the time shows, as a sentence.
[[nodiscard]] std::string timeSummary(const codegen::Check& check, fiacre::PatternKind kind,
                                      const MeasuredTime& time);

} // namespace proskill::ide
