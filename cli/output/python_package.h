#pragma once

#include <string>
#include <vector>

namespace proskill::cli {

/// The arguments with which Python starts a part of the package `proskill`, such as `ros1`: the
/// folder that belongs to this program, installed with it or in the tree in which it was built, or
/// else `-m proskill.ros1`.
[[nodiscard]] std::vector<std::string> pythonPackage(const std::string& part);

/// The shared library with which `proskill.ros2` reaches DDS, of this program; empty if it was
/// built without.
[[nodiscard]] std::string ddsLibrary();

} // namespace proskill::cli
