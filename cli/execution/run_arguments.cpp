#include "cli/execution/run_arguments.h"

#include "cli/terminal/choice.h"
#include "cli/terminal/help.h"

#include <charconv>
#include <cmath>

namespace proskill::cli {

namespace {

/// Removes a number from the beginning of a word.
std::optional<double> leadingNumber(std::string_view& word) {
  double number = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
  if (read.ec != std::errc() || !(number > 0 && number <= 1e9)) return std::nullopt;
  word.remove_prefix(static_cast<std::size_t>(read.ptr - word.data()));
  return number;
}

/// `90`, `90s`, `5m`, `2h`, `1d`
std::optional<runtime::Nanoseconds> lengthOfTime(std::string_view word) {
  const auto number = leadingNumber(word);
  if (!number) return std::nullopt;
  for (const auto& [unit, seconds] :
       {std::pair{"", 1}, {"s", 1}, {"m", 60}, {"h", 3600}, {"d", 86400}})
    if (word == unit && *number * seconds <= 1e9)
      return std::llround(*number * seconds * static_cast<double>(runtime::kSecond));
  return std::nullopt;
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
           ->needs(on),
       group::kAdvanced, "PORT");
}

} // namespace

std::optional<double> clockFactor(const std::string& clock) {
  if (clock == "real") return 1;
  std::string_view word = clock;
  const auto number = leadingNumber(word);
  return number && word == "x" && *number <= 1e6 ? number : std::nullopt;
}

void addRunOptions(CLI::App& command, RunArguments& arguments) {
  command.add_option("file", arguments.file, "Root file of the program")->required();
  addMainSkill(command, arguments.mainSkill);
  show(command.add_option(
           "--platform", arguments.platform,
           "Platform that performs the actions (JSON): a program, a library, ROS 1, or a "
           "simulation (default)"),
       group::kSubject, "FILE");
  show(command.add_option("--script", arguments.script,
                          "Script of a simulation (JSON): results, events, interrupts"),
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
  show(command.add_option("--seed", arguments.seed,
                          "Seed of a simulation (default 0); the same seed gives the same run"),
       group::kSubject, "SEED");
  const auto setUntil = [&arguments](const std::string& word) {
    arguments.until = lengthOfTime(word);
    if (!arguments.until)
      throw CLI::ValidationError("--until",
                                 "`" + word + "` is not a time such as 90, 5m, 2h or 1d");
  };
  show(command.add_option_function<std::string>(
           "--until", setUntil,
           "End the run after this time, in seconds or with m, h, d (a simulation: 1d)"),
       group::kLimits, "TIME");
  addChoice<RunFormat>(command, "--format", arguments.format,
                       {{"text", RunFormat::Text}, {"json", RunFormat::Json}},
                       "How to print what happens");
  show(command.add_option(
           "--record", arguments.record,
           "Record the run in this file, as a trace that `proskill view` opens; a name that "
           "ends in .mcap: as MCAP, for other tools"),
       group::kOutput, "FILE");
  addViewOptions(command, arguments.view);
  addColour(command, arguments.colour);
}

} // namespace proskill::cli
