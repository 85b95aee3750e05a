#pragma once

#include "analysis/program/program.h"
#include "cli/execution/live_view.h"
#include "cli/terminal/paint.h"
#include "runtime/executor/executor.h"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace proskill::cli {

enum class RunFormat : std::uint8_t { Text, Json };

/// `--groot` and what belongs to it.
struct GrootArguments {
  bool isOn = false;
  std::uint16_t port = 1667; ///< messages are published at the next one; 0: any free one
};

struct RunArguments {
  std::string file;
  std::string mainSkill;
  std::string platform;    ///< a file; empty: the one that the program names
  bool noPlatform = false; ///< a simulation, although the program names a platform
  std::string script;      ///< a file
  std::string record;      ///< a file
  bool noRecord = false;   ///< also of a robot
  std::string clock;       ///< `real`, `simulated`, `10x`; empty: depends on the platform
  std::uint64_t seed = 0;
  std::optional<std::int64_t> rate; ///< ticks per second; nullopt: dense time
  bool isRealtime = false;
  std::optional<runtime::Nanoseconds> until;
  RunFormat format = RunFormat::Text;
  LiveViewArguments view;
  GrootArguments groot;
  ColourChoice colour = ColourChoice::Auto;
};

void addRunOptions(CLI::App& command, RunArguments& arguments);

/// Takes the platform that the program names, unless an option says otherwise.
/// \return where the program names it; nothing if it is not taken
std::optional<analysis::Location> takeNamedPlatform(RunArguments& arguments,
                                                    const analysis::Program& program);

/// The speed of a real clock: 1, or 10 for `10x`; nullopt: simulated.
[[nodiscard]] std::optional<double> clockFactor(const std::string& clock);

} // namespace proskill::cli
