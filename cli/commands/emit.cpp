#include "cli/commands/commands.h"

#include "bridge/bt/emit/emit.h"
#include "bridge/pddl/emit.h"
#include "bridge/rl/emit.h"
#include "bridge/text/names.h"
#include "cli/output/bridge_report.h"
#include "cli/output/checked_program.h"
#include "cli/output/goal_program.h"
#include "cli/output/peer_model.h"
#include "cli/output/stub_files.h"
#include "cli/terminal/choice.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "cli/terminal/number.h"
#include "cli/terminal/paint.h"
#include "codegen/model.h"
#include "disk/disk.h"
#include "disk/output.h"
#include "fiacre/print/print.h"
#include "report/text/render.h"
#include "runtime/stubs/hippo.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <iostream>
#include <memory>

namespace proskill::cli {
namespace {

enum class Target : std::uint8_t {
  Fiacre,
  Tina,
  HFiacre,
  Hippo,
  BehaviorTree,
  Skillset,
  Pddl,
  Promela,
  TChecker
};

struct EmitArguments {
  Target target = Target::Fiacre;
  std::string file;
  std::string output;
  std::string goal;
  std::string leaves;
  bridge::pddl::Outcomes outcomes = bridge::pddl::Outcomes::Best;
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

/// Writes a directory.
int writeHippoProject(const EmitArguments& arguments, const analysis::Program& program) {
  if (arguments.output.empty()) return fail("`emit hippo` writes a directory: name it with `-o`");
  const auto files =
      runtime::hippoProject(program, arguments.options.mainSkill, arguments.options.ticksPerSecond);
  if (!files) return failGeneration(program, files.error());
  return writeStubFiles(*files, arguments.output);
}

/// Writes a program in another language.
int writeEmitted(const EmitArguments& arguments,
                 const std::expected<bridge::Emitted, bridge::Errors>& emitted) {
  if (!emitted) return reportErrors(emitted.error());
  if (const auto failed = disk::writeOutput(arguments.output, emitted->text)) return fail(*failed);
  reportNotes(emitted->notes);
  return kDone;
}

/// Whether one output overwrites the other, or follows it on standard output.
bool isSameOutput(const std::string& a, const std::string& b) {
  const auto place = [](const std::string& path) {
    return disk::DiskFileSystem().canonical(std::filesystem::absolute(path.empty() ? "-" : path));
  };
  return place(a) == place(b);
}

/// Writes a tree, and beside it what `import` has to know about its leaves.
int emitTree(const EmitArguments& arguments, const analysis::Program& program) {
  if (!arguments.leaves.empty() && isSameOutput(arguments.leaves, arguments.output))
    return fail("`--leaves` and `-o` must name two files");
  auto emitted = bridge::bt::emitTree(program, arguments.options.mainSkill);
  if (!emitted) return reportErrors(emitted.error());
  if (!arguments.leaves.empty())
    if (const auto failed = disk::writeOutput(arguments.leaves, emitted->leaves))
      return fail(*failed);
  return writeEmitted(arguments, std::move(emitted->tree));
}

int emitModel(const EmitArguments& arguments, const analysis::Program& program) {
  auto options = arguments.options;
  options.edition = edition(arguments);
  const auto model = codegen::generate(program, options);
  if (!model) {
    failGeneration(program, model.error());
    return kFailed;
  }
  const auto text = fiacre::print(model->fiacre, {.prove = arguments.prove});
  const auto failed = disk::writeOutput(arguments.output, text);
  return failed ? fail(*failed) : kDone;
}

int emitPddl(const EmitArguments& arguments, const analysis::Program& program,
             const std::string& name) {
  if (arguments.goal.empty())
    return writeEmitted(arguments, bridge::pddl::emitDomain(program, name, arguments.outcomes));
  const auto whole = loadGoal(arguments.file, arguments.goal, arguments.colour);
  if (!whole) return kFailed;
  auto emitted = bridge::pddl::emitProblem(whole->program, name, whole->goal(), 0);
  if (!emitted) return reportErrors(GoalProgram::inGoal(std::move(emitted.error())));
  return writeEmitted(arguments, emitted);
}

std::optional<Peer> peerOf(Target target) {
  if (target == Target::Promela) return Peer::Spin;
  if (target == Target::TChecker) return Peer::TChecker;
  return std::nullopt;
}

int runEmit(const EmitArguments& arguments) {
  if (disk::replaces(arguments.output, arguments.file))
    return fail("`-o` names the file that is read");
  const bool isPddl = arguments.target == Target::Pddl;
  if (!arguments.goal.empty() && !isPddl) return fail("`--goal` is for pddl");
  const bool isTree = arguments.target == Target::BehaviorTree;
  if (!arguments.leaves.empty() && !isTree) return fail("`--leaves` is for bt");
  if (const auto peer = peerOf(arguments.target)) {
    auto options = arguments.options;
    options.edition = edition(arguments);
    return writePeerModel(*peer, arguments.file, arguments.output, options, arguments.colour);
  }
  const auto program = loadChecked(arguments.file, arguments.colour);
  if (!program) return kFailed;
  if (arguments.target == Target::Hippo) return writeHippoProject(arguments, *program);
  const auto name = bridge::asName(std::filesystem::path(arguments.file).stem().string());
  if (isTree) return emitTree(arguments, *program);
  if (isPddl) return emitPddl(arguments, *program, name);
  if (arguments.target == Target::Skillset)
    return writeEmitted(arguments, bridge::rl::emitSkillset(*program, name));
  return emitModel(arguments, *program);
}

} // namespace

void addEmit(CLI::App& app, int& exitCode) {
  auto arguments = std::make_shared<EmitArguments>();
  auto* command =
      app.add_subcommand("emit", "Print a program as a Fiacre model, or in another language");
  addChoice<Target>(
      *command, "target", arguments->target,
      {{"fiacre", Target::Fiacre},
       {"tina", Target::Tina},
       {"hfiacre", Target::HFiacre},
       {"hippo", Target::Hippo},
       {"bt", Target::BehaviorTree},
       {"rl", Target::Skillset},
       {"pddl", Target::Pddl},
       {"promela", Target::Promela},
       {"tchecker", Target::TChecker}},
      "fiacre: a model to verify; tina: the same for frac and Tina; hfiacre: a model to execute; "
      "hippo: a directory with this model, and functions in C that perform its actions; bt: a "
      "behavior tree of BehaviorTree.CPP; rl: a skillset of the robot language; pddl: a planning "
      "domain, or with --goal a problem; promela: the model for Spin; tchecker: a timed automaton "
      "for TChecker")
      ->required();
  command
      ->add_option("file", arguments->file,
                   "Root file of the program; promela and tchecker: or a model in Fiacre (.fcr)")
      ->required();
  addMainSkill(*command, arguments->options.mainSkill);
  show(command->add_option("-o,--output", arguments->output,
                           "Write to this file instead of standard output; hippo: the directory"),
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
                        "hfiacre, hippo: ticks per second (default 100)")
           ->check(integerBetween(1, 1'000'000))
           ->excludes(expanded),
       group::kAdvanced, "HZ");
  show(command->add_option("--goal", arguments->goal,
                           "pddl: write the problem of making this condition true"),
       group::kOutput, "CONDITION");
  show(command->add_option("--leaves", arguments->leaves,
                           "bt: write the durations and results of the leaves to this file"),
       group::kOutput, "FILE");
  using bridge::pddl::Outcomes;
  addChoice<Outcomes>(*command, "--outcomes", arguments->outcomes,
                      {{"best", Outcomes::Best}, {"all", Outcomes::All}},
                      "pddl: best: skills succeed; all: a planner may choose failures, too",
                      group::kOutput);
  using codegen::StateVariableAutomata;
  addChoice<StateVariableAutomata>(
      *command, "--sv-automata", arguments->options.automata,
      {{"exact", StateVariableAutomata::Exact}, {"paper", StateVariableAutomata::Paper}},
      "exact: detect every forbidden move of a state variable; paper: poll, as the paper does",
      group::kAdvanced);
  showBelow(*command,
            {"proskill emit fiacre mission.proskill",
             "proskill emit bt --leaves leaves.json -o mission.xml mission.proskill",
             "proskill emit pddl --goal '(door Open)' mission.proskill",
             "proskill emit promela -o mission.pml mission.proskill",
             "proskill emit hfiacre --rate 50 -o mission.hfcr mission.proskill",
             "proskill emit hippo -o robot mission.proskill"},
            {{kDone, "the text was written"},
             {kFailed, "the program has errors, or the command line or the output is wrong"}});
  command->callback([arguments, &exitCode] { exitCode = runEmit(*arguments); });
}

} // namespace proskill::cli
