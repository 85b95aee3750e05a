#pragma once

#include "runtime/platform/json_file.h"
#include "runtime/platform/process.h"
#include "runtime/platform/ros_words.h"

#include <string>

namespace proskill::runtime {

/// Reads the file of a platform of kind `ros1` or `ros2`, and checks it against the program. The
/// settings get what the adapter, `proskill.ros1` or `proskill.ros2`, needs to know:
/// docs/ros/ros1.md, docs/ros/ros2.md. An error names each skill that has no action, unless the
/// settings say that somebody else performs it. \param library
/// of ROS 2: the shared library with which the adapter reaches DDS
[[nodiscard]] FileErrors readRosPlatform(const JsonFile& file, Ros ros,
                                         const analysis::Program& program,
                                         const codegen::PlatformInterface& interface,
                                         ProcessSettings& settings,
                                         const std::string& library = "");

} // namespace proskill::runtime
