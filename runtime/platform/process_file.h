#pragma once

#include "runtime/platform/settings.h"

#include <string>
#include <vector>

namespace proskill::runtime {

/// Parts of the installation that platforms need.
struct PlatformTools {
  std::string proskill;          ///< the program, which hosts libraries; empty: not found
  std::vector<std::string> ros1; ///< arguments with which Python starts the adapter
  std::vector<std::string> ros2;
  std::string dds; ///< the library with which the adapter reaches DDS; empty: built without
};

/// Reads the file of a platform that a process performs: its own program, the process in which a
/// library is loaded, or an adapter. \pre its kind is not `simulated`
[[nodiscard]] FileErrors readProcess(const PlatformFile& platform, const analysis::Program& program,
                                     const codegen::PlatformInterface& interface,
                                     const PlatformTools& tools, ProcessSettings& settings);

} // namespace proskill::runtime
