#include "cli/execution/commands.h"

#include "cli/output/checked_program.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "disk/disk.h"
#include "report/simulation_json.h"
#include "syntax/text/utf8.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <iostream>
#include <memory>

namespace proskill::cli {

namespace {

struct ReplayArguments {
  std::string file;
  std::vector<std::string> runs;
  ColourChoice colour = ColourChoice::Auto;
};

/// Generates a model for each run, since runs may have different missions.
std::expected<ide::SimulatedRun, std::string> begin(const analysis::Program& program,
                                                    const std::string& mainSkill) {
  codegen::Options options;
  options.mainSkill = mainSkill;
  auto model = codegen::generate(program, options);
  if (!model) return std::unexpected(model.error().message);
  return ide::SimulatedRun::start(std::move(*model));
}

void sayMissing(const report::ChosenRun& asked, const ide::MissingStep& missing) {
  const auto& step = asked.steps[missing.index];
  std::cout << fmt::format("  step {} of {} is not possible: `{}` {}; {}\n", missing.index + 1,
                           asked.steps.size(), syntax::printable(step.actor),
                           syntax::printable(step.description), syntax::printable(missing.why));
}

void sayUnmet(const ide::UnmetValue& value) {
  const auto actual =
      value.actual.empty() ? "is not in the program" : "is " + syntax::printable(value.actual);
  std::cout << fmt::format("  `{}` {}, expected {}\n", syntax::printable(value.variable), actual,
                           syntax::printable(value.expected));
}

/// Whether the run is possible and ends as expected.
std::expected<bool, std::string> replayOne(const analysis::Program& program,
                                           const std::string& file) {
  const auto text = disk::DiskFileSystem().read(file);
  if (!text) return std::unexpected("cannot read `" + file + "`: " + text.error());
  const auto asked = report::readChosenRun(parsedJson(*text));
  if (!asked) return std::unexpected("`" + file + "` is not a run: " + asked.error());
  auto run = begin(program, asked->mainSkill);
  if (!run) return std::unexpected(run.error());
  const auto missing = run->follow(asked->steps);
  const auto unmet = missing ? std::vector<ide::UnmetValue>() : ide::unmet(*run, asked->expected);
  const bool passed = !missing && unmet.empty();
  std::cout << fmt::format("{} {}: {} steps\n", passed ? "passed" : "failed", forOutput(file),
                           asked->steps.size());
  if (missing) sayMissing(*asked, *missing);
  for (const auto& value : unmet) sayUnmet(value);
  return passed;
}

int runReplay(const ReplayArguments& arguments) {
  const auto program = loadChecked(arguments.file, arguments.colour);
  if (!program) return kFailed;
  bool passed = true;
  for (const auto& file : arguments.runs) {
    const auto result = replayOne(*program, file);
    if (!result) return fail(result.error());
    passed &= *result;
  }
  return passed ? kDone : kFound;
}

} // namespace

void addReplay(CLI::App& app, int& exitCode) {
  auto arguments = std::make_shared<ReplayArguments>();
  auto* command = app.add_subcommand("replay", "Replay saved runs, and compare how they end");
  command->add_option("file", arguments->file, "Root file of the program")->required();
  command
      ->add_option("runs", arguments->runs,
                   "Runs saved by the simulation of `proskill view` or VS Code")
      ->required();
  addColour(*command, arguments->colour);
  showBelow(*command, {"proskill replay mission.proskill tests/*.run.json"},
            {{kDone, "each run is possible and ends as expected"},
             {kFound, "a step is not possible any more, or a value differs"},
             {kFailed, "the command line, a file or the program is wrong"}});
  command->callback([arguments, &exitCode] { exitCode = runReplay(*arguments); });
}

} // namespace proskill::cli
