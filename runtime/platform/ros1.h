#pragma once

#include "runtime/platform/process.h"

#include <optional>
#include <string_view>

namespace proskill::runtime {

/// Reads the file of a platform of kind `ros1`, and checks it against the program. The settings get
/// what the adapter `proskill.ros1` needs to know: docs/ros1.md.
[[nodiscard]] std::optional<Unusable> readRos1Platform(std::string_view text,
                                                       const analysis::Program& program,
                                                       const Executable& executable,
                                                       ProcessSettings& settings);

} // namespace proskill::runtime
