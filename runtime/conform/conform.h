#pragma once

#include "runtime/conform/recorded_run.h"

#include <optional>

namespace proskill::runtime {

enum class Conformance : std::uint8_t {
  Conforms,
  Deviates, ///< no run of the model has these steps at these dates
  Unknown,  ///< too many runs to follow, or the environment may have done more than is recorded
};

/// Whether a recorded run is one of the model.
struct ConformResult {
  Conformance verdict = Conformance::Conforms;
  std::size_t step = 0;   ///< Deviates, Unknown: the first step that nothing explains
  std::string why;        ///< in words
  std::string assumption; ///< of the model that was broken, where that is known
};

struct ConformOptions {
  std::string mainSkill;
  /// How far what the platform and the environment do may be off its interval.
  Nanoseconds tolerance = 0;
};

/// Follows a recorded run through the model that is verified: all of its runs that have the same
/// steps at the same dates. What a recording does not have (watchdogs; the environment, where it
/// was not executed) may happen in between.
[[nodiscard]] std::expected<ConformResult, NotExecutable>
conform(const analysis::Program& program, const RecordedRun& run, const ConformOptions& options);

} // namespace proskill::runtime
