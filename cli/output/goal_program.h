#pragma once

#include "analysis/program/program.h"
#include "bridge/text/place.h"
#include "cli/terminal/paint.h"

#include <optional>
#include <string>

namespace proskill::cli {

/// A program with a goal, which is not a part of its files. The goal is shown as a file of its own.
struct GoalProgram {
  analysis::Program program;

  /// The condition.
  [[nodiscard]] const syntax::Expr& goal() const;
  /// Places in the goal, where its text alone counts.
  [[nodiscard]] static bridge::Errors inGoal(bridge::Errors errors);
};

/// Reads a goal for a program without errors, and prints the errors of the goal to standard error.
/// Nothing if it has some.
[[nodiscard]] std::optional<GoalProgram> loadGoal(const std::string& root, const std::string& goal,
                                                  ColourChoice colour);

} // namespace proskill::cli
