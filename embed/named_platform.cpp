#include "embed/named_platform.h"

#include "analysis/program/named_platform.h"
#include "disk/disk.h"
#include "disk/installation.h"

#include <fmt/format.h>

namespace proskill::embed {

using runtime::PlatformKind;

namespace {

/// An error at the skill that it is about, or else in the file.
std::string line(const analysis::Program& program, const std::string& path,
                 const runtime::FileError& error) {
  if (const auto* skill = program.skills.find(error.skill))
    return errorAt(program, {skill->file, (*skill)->name.range}, error.why);
  const auto place = error.place ? ":" + error.place->text() : "";
  return fmt::format("{}{}: error: {}", path, place, error.why);
}

std::unexpected<Failure> invalid(const analysis::Program& program,
                                 const std::filesystem::path& path,
                                 const runtime::FileErrors& errors) {
  std::string lines;
  for (const auto& error : errors)
    lines += (lines.empty() ? "" : "\n") + line(program, path.generic_string(), error);
  return failed(PROSKILL_INVALID_PLATFORM, std::move(lines));
}

runtime::PlatformTools tools() {
  const auto proskill = disk::proskillOfLibrary();
  const auto folder = proskill.parent_path();
  return {.proskill = proskill.string(),
          .ros1 = disk::pythonPackage(folder, "ros1"),
          .ros2 = disk::pythonPackage(folder, "ros2"),
          .dds = disk::ddsLibrary(folder)};
}

std::unexpected<Failure> unreadable(const analysis::Program& program,
                                    const std::optional<analysis::NamedPlatform>& named,
                                    const std::filesystem::path& path, const std::string& why) {
  const auto text = fmt::format("cannot read `{}`: {}", path.generic_string(), why);
  return failed(PROSKILL_UNREADABLE, named ? errorAt(program, named->at, text) : text);
}

} // namespace

std::expected<std::optional<NamedPlatform>, Failure>
NamedPlatform::read(const analysis::Program& program, const proskill_options& options) {
  if (options.no_platform) return std::nullopt;
  const auto named = options.platform ? std::nullopt : analysis::namedPlatform(program);
  if (!options.platform && !named) return std::nullopt;
  auto path = named ? named->file : std::filesystem::path(options.platform);
  const auto text = disk::DiskFileSystem().read(path);
  if (!text) return unreadable(program, named, path, text.error());
  auto content = runtime::PlatformFile::parse(*text);
  if (!content) return invalid(program, path, content.error());
  return NamedPlatform(std::move(path), std::move(*content));
}

Done NamedPlatform::suits(bool isReal, double speed) const {
  const auto wrong = [&](const char* why) {
    return failed(PROSKILL_INVALID_ARGUMENT, fmt::format("{}: {}", path.generic_string(), why));
  };
  if (content.kind == PlatformKind::Simulated) return {};
  if (!isReal) return wrong("`clock` must be PROSKILL_REAL_TIME: this platform takes real time");
  const bool isRos = content.kind == PlatformKind::Ros1 || content.kind == PlatformKind::Ros2;
  if (isRos && speed != 1) return wrong("`speed` must be 1: ROS takes real time");
  return {};
}

bool NamedPlatform::isSimulated() const { return content.kind == PlatformKind::Simulated; }

bool NamedPlatform::needsEnvironment() const {
  return isSimulated() && !speaksForEnvironment(content.file);
}

std::expected<std::unique_ptr<runtime::Platform>, Failure>
NamedPlatform::open(const Run& run) const {
  return content.kind == PlatformKind::Simulated ? simulated(run) : process(run);
}

std::expected<std::unique_ptr<runtime::Platform>, Failure>
NamedPlatform::simulated(const Run& run) const {
  auto settings = defaultSettings(run.executable);
  const auto wrong = readSimulation(content.file, run.executable.model, settings);
  if (!wrong.empty()) return invalid(run.program, path, wrong);
  return simulatedPlatform(std::move(settings), run.seed + 1);
}

std::expected<std::unique_ptr<runtime::Platform>, Failure>
NamedPlatform::process(const Run& run) const {
  runtime::ProcessSettings settings;
  settings.elsewhere = run.elsewhere;
  settings.speed = run.speed;
  settings.directory = std::filesystem::absolute(path).parent_path();
  const auto wrong = readProcess(content, run.program, run.executable.model, tools(), settings);
  if (!wrong.empty()) return invalid(run.program, path, wrong);
  const auto place = settings.place;
  auto made =
      processPlatform(run.executable, std::move(settings), [&] { return run.stopRequests > 0; });
  if (made) return std::move(*made);
  return invalid(run.program, path, {{made.error().why, place, made.error().skill}});
}

} // namespace proskill::embed
