#pragma once

#include "cli/terminal/paint.h"
#include "runtime/conform/recorded_run.h"

#include <string>
#include <vector>

namespace proskill::cli {

/// Prints which intervals of actions recorded runs do not keep, and which verdicts change if the
/// program has intervals that they keep.
/// \param file root of the program
/// \return an exit code: kDone, or kFailed if the program cannot be verified
int learn(const analysis::Program& program, const std::string& file, const std::string& mainSkill,
          const std::vector<runtime::RecordedRun>& runs, ColourChoice colour);

} // namespace proskill::cli
