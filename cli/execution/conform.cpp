#include "cli/execution/conform.h"

#include "cli/output/checked_program.h"
#include "cli/terminal/choice.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "disk/disk.h"
#include "report/run/read_recording.h"
#include "report/verify_report.h"
#include "runtime/conform/conform.h"
#include "syntax/text/utf8.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <memory>

namespace proskill::cli {

namespace {

struct ConformArguments {
  std::string recording;
  std::string file;
  double tolerance = 0; ///< in seconds
  ColourChoice colour = ColourChoice::Auto;
};

std::string placeOf(const analysis::Program& program, const fiacre::Origin& what) {
  if (what.begin == what.end || what.file >= program.files.size()) return "";
  return report::place(program, {what.file, {what.begin, what.end}}) + ": ";
}

int say(const analysis::Program& program, const runtime::RecordedRun& run,
        const runtime::ConformResult& result) {
  using runtime::Conformance;
  if (result.verdict == Conformance::Conforms) {
    std::cout << fmt::format("the run conforms to the model: {} steps\n", run.steps.size());
    return kDone;
  }
  const auto& step = run.steps[result.step];
  const auto date = static_cast<double>(step.date) / static_cast<double>(runtime::kSecond);
  std::cout << syntax::printable(placeOf(program, step.what))
            << fmt::format("step {}, at {:.9g} s: `{}` {}\n", result.step + 1, date,
                           syntax::printable(step.what.actor),
                           syntax::printable(step.what.description));
  std::cout << (result.verdict == Conformance::Unknown ? "this cannot be decided: "
                                                       : "no run of the model explains it: ")
            << result.why << '\n';
  if (!result.assumption.empty()) std::cout << "broken assumption: " << result.assumption << '\n';
  return result.verdict == Conformance::Unknown ? kInconclusive : kFound;
}

int runConform(const ConformArguments& arguments) {
  const auto program = loadChecked(arguments.file, arguments.colour);
  if (!program) return kFailed;
  const auto text = disk::DiskFileSystem().read(arguments.recording);
  if (!text) return fail("cannot read `" + arguments.recording + "`: " + text.error());
  runtime::ConformOptions options;
  const auto run = report::readRecording(*text, *program, options.mainSkill);
  if (!run) return fail("`" + arguments.recording + "` cannot be judged: " + run.error());
  options.tolerance = std::llround(arguments.tolerance * static_cast<double>(runtime::kSecond));
  const auto result = runtime::conform(*program, *run, options);
  if (!result) return failGeneration(*program, result.error());
  return say(*program, *run, *result);
}

} // namespace

void addConform(CLI::App& app, int& exitCode) {
  auto arguments = std::make_shared<ConformArguments>();
  auto* command =
      app.add_subcommand("conform", "Check whether a recorded run is a run of the verified model");
  command
      ->add_option("recording", arguments->recording,
                   "Recording written by `proskill run --record`")
      ->required();
  command->add_option("file", arguments->file, "Root file of the program")->required();
  show(command
           ->add_option("--tolerance", arguments->tolerance,
                        "Tolerance on the intervals of actions, in seconds (default 0)")
           ->check(positiveSeconds()),
       group::kSubject, "SECONDS");
  addColour(*command, arguments->colour);
  showBelow(*command,
            {"proskill conform run.json mission.proskill",
             "proskill conform --tolerance 0.01 run.json mission.proskill"},
            {{kDone, "the recording is a run of the model"},
             {kFound, "it is not: no run of the model has these steps at these times"},
             {kFailed, "the command line, a file or the program is wrong"},
             {kInconclusive, "not decided"}});
  command->callback([arguments, &exitCode] { exitCode = runConform(*arguments); });
}

} // namespace proskill::cli
