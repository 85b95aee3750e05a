#include "cli/commands/emit.h"

#include "cli/output/checked_program.h"
#include "cli/terminal/choice.h"
#include "cli/terminal/error.h"
#include "cli/terminal/paint.h"
#include "codegen/model.h"
#include "disk/disk.h"
#include "disk/output.h"
#include "fiacre/syntax/print.h"
#include "report/render.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

namespace proskill::cli {
namespace {

enum ExitCode { kWritten = 0, kFailed = 2 };

enum class Target : std::uint8_t { Fiacre, Tina, HFiacre };

struct Arguments {
  Target target = Target::Fiacre;
  std::string file;
  std::string output;
  bool expanded = false;
  bool prove = false;
  ColourChoice colour = ColourChoice::Auto;
  codegen::Options options;
};

codegen::Edition edition(const Arguments& arguments) {
  if (arguments.target == Target::HFiacre) return codegen::Edition::Runtime;
  if (arguments.target == Target::Tina) return codegen::Edition::Tina;
  return arguments.expanded ? codegen::Edition::Expanded : codegen::Edition::Compact;
}

int run(const Arguments& arguments) {
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
  const auto failed = writeOutput(arguments.output, text);
  return failed ? fail(*failed) : kWritten;
}

} // namespace

void addEmit(CLI::App& app, int& exitCode) {
  auto arguments = std::make_shared<Arguments>();
  auto* command = app.add_subcommand("emit", "Print the model of a program as Fiacre");
  addChoice<Target>(
      *command, "target", arguments->target,
      {{"fiacre", Target::Fiacre}, {"tina", Target::Tina}, {"hfiacre", Target::HFiacre}},
      "For verification, for frac and Tina, or for execution")
      ->required();
  command->add_option("file", arguments->file, "The program's root file")->required();
  command->add_option("-o,--output", arguments->output, "Write here, not to standard output");
  command->add_option("--main", arguments->options.mainSkill, "The skill that is the mission");
  auto* expanded = command->add_flag("--expanded", arguments->expanded,
                                     "fiacre: a state for every step, to be read");
  command
      ->add_option("--rate", arguments->options.ticksPerSecond, "hfiacre: ticks per second, in Hz")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000}))
      ->excludes(expanded);
  command->add_flag("--prove", arguments->prove, "`prove` for each property, not `assert`");
  using codegen::StateVariableAutomata;
  addChoice<StateVariableAutomata>(
      *command, "--sv-automata", arguments->options.automata,
      {{"exact", StateVariableAutomata::Exact}, {"paper", StateVariableAutomata::Paper}},
      "Automata that see each forbidden move, or that poll the variables");
  addColour(*command, arguments->colour);
  command->callback([arguments, &exitCode] { exitCode = run(*arguments); });
}

} // namespace proskill::cli
