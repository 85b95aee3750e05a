#pragma once

#include "analysis/program/stop.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

namespace proskill::cli {

/// Limits of a command while it reads a program and generates its model. Nothing is decided by
/// then, so small programs are read whatever the limit, and their properties are inconclusive.
struct FrontLimits {
  std::chrono::steady_clock::time_point begun; ///< of the command
  std::optional<double> seconds;
  std::optional<std::uint64_t> bytes; ///< of resident memory
};

/// The limit that has ended the work, and the option that raises it.
struct FrontLimitMet {
  std::string_view limit;
  std::string_view option;
};

/// Does the work unless it meets a limit.
/// \return the limit that has ended it, or nothing
[[nodiscard]] std::optional<FrontLimitMet> withinLimits(const FrontLimits& limits,
                                                        const std::function<void()>& work);

} // namespace proskill::cli
