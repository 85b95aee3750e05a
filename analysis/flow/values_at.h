#pragma once

#include "analysis/flow/flow.h"

#include <optional>
#include <string>
#include <vector>

namespace proskill::analysis::flow {

/// A step of a program, with its place in the text.
struct Point {
  ProcessId process = kNoProcess;
  NodeId node = kNoNode;
  Location at; ///< the location of the statement, the test, a condition or effects
};

/// The steps at a place: those with the smallest text around it. There are several if one text is
/// several steps, and none outside of skills and environments or in skills that nothing starts.
[[nodiscard]] std::vector<Point> pointsAround(const Flow& flow, Location place);

/// All steps whose text or whose condition touches a range, by process; each with its own text.
[[nodiscard]] std::vector<Point> pointsTouching(const Flow& flow, Location range);

/// The possible values of a variable when a process reaches one of the points, before its action.
/// Nothing if none of the points tracks the variable, or none is reachable.
[[nodiscard]] std::optional<ValueSet> valuesAt(const Flow& flow, const std::vector<Point>& points,
                                               VariableId variable);

/// Whether any of the points is reachable.
[[nodiscard]] bool isReached(const Flow& flow, const std::vector<Point>& points);

} // namespace proskill::analysis::flow
