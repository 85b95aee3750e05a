#include "runtime/platform/process_file.h"

#include "runtime/platform/ros.h"

#include <fmt/format.h>

namespace proskill::runtime {

namespace {

/// Has the library loaded in a separate process, which speaks the protocol for it. Its crashes and
/// hangs are then those of a program.
FileErrors readHost(const JsonFile& file, const codegen::PlatformInterface& interface,
                    const std::string& proskill, ProcessSettings& settings) {
  LibrarySettings library{.process = std::move(settings)};
  auto errors = readLibraryPlatform(file, interface, library);
  if (errors.empty() && proskill.empty())
    errors.push_back({"the program `proskill`, which loads libraries, is not found beside "
                      "libproskill.so or on the PATH",
                      library.place});
  settings = std::move(library.process);
  settings.place = library.place;
  settings.name = "the process of the library";
  settings.isOurs = true;
  settings.command = {proskill, "platform-host", library.library};
  for (const auto& [skill, function] : library.functions)
    settings.command.push_back(fmt::format("{}={}", skill, function));
  return errors;
}

/// Has the adapter of the Python package speak with ROS.
FileErrors readAdapter(const JsonFile& file, Ros ros, const analysis::Program& program,
                       const codegen::PlatformInterface& interface, const PlatformTools& tools,
                       ProcessSettings& settings) {
  const bool isSecond = ros == Ros::Two;
  auto errors = readRosPlatform(file, ros, program, interface, settings, isSecond ? tools.dds : "");
  if (errors.empty() && isSecond && tools.dds.empty())
    errors.push_back(
        {"platforms of kind `ros2` need Fast DDS: build `proskill` with libfastrtps-dev",
         file.placeOf(&file.json()["kind"])});
  settings.name = "the ROS adapter";
  settings.isOurs = true;
  for (const auto& word : isSecond ? tools.ros2 : tools.ros1) settings.command.push_back(word);
  return errors;
}

} // namespace

FileErrors readProcess(const PlatformFile& platform, const analysis::Program& program,
                       const codegen::PlatformInterface& interface, const PlatformTools& tools,
                       ProcessSettings& settings) {
  const auto& file = platform.file;
  switch (platform.kind) {
  case PlatformKind::Simulated: break;
  case PlatformKind::Process: return readProcessPlatform(file, settings);
  case PlatformKind::Library: return readHost(file, interface, tools.proskill, settings);
  case PlatformKind::Ros1: return readAdapter(file, Ros::One, program, interface, tools, settings);
  case PlatformKind::Ros2: return readAdapter(file, Ros::Two, program, interface, tools, settings);
  }
  return {};
}

} // namespace proskill::runtime
