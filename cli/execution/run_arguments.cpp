#include "cli/execution/run_arguments.h"

#include "analysis/program/named_platform.h"
#include "cli/terminal/choice.h"
#include "cli/terminal/help.h"
#include "cli/terminal/length_of_time.h"
#include "cli/terminal/number.h"

namespace proskill::cli {

namespace {

/// An empty name is mostly that of a variable of a shell which is not set.
CLI::Validator namesFile() {
  return {[](const std::string& name) {
            return name.empty() ? std::string("the name of the file is empty") : std::string();
          },
          ""};
}

void addViewOptions(CLI::App& command, LiveViewArguments& view) {
  auto* on = command.add_flag(
      "--view", view.isOn,
      "Show the run in a browser while it happens, and afterwards until Ctrl-C; in simulated time "
      "it begins paused");
  show(on, group::kOutput);
  show(command
           .add_flag("--no-controls", view.noControls,
                     "With --view: pages cannot pause the run, or send events and interrupts")
           ->needs(on),
       group::kOutput);
  show(command
           .add_flag("--no-open", view.noOpen,
                     "With --view: print the address without opening a browser")
           ->needs(on),
       group::kOutput);
  show(command
           .add_option("--port", view.port,
                       "With --view: port on the loopback interface (0, the default: any free "
                       "port)")
           ->check(portNumber())
           ->needs(on),
       group::kAdvanced, "PORT");
}

void addGrootOptions(CLI::App& command, GrootArguments& groot) {
  auto* on = command.add_flag(
      "--groot", groot.isOn,
      "Let Groot2 and other viewers of behavior trees watch the run, and afterwards until Ctrl-C; "
      "composite skills are shown as trees");
  show(on, group::kOutput);
  show(command
           .add_option("--groot-port", groot.port,
                       "With --groot: port of requests on the loopback interface, the next one is "
                       "for messages (default 1667; 0: any free ones)")
           ->check(CLI::Range(0, UINT16_MAX - 1))
           ->needs(on),
       group::kAdvanced, "PORT");
}

} // namespace

std::optional<double> clockFactor(const std::string& clock) {
  if (clock == "real") return 1;
  std::string_view word = clock;
  const auto number = takeNumber(word);
  return number && word == "x" && *number > 0 && *number <= 1e6 ? number : std::nullopt;
}

std::optional<analysis::Location> takeNamedPlatform(RunArguments& arguments,
                                                    const analysis::Program& program) {
  if (!arguments.platform.empty() || arguments.noPlatform) return std::nullopt;
  const auto named = analysis::namedPlatform(program);
  if (!named) return std::nullopt;
  arguments.platform = named->file.generic_string();
  return named->at;
}

void addRunOptions(CLI::App& command, RunArguments& arguments) {
  command.add_option("file", arguments.file, "Root file of the program")->required();
  addMainSkill(command, arguments.mainSkill);
  auto* platform = command.add_option(
      "--platform", arguments.platform,
      "Platform that performs the actions (JSON): a program, a library, ROS 1 or 2, or a "
      "simulation; default: the one that the program names by `defplatform`, else a simulation");
  show(platform->check(namesFile()), group::kSubject, "FILE");
  show(command
           .add_flag("--no-platform", arguments.noPlatform,
                     "Simulate everything, although the program names a platform")
           ->excludes(platform),
       group::kSubject);
  show(command
           .add_option("--script", arguments.script,
                       "Script of a simulation (JSON): results, events, interrupts")
           ->check(namesFile()),
       group::kSubject, "FILE");
  const auto isClock = [](const std::string& word) {
    return word == "simulated" || clockFactor(word)
               ? std::string()
               : "`" + word + "` is none of real, simulated, or a factor like 10x";
  };
  show(command
           .add_option("--clock", arguments.clock,
                       "Real time, N times real time (10x), or simulated: time jumps to the next "
                       "step (default of a simulation)")
           ->check(CLI::Validator(isClock, "")),
       group::kSubject, "real|simulated|Nx");
  show(command
           .add_option("--rate", arguments.rate,
                       "Take steps at ticks only: so many per second (default: at any time)")
           ->check(integerBetween(1, 1'000'000)),
       group::kSubject, "HZ");
  show(command
           .add_option("--seed", arguments.seed,
                       "Seed of a simulation (default 0); the same seed gives the same run")
           ->check(integerBetween(0)),
       group::kSubject, "SEED");
  addLengthOfTime(command, "--until", arguments.until,
                  "End the run after this time, in seconds or with m, h, d (a simulation: 1d)",
                  group::kLimits);
  addChoice<RunFormat>(command, "--format", arguments.format,
                       {{"text", RunFormat::Text}, {"json", RunFormat::Json}},
                       "How to print what happens");
  auto* record = command.add_option(
      "--record", arguments.record,
      "Record the run in this file, as a trace that `proskill view` opens; a name that ends in "
      ".mcap: as MCAP, in .btlog: as a log of a behavior tree, for other tools. Default: nowhere "
      "in a simulation, otherwise a new file of the user");
  show(record->check(namesFile()), group::kOutput, "FILE");
  show(command.add_flag("--no-record", arguments.noRecord, "Do not record the run of a robot")
           ->excludes(record),
       group::kOutput);
  addViewOptions(command, arguments.view);
  addGrootOptions(command, arguments.groot);
  show(command.add_flag("--realtime", arguments.isRealtime,
                        "Lock the memory and ask for SCHED_FIFO; report what is refused"),
       group::kAdvanced);
  show(command.add_flag(
           "--controls", arguments.view.controls,
           "With --realtime: pages of --view and viewers of --groot may influence the run all "
           "the same"),
       group::kAdvanced);
  addColour(command, arguments.colour);
}

} // namespace proskill::cli
