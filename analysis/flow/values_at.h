#pragma once

#include "analysis/flow/flow.h"

#include <optional>
#include <string>
#include <vector>

namespace proskill::analysis::flow {

/// A step of a program, as a place in its text.
struct Point {
  ProcessId process = kNoProcess;
  NodeId node = kNoNode;
  Location at; ///< of the statement, of the test, of a condition or of effects
};

/// The steps that a place belongs to: those with the smallest text around it. Several where one
/// text is several steps; none outside of skills and environments, and in what nobody starts.
[[nodiscard]] std::vector<Point> pointsAround(const Flow& flow, Location place);

/// All steps whose text, or whose condition's, touches a range, by process; each at its own text.
[[nodiscard]] std::vector<Point> pointsTouching(const Flow& flow, Location range);

/// What a variable may be when a process comes to one of the points, before it does what is said
/// there. Nothing where none of the points follows the variable, or none is ever reached.
[[nodiscard]] std::optional<ValueSet> valuesAt(const Flow& flow, const std::vector<Point>& points,
                                               VariableId variable);

/// Whether any of the points is ever reached.
[[nodiscard]] bool isReached(const Flow& flow, const std::vector<Point>& points);

} // namespace proskill::analysis::flow
