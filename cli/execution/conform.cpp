#include "cli/execution/commands.h"

#include "cli/execution/learn.h"
#include "cli/output/checked_program.h"
#include "cli/terminal/choice.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "cli/terminal/number.h"
#include "disk/disk.h"
#include "report/run/read_recording.h"
#include "report/verify_report.h"
#include "runtime/conform/conform.h"
#include "syntax/text/utf8.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <expected>
#include <iostream>
#include <memory>

namespace proskill::cli {

namespace {

struct ConformArguments {
  std::string recording;
  std::string file;
  double tolerance = 0; ///< in seconds
  bool learns = false;
  std::vector<std::string> more; ///< further recordings to learn from
  ColourChoice colour = ColourChoice::Auto;
};

std::string placeOf(const analysis::Program& program, const fiacre::Origin& what) {
  if (what.begin == what.end || what.file >= program.files.size()) return "";
  return report::place(program, {what.file, {what.begin, what.end}}) + ": ";
}

/// The step where a recording deviates, or its end.
std::string stepText(const analysis::Program& program, const runtime::RecordedRun& run,
                     std::size_t number) {
  if (number == run.steps.size()) return fmt::format("after step {}", number);
  const auto& step = run.steps[number];
  const auto date = static_cast<double>(step.date) / static_cast<double>(runtime::kSecond);
  return fmt::format("{}step {}, at {:.9g} s: `{}` {}", placeOf(program, step.what), number + 1,
                     date, step.what.actor, step.what.description);
}

int say(const analysis::Program& program, const runtime::RecordedRun& run,
        const runtime::ConformResult& result) {
  using runtime::Conformance;
  if (result.verdict == Conformance::Conforms) {
    std::cout << fmt::format("the run conforms to the model: {} steps\n", run.steps.size());
    return kDone;
  }
  std::cout << syntax::printable(stepText(program, run, result.step)) << '\n';
  std::cout << (result.verdict == Conformance::Unknown ? "this cannot be decided: "
                                                       : "no run of the model explains it: ")
            << result.why << '\n';
  if (!result.assumption.empty()) std::cout << "broken assumption: " << result.assumption << '\n';
  return result.verdict == Conformance::Unknown ? kInconclusive : kFound;
}

std::expected<runtime::RecordedRun, std::string>
readRun(const std::string& path, const analysis::Program& program, std::string& main) {
  const auto text = disk::DiskFileSystem().read(path);
  if (!text) return std::unexpected("cannot read `" + path + "`: " + text.error());
  auto run = report::readRecording(*text, program, main);
  if (!run) return std::unexpected("`" + path + "` cannot be judged: " + run.error());
  return run;
}

int runConform(const ConformArguments& arguments) {
  const auto program = loadChecked(arguments.file, arguments.colour);
  if (!program) return kFailed;
  runtime::ConformOptions options;
  const auto run = readRun(arguments.recording, *program, options.mainSkill);
  if (!run) return fail(run.error());
  options.tolerance = std::llround(arguments.tolerance * static_cast<double>(runtime::kSecond));
  const auto result = runtime::conform(*program, *run, options);
  if (!result) return failGeneration(*program, result.error());
  const auto exitCode = say(*program, *run, *result);
  if (!arguments.learns) return exitCode;
  std::vector runs{*run};
  for (const auto& path : arguments.more) {
    auto other = readRun(path, *program, options.mainSkill);
    if (!other) return fail(other.error());
    runs.push_back(std::move(*other));
  }
  const auto learned = learn(*program, arguments.file, options.mainSkill, runs, arguments.colour);
  return learned == kDone ? exitCode : learned;
}

} // namespace

void addConform(CLI::App& app, int& exitCode) {
  auto arguments = std::make_shared<ConformArguments>();
  auto* command =
      app.add_subcommand("conform", "Check whether a recorded run is a run of the verified model");
  command
      ->add_option("recording", arguments->recording,
                   "Recording written by `proskill run --record`, as a trace or as MCAP")
      ->required();
  command->add_option("file", arguments->file, "Root file of the program")->required();
  show(command
           ->add_option("--tolerance", arguments->tolerance,
                        "Tolerance on the intervals of actions, in seconds (default 0)")
           ->check(positiveSeconds()),
       group::kSubject, "SECONDS");
  auto* learns = command->add_flag(
      "--learn", arguments->learns,
      "Widen the intervals that actions did not keep, and show which verdicts change then");
  show(learns, group::kSubject);
  show(command
           ->add_option("--also", arguments->more,
                        "With --learn: another recording to learn from; may be repeated")
           ->needs(learns)
           ->expected(1),
       group::kSubject, "RECORDING");
  addColour(*command, arguments->colour);
  showBelow(*command,
            {"proskill conform run.json mission.proskill",
             "proskill conform --tolerance 0.01 run.json mission.proskill",
             "proskill conform --learn --also run2.mcap run1.mcap mission.proskill"},
            {{kDone, "the recording is a run of the model"},
             {kFound, "it is not: no run of the model has these steps at these times"},
             {kFailed, "the command line, a file or the program is wrong"},
             {kInconclusive, "not decided"}});
  command->callback([arguments, &exitCode] { exitCode = runConform(*arguments); });
}

} // namespace proskill::cli
