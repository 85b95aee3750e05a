#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Finds the files that were installed, or built, with this program.
namespace proskill::disk {

/// Where this program is.
[[nodiscard]] std::filesystem::path folderOfProgram();

/// The program `proskill` for a library or a program that contains this code: beside it, where
/// both were installed or built, or on the PATH. Empty if there is none.
[[nodiscard]] std::filesystem::path proskillOfLibrary();

/// The shared library that shows runs, `libproskill_view.so`, for a library or a program that
/// contains this code. Empty if it was not installed or built with it.
[[nodiscard]] std::filesystem::path viewLibrary();

/// The arguments with which Python starts a part of the package `proskill`, such as `ros1`: the
/// folder that belongs to the program, installed with it or in the tree in which it was built, or
/// else `-m proskill.ros1`.
/// \param folder of the program
[[nodiscard]] std::vector<std::string> pythonPackage(const std::filesystem::path& folder,
                                                     const std::string& part);

/// The shared library with which `proskill.ros2` reaches DDS, of the program in a folder; empty if
/// it was built without.
[[nodiscard]] std::string ddsLibrary(const std::filesystem::path& folder);

} // namespace proskill::disk
