#pragma once

#include "runtime/conform/recorded_run.h"

#include <map>
#include <string>
#include <vector>

namespace proskill::runtime {

/// How long the actions of a basic skill took in recorded runs, without those that were stopped.
struct Durations {
  Nanoseconds least = 0;
  Nanoseconds most = 0;
  std::size_t count = 0;
};

/// \return by skill; a skill whose action has never ended by itself is missing
[[nodiscard]] std::map<std::string, Durations> durationsOf(const analysis::Program& program,
                                                           const std::vector<RecordedRun>& runs);

/// The interval of a skill, widened so that it includes durations: `[1,3.5]`. A bound that changes
/// is rounded outwards to two digits. Empty if the interval includes them.
[[nodiscard]] std::string widened(const syntax::Interval& interval, const Durations& durations);

} // namespace proskill::runtime
