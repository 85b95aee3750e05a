#include "cli/commands/verify_arguments.h"

#include "cli/terminal/help.h"
#include "cli/terminal/number.h"
#include "cli/terminal/usage.h"
#include "verify/reduction_names.h"

#include <algorithm>
#include <csignal>
#include <iostream>

namespace proskill::cli {

namespace {

std::string reductionNames() {
  std::string names = "all|none";
  for (const auto& it : verify::kReductionNames) names += "|" + std::string(it.name);
  return names;
}

/// Replaces a former name, with a hint. \return an error message; empty if the name is known
std::string takeReduction(std::string& word) {
  if (word == "all" || word == "none") return "";
  for (const auto& it : verify::kReductionNames) {
    if (word == it.name) return "";
    if (it.formerName.empty() || word != it.formerName) continue;
    std::cerr << "hint: the reduction `" << it.formerName << "` is called `" << it.name
              << "` now; the next version takes only that\n";
    word = it.name;
    return "";
  }
  return notOneOf(word, CLI::detail::split(reductionNames(), '|'));
}

void addSubject(CLI::App& command, VerifyArguments& arguments) {
  show(command
           .add_option("--property", arguments.properties,
                       "Verify only this property, or all whose names begin with this word and "
                       "a dot; may be repeated")
           ->allow_extra_args(false), // the next word is the program
       group::kSubject, "PROPERTY");
  show(command.add_flag("--list", arguments.list, "List the names of the properties, and stop"),
       group::kSubject);
  show(command
           .add_option("--properties", arguments.added,
                       "Verify the properties of this file too: Fiacre, or one formula (.ltl)")
           ->allow_extra_args(false),
       group::kSubject, "FILE");
  show(command.add_option("--environment", arguments.environment,
                          "Replace the environment by the Fiacre process in this file"),
       group::kSubject, "FILE");
  addMainSkill(command, arguments.mainSkill);
}

void addOutput(CLI::App& command, VerifyArguments& arguments) {
  addChoice<VerifyFormat>(command, "--format", arguments.format,
                          {{"text", VerifyFormat::Text},
                           {"json", VerifyFormat::Json},
                           {"junit", VerifyFormat::JUnit},
                           {"sarif", VerifyFormat::Sarif}},
                          "How to print verdicts");
  addChoice<report::ShowTraces>(command, "--traces", arguments.traces,
                                {{"failed", report::ShowTraces::Failed},
                                 {"all", report::ShowTraces::All},
                                 {"none", report::ShowTraces::None}},
                                "Which traces to print: of failed properties, all, or none");
  show(command.add_option("--save-traces", arguments.saveTraces,
                          "Save every trace in this directory, as JSON and text"),
       group::kOutput, "DIRECTORY");
  show(command.add_option("--report", arguments.report,
                          "Write a web page with verdicts, traces and pictures to this directory"),
       group::kOutput, "DIRECTORY");
  show(command.add_option("--graph", arguments.graph,
                          "Write the state graph to this file (.aut or .txt), or print its size "
                          "(counts)"),
       group::kOutput, "FILE");
  addChoice<verify::GraphKind>(command, "--graph-of", arguments.graphOf,
                               {{"classes", verify::GraphKind::Classes},
                                {"markings", verify::GraphKind::Markings},
                                {"untimed", verify::GraphKind::Untimed}},
                               "States of that graph: state classes, markings, or markings "
                               "without time");
  show(command.add_flag("--durations", arguments.durations,
                        "Also print how long each skill takes at least and at most"),
       group::kOutput);
  show(command.add_flag("--explain-size", arguments.explainSize,
                        "Also explain which variables, clocks and processes multiply the states"),
       group::kOutput);
  show(command.add_flag("--strict", arguments.strict, "Exit with 1 for warnings too"),
       group::kOutput);
  addColour(command, arguments.colour);
}

void addLimits(CLI::App& command, VerifyArguments& arguments) {
  show(command
           .add_option("--time-limit", arguments.timeLimit,
                       "Time limit in seconds (default: none); properties not decided by then are "
                       "inconclusive")
           ->check(positiveSeconds()),
       group::kLimits, "SECONDS");
  auto* memory = show(command
                          .add_option("--memory-limit", arguments.memoryLimit,
                                      "Memory limit in MiB (default: none)")
                          ->check(integerBetween(1)),
                      group::kLimits, "MIB");
  show(command
           .add_option("--spill", arguments.spill,
                       "Keep the states of a search that needs more memory than its limit in this "
                       "directory; nothing is left there at the end")
           ->needs(memory),
       group::kLimits, "DIRECTORY");
  show(command
           .add_option("--class-limit", arguments.classLimit,
                       "Limit of explored state classes (default: none)")
           ->check(integerBetween(1)),
       group::kLimits, "NUMBER");
}

void addCheckpoint(CLI::App& command, CheckpointArguments& arguments) {
  auto* checkpoint = show(
      command.add_option("--checkpoint", arguments.file,
                         "Save the state of a long search in this file, and go on from there if "
                         "it exists; it is removed at the end"),
      group::kLimits, "FILE");
  show(command
           .add_option("--every", arguments.every,
                       "Seconds between two checkpoints (default 60); more if writing would take "
                       "over a tenth of the time")
           ->check(positiveSeconds())
           ->needs(checkpoint),
       group::kLimits, "SECONDS");
}

void addAdvanced(CLI::App& command, VerifyArguments& arguments) {
  show(command.add_option("--cache", arguments.cache,
                          "Keep verdicts in this directory, and use those that are kept there"),
       group::kAdvanced, "DIRECTORY");
  show(command
           .add_option("--jobs", arguments.jobs,
                       "Threads for a long search (default: one for each processor, at most 8); "
                       "results do not "
                       "depend on their number")
           ->check(integerBetween(1, 256)),
       group::kAdvanced, "NUMBER");
  show(command.add_flag("--mpi", arguments.mpi,
                        "Share a long search with the other processes that `mpirun` has started"),
       group::kAdvanced);
  show(command
           .add_option("--reduce", arguments.reduce,
                       "Reductions of the state space, separated by commas; verdicts do not depend "
                       "on them")
           ->delimiter(',')
           ->allow_extra_args(false)
           ->transform(CLI::Validator(takeReduction, "")),
       group::kAdvanced, reductionNames());
  addChoice<bool>(
      command, "--runs", arguments.fairRuns, {{"fair", true}, {"all", false}},
      "Which infinite runs count for your properties that do not say :fair. fair: time goes "
      "on, and actions without a time limit end; all: every run, as in Tina",
      group::kAdvanced);
  show(command.add_flag("--expanded", arguments.expanded,
                        "Verify the expanded model, with one state per step of a skill"),
       group::kAdvanced);
  using codegen::StateVariableAutomata;
  addChoice<StateVariableAutomata>(
      command, "--sv-automata", arguments.automata,
      {{"exact", StateVariableAutomata::Exact}, {"paper", StateVariableAutomata::Paper}},
      "exact: detect every forbidden move of a state variable; paper: poll, as the paper does",
      group::kAdvanced);
}

} // namespace

namespace {

/// Whether state classes are to be counted.
bool isCount(const VerifyArguments& arguments) {
  return arguments.graph == "counts" && arguments.graphOf == verify::GraphKind::Classes;
}

/// Why a search on disk cannot do what is asked; nothing if it can.
std::optional<std::string> problemWithSpill(const VerifyArguments& arguments) {
  if (arguments.backend.backend != Backend::Engine) return "`--spill` needs `--backend engine`";
  if (!arguments.checkpoint.file.empty()) return "`--spill` has no checkpoints";
  if (arguments.mpi) return "`--spill` is for one process, without `--mpi`";
  if (arguments.durations || arguments.explainSize)
    return "`--spill` is not for `--durations` and `--explain-size`, whose searches stay in memory";
  if (arguments.list || (!arguments.graph.empty() && !isCount(arguments)))
    return "`--spill` is for verifications and `--graph counts`, but for no other graphs";
  return std::nullopt;
}

} // namespace

std::optional<std::string> problemWithRanks(const VerifyArguments& arguments) {
  if (arguments.backend.backend != Backend::Engine) return "`--mpi` needs `--backend engine`";
  if (!arguments.checkpoint.file.empty()) return "`--mpi` has no checkpoints";
  if (arguments.list || (!arguments.graph.empty() && !isCount(arguments)))
    return "`--mpi` verifies properties, or counts classes with `--graph counts`";
  return std::nullopt;
}

std::expected<std::unique_ptr<cache::SpillDirectory>, std::string>
openSpill(const VerifyArguments& arguments) {
  if (auto problem = problemWithSpill(arguments)) return std::unexpected(std::move(*problem));
  std::signal(SIGXFSZ, SIG_IGN); // a file that may not grow is an error like a full disk
  return cache::SpillDirectory::open(arguments.spill);
}

std::set<verify::Reduction> chosenReductions(const std::vector<std::string>& names) {
  std::set<verify::Reduction> chosen;
  for (const auto& it : verify::kReductionNames)
    if (names.empty() || std::ranges::count(names, it.name) + std::ranges::count(names, "all") > 0)
      chosen.insert(it.reduction);
  return chosen;
}

void addVerifyOptions(CLI::App& command, VerifyArguments& arguments) {
  command.add_option("file", arguments.file, "Root file of the program, or a model (.fcr)")
      ->required();
  addSubject(command, arguments);
  addOutput(command, arguments);
  addLimits(command, arguments);
  addCheckpoint(command, arguments.checkpoint);
  addBackend(command, arguments.backend);
  addAdvanced(command, arguments);
}

} // namespace proskill::cli
