#include "cli/commands/emit.h"

#include "cli/output/checked_program.h"
#include "cli/terminal/choice.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "cli/terminal/paint.h"
#include "codegen/model.h"
#include "disk/disk.h"
#include "disk/output.h"
#include "fiacre/print/print.h"
#include "report/text/render.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

namespace proskill::cli {
namespace {

enum class Target : std::uint8_t { Fiacre, Tina, HFiacre };

struct EmitArguments {
  Target target = Target::Fiacre;
  std::string file;
  std::string output;
  bool expanded = false;
  bool prove = false;
  ColourChoice colour = ColourChoice::Auto;
  codegen::Options options;
};

codegen::Edition edition(const EmitArguments& arguments) {
  if (arguments.target == Target::HFiacre) return codegen::Edition::Runtime;
  if (arguments.target == Target::Tina) return codegen::Edition::Tina;
  return arguments.expanded ? codegen::Edition::Expanded : codegen::Edition::Compact;
}

int runEmit(const EmitArguments& arguments) {
  const auto program = loadChecked(arguments.file, arguments.colour);
  if (!program) return kFailed;
  auto options = arguments.options;
  options.edition = edition(arguments);
  const auto model = codegen::generate(*program, options);
  if (!model) {
    failGeneration(*program, model.error());
    return kFailed;
  }
  const auto text = fiacre::print(model->fiacre, {.prove = arguments.prove});
  const auto failed = disk::writeOutput(arguments.output, text);
  return failed ? fail(*failed) : kDone;
}

} // namespace

void addEmit(CLI::App& app, int& exitCode) {
  auto arguments = std::make_shared<EmitArguments>();
  auto* command = app.add_subcommand("emit", "Print the Fiacre model of a program");
  addChoice<Target>(
      *command, "target", arguments->target,
      {{"fiacre", Target::Fiacre}, {"tina", Target::Tina}, {"hfiacre", Target::HFiacre}},
      "fiacre: a model to verify; tina: the same for frac and Tina; hfiacre: a model to execute")
      ->required();
  command->add_option("file", arguments->file, "Root file of the program")->required();
  addMainSkill(*command, arguments->options.mainSkill);
  show(command->add_option("-o,--output", arguments->output,
                           "Write to this file instead of standard output"),
       group::kOutput, "FILE");
  auto* expanded = show(command->add_flag("--expanded", arguments->expanded,
                                          "fiacre: one state per step of a skill, easier to read"),
                        group::kOutput);
  show(command->add_flag("--prove", arguments->prove,
                         "Write `prove` instead of `assert` for each property"),
       group::kOutput);
  addColour(*command, arguments->colour);
  show(command
           ->add_option("--rate", arguments->options.ticksPerSecond,
                        "hfiacre: ticks per second (default 100)")
           ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000}))
           ->excludes(expanded),
       group::kAdvanced, "HZ");
  using codegen::StateVariableAutomata;
  addChoice<StateVariableAutomata>(
      *command, "--sv-automata", arguments->options.automata,
      {{"exact", StateVariableAutomata::Exact}, {"paper", StateVariableAutomata::Paper}},
      "exact: detect every forbidden move of a state variable; paper: poll, as the paper does",
      group::kAdvanced);
  showBelow(*command,
            {"proskill emit fiacre mission.proskill",
             "proskill emit hfiacre --rate 50 -o mission.hfcr mission.proskill"},
            {{kDone, "the model was written"},
             {kFailed, "the program has errors, or the command line or the output is wrong"}});
  command->callback([arguments, &exitCode] { exitCode = runEmit(*arguments); });
}

} // namespace proskill::cli
