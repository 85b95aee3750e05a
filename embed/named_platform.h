#pragma once

#include "embed/failure.h"
#include "embed/program.h"
#include "runtime/platform/process_file.h"

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>

namespace proskill::embed {

/// The platform that the options or the program name, by its file.
class NamedPlatform {
public:
  /// Reads the file. \return nullopt if none is named, or is wanted
  [[nodiscard]] static std::expected<std::optional<NamedPlatform>, Failure>
  read(const analysis::Program& program, const proskill_options& options);

  /// Fails if the platform cannot be used with such a clock.
  [[nodiscard]] Done suits(bool isReal, double speed) const;
  /// Whether it is a simulation, which follows the clock of the run.
  [[nodiscard]] bool isSimulated() const;
  /// Whether it leaves the events to the program's own environment.
  [[nodiscard]] bool needsEnvironment() const;

  /// A run that the platform is for.
  struct Run {
    const analysis::Program& program;
    const runtime::Executable& executable;
    std::vector<std::string> elsewhere; ///< skills whose actions it does not perform
    double speed = 1;                   ///< of a real clock
    std::uint64_t seed = 0;
    const std::atomic<int>& stopRequests;
  };
  /// Starts it, and waits until it is ready.
  [[nodiscard]] std::expected<std::unique_ptr<runtime::Platform>, Failure>
  open(const Run& run) const;

private:
  NamedPlatform(std::filesystem::path file, runtime::PlatformFile parsed)
      : path(std::move(file)), content(std::move(parsed)) {}
  [[nodiscard]] std::expected<std::unique_ptr<runtime::Platform>, Failure>
  simulated(const Run& run) const;
  [[nodiscard]] std::expected<std::unique_ptr<runtime::Platform>, Failure>
  process(const Run& run) const;

  std::filesystem::path path;
  runtime::PlatformFile content;
};

} // namespace proskill::embed
