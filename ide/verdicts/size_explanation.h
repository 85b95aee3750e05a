#pragma once

#include "analysis/program/program.h"
#include "codegen/model.h"
#include "verify/size/size_report.h"

#include <expected>

namespace proskill::ide {

/// A part of a program that multiplies its states.
struct SizeRow {
  std::string name; ///< a state variable, a skill, a branch, a watchdog, an event
  std::optional<analysis::Location> location;
  std::uint64_t values = 0; ///< combinations of values and places that it takes
  std::uint32_t clocks = 0;
  double factor = 1; ///< how many times more classes there are because of it
  /// What it is that multiplies, and what would help, as sentences.
  std::vector<std::string> advice;
};

/// Where the states of a program come from, in its own terms.
struct SizeExplanation {
  verify::SizeReport counts;  ///< its parts are those of `rows`
  std::vector<SizeRow> rows;  ///< the greatest factor first
  std::vector<SizeRow> kinds; ///< parts of one kind together, likewise; not those of the only kind
  std::vector<std::string> apart; ///< names of properties that are explored apart
};

/// Limits of an exploration that explains the size; it is then about the states found by then.
inline constexpr double kSecondsOfExplanation = 2;
inline constexpr std::uint64_t kClassesOfExplanation = 20'000;

/// Explores a program, within these limits, and explains its size.
/// \param names select properties; none: all
/// \param options `limits` are replaced by those above where they are wider
[[nodiscard]] std::expected<SizeExplanation, verify::Unsupported>
explainSize(const analysis::Program& program, const codegen::Model& model,
            const std::vector<std::string>& names, verify::Options options);

/// What the counts are about, as sentences.
[[nodiscard]] std::vector<std::string> sizeSummary(const SizeExplanation& explanation);

} // namespace proskill::ide
