#pragma once

#include "cli/terminal/paint.h"
#include "runtime/conform/durations.h"

#include <map>
#include <string>

namespace proskill::cli {

using DurationsBySkill = std::map<std::string, runtime::Durations>;

struct LearnOptions {
  std::string mainSkill;
  double seconds = 60; ///< limit of both verifications together
  ColourChoice colour = ColourChoice::Auto;
};

/// Prints which intervals of actions recorded runs do not keep, and which verdicts change if the
/// program has intervals that they keep.
/// \param file root of the program
/// \return an exit code: kDone, or kFailed if the program cannot be verified
int learn(const analysis::Program& program, const std::string& file,
          const DurationsBySkill& measured, const LearnOptions& options);

} // namespace proskill::cli
