#pragma once

#include "verify/model/monitor.h"
#include "verify/model/nodes.h"

namespace proskill::verify {

/// Monitors that measure the time from P to the next Q. A measurement begins in the state after a
/// step with which P becomes true, after a step in which P is seen and one of its events occurs,
/// and in the initial state if P holds there. It ends at the first point from then on at which Q is
/// seen: in a state, or in a step. The monitor guesses which measurement counts; its clock is the
/// time since then. No location accepts anything.
///
/// \param from P, over states and steps \param to Q, over states and steps
/// \param system in which the nodes are
[[nodiscard]] Monitor durationMonitor(const System& system, Nodes& nodes, NodeId from, NodeId to);

/// The monitor of runs with a measurement that is still open at a time within the guard.
[[nodiscard]] Monitor lasting(Monitor monitor, ClockGuard guard);
/// The monitor of runs with a measurement that ends at a time within the guard.
[[nodiscard]] Monitor ending(Monitor monitor, ClockGuard guard);
/// The monitor of runs with a measurement that never ends, although time diverges.
[[nodiscard]] Monitor endless(Monitor monitor);

} // namespace proskill::verify
