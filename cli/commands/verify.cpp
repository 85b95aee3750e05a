#include "cli/commands/verify.h"

#include "cli/output/checked_program.h"
#include "cli/output/difference_report.h"
#include "cli/output/graph_file.h"
#include "cli/output/report.h"
#include "cli/output/save_traces.h"
#include "cli/output/tina_backend.h"
#include "cli/terminal/choice.h"
#include "cli/terminal/error.h"
#include "cli/terminal/help.h"
#include "cli/terminal/paint.h"
#include "cli/terminal/progress.h"
#include "disk/disk.h"
#include "disk/output.h"
#include "ide/snapshot/fiacre_file.h"
#include "ide/verdicts/model_additions.h"
#include "report/render.h"
#include "report/verify_report.h"
#include "syntax/text/utf8.h"
#include "verify/reduction_names.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <memory>
#include <unistd.h>

namespace proskill::cli {

namespace {

enum ExitCode { kGood = 0, kViolated = 1, kUsage = 2, kInconclusive = 3, kDiffer = 4 };

enum class Format : std::uint8_t { Text, Json, JUnit, Sarif };

struct Arguments {
  std::string file;
  std::string environment;
  std::vector<std::string> added;
  std::vector<std::string> properties;
  std::string mainSkill;
  Format format = Format::Text;
  ShowTraces traces = ShowTraces::Failed;
  ColourChoice colour = ColourChoice::Auto;
  unsigned jobs = 1;
  std::optional<double> timeLimit;
  std::optional<std::uint64_t> memoryLimit; // MiB
  std::optional<std::uint64_t> classLimit;
  std::string saveTraces;
  std::string report;
  std::vector<std::string> reduce;
  std::string graph;
  verify::GraphKind graphOf = verify::GraphKind::Classes;
  BackendArguments backend;
  bool strict = false;
  bool expanded = false;
  codegen::StateVariableAutomata automata = codegen::StateVariableAutomata::Exact;
};

/// Set by the first Ctrl-C: what is decided is then reported. The second one kills as usual.
std::atomic<bool> interrupted{false};

void onInterrupt(int signal) {
  interrupted = true;
  std::signal(signal, SIG_DFL);
}

std::string reductionNames() {
  std::string names = "all|none";
  for (const auto& it : verify::kReductionNames) names += "|" + std::string(it.name);
  return names;
}

/// A former name becomes today's, with a hint. The error is empty where a name is known.
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
  return "`" + word + "` is none of " + reductionNames();
}

std::set<verify::Reduction> reductions(const std::vector<std::string>& names) {
  std::set<verify::Reduction> chosen;
  for (const auto& it : verify::kReductionNames)
    if (names.empty() || std::ranges::count(names, it.name) + std::ranges::count(names, "all") > 0)
      chosen.insert(it.reduction);
  return chosen;
}

verify::Options engineOptions(const Arguments& arguments, ProgressLine* progress) {
  verify::Options options;
  options.reductions = reductions(arguments.reduce);
  options.limits.seconds = arguments.timeLimit;
  if (arguments.memoryLimit) options.limits.bytes = *arguments.memoryLimit * 1024 * 1024;
  options.limits.classes = arguments.classLimit;
  options.jobs = arguments.jobs;
  options.cancelled = &interrupted;
  if (progress) options.progress = progress->callback();
  return options;
}

int failUnsupported(const verify::Unsupported& error) {
  return fail("this model cannot be explored: " + error.message);
}

void write(const Arguments& arguments, const VerifyReport& report) {
  switch (arguments.format) {
  case Format::Text:
    return writeText(std::cout, report,
                     {wantsColour(arguments.colour, STDOUT_FILENO), arguments.traces});
  case Format::Json: return writeJson(std::cout, report);
  case Format::JUnit: return writeJUnit(std::cout, report);
  case Format::Sarif: return writeSarif(std::cout, report);
  }
}

int exitCodeOf(const ide::VerificationReport& report, bool strict) {
  auto violated = [&](const ide::VerdictRow& row) {
    return row.bad() && (strict || row.check->weight == codegen::Weight::Error);
  };
  auto open = [](const ide::VerdictRow& row) { return row.verdict == ide::Verdict::Inconclusive; };
  if (std::ranges::any_of(report.rows, violated)) return kViolated;
  return std::ranges::any_of(report.rows, open) ? kInconclusive : kGood;
}

/// A name that selects nothing is a mistake of the caller's, not a good verdict.
std::optional<std::string> unknownName(const codegen::Model& model,
                                       const std::vector<std::string>& names) {
  for (const auto& name : names)
    if (std::ranges::none_of(model.checks,
                             [&](const auto& check) { return ide::selects({name}, check); }))
      return name;
  return std::nullopt;
}

/// Prints and saves a finished report. Returns the exit code.
int deliver(const Arguments& arguments, const VerifyReport& report) {
  write(arguments, report);
  if (!arguments.saveTraces.empty())
    if (auto error = saveTraces(arguments.saveTraces, report)) return fail(*error);
  if (!arguments.report.empty())
    if (auto error = writeReport(arguments.report, report)) return fail(*error);
  std::cout.flush();
  if (!std::cout) return fail("the report could not be written to standard output");
  return exitCodeOf(report.result, arguments.strict);
}

std::expected<ide::VerificationReport, verify::Unsupported> askEngine(const Arguments& arguments,
                                                                      const codegen::Model& model) {
  ProgressLine progress;
  return ide::verifyModel(model, arguments.properties, engineOptions(arguments, &progress));
}

int verifyByTina(const Arguments& arguments, const analysis::Program& program,
                 const codegen::Model& model) {
  const auto run =
      runTina(arguments.backend, model, arguments.properties, engineOptions(arguments, nullptr));
  if (!run) return fail(run.error());
  if (!run->said) return fail(tina::explain(run->said.error()));
  return deliver(arguments, {program, model, run->said->report, model.mainSkill, "tina"});
}

/// What the engine says is the report; what Tina says beside it is a bug of one of them.
int verifyByBoth(const Arguments& arguments, const analysis::Program& program,
                 const codegen::Model& model) {
  const auto options = engineOptions(arguments, nullptr);
  const auto run = runTina(arguments.backend, model, arguments.properties, options);
  if (!run) return fail(run.error());
  const auto engine = askEngine(arguments, model);
  if (!engine) return failUnsupported(engine.error());
  const VerifyReport report{program, model, *engine, model.mainSkill, "both"};
  const int code = deliver(arguments, report);
  std::vector<Difference> differences;
  if (run->said)
    differences = differencesBetween(*engine, run->said->report);
  else
    differences.push_back({"", "can be explored", run->said.error().message});
  if (differences.empty()) {
    std::cerr << agreement(*engine, run->said->report) << '\n';
    return code;
  }
  const auto file = unusedName(arguments.backend.difference);
  if (auto problem = writeOutput(file, differenceReport(report, *run, differences)))
    return fail(*problem);
  if (!run->said) fail(tina::explain(run->said.error()));
  std::cerr << fmt::format("the engine and Tina differ: {}; a bug report is in {}\n",
                           namesOf(differences), syntax::printable(file.string()));
  return kDiffer;
}

int verifyProperties(const Arguments& arguments, const analysis::Program& program,
                     const codegen::Model& model) {
  if (auto unknown = unknownName(model, arguments.properties))
    return fail(fmt::format("no property is called `{}`; `--list` shows their names", *unknown));
  std::signal(SIGINT, onInterrupt);
  if (arguments.backend.backend != Backend::Engine) {
    std::signal(SIGTERM, onInterrupt); // so that no files are left behind
    std::signal(SIGHUP, onInterrupt);
    return arguments.backend.backend == Backend::Tina ? verifyByTina(arguments, program, model)
                                                      : verifyByBoth(arguments, program, model);
  }
  const auto result = askEngine(arguments, model);
  if (!result) return failUnsupported(result.error());
  return deliver(arguments, {program, model, *result, model.mainSkill});
}

int runModel(const Arguments& arguments, bool list, const analysis::Program& program,
             const codegen::Model& model) {
  if (list) {
    for (const auto& check : model.checks) fmt::print("{}\n", check.name);
    return kGood;
  }
  if (!arguments.graph.empty()) {
    std::signal(SIGINT, onInterrupt);
    ProgressLine progress;
    return exploreGraph(arguments.graph, arguments.graphOf, model,
                        engineOptions(arguments, &progress));
  }
  return verifyProperties(arguments, program, model);
}

/// Reads what a user adds to a model. \return it is all right; else that was said
template <class Add>
bool add(const Arguments& arguments, const std::string& file, analysis::Program& program,
         codegen::Model& model, Add addTo) {
  auto text = DiskFileSystem().read(file);
  if (!text) {
    fail(fmt::format("cannot read `{}`: {}", file, text.error()));
    return false;
  }
  const auto diagnostics = addTo(model, program, file, std::move(*text));
  render(std::cerr, program, diagnostics, Paint{wantsColour(arguments.colour, STDERR_FILENO)});
  return diagnostics.empty();
}

bool addAll(const Arguments& arguments, analysis::Program& program, codegen::Model& model) {
  if (!arguments.environment.empty() &&
      !add(arguments, arguments.environment, program, model, ide::replaceEnvironment))
    return false;
  return std::ranges::all_of(arguments.added, [&](const std::string& file) {
    return add(arguments, file, program, model, ide::addProperties);
  });
}

/// A model that was written by hand.
int runFiacre(const Arguments& arguments, bool list) {
  auto text = DiskFileSystem().read(arguments.file);
  if (!text) return fail(fmt::format("cannot read `{}`: {}", arguments.file, text.error()));
  if (!arguments.environment.empty())
    return fail("a model in Fiacre has its environment: `--environment` is for programs");
  auto read = ide::readFiacre(arguments.file, std::move(*text));
  render(std::cerr, read.program, read.diagnostics,
         Paint{wantsColour(arguments.colour, STDERR_FILENO)});
  if (!read.diagnostics.empty()) return kUsage;
  if (!read.isModel())
    return fail(fmt::format("`{}` names no model: write the name of a component at its end",
                            arguments.file));
  if (!addAll(arguments, read.program, read.model)) return kUsage;
  if (read.model.checks.empty() && arguments.graph.empty())
    return fail("nothing is asserted: write `property p is deadlockfree` and `assert p`");
  return runModel(arguments, list, read.program, read.model);
}

/// What goes to frac has to mean the same to it: see docs/semantics.md.
codegen::Edition editionFor(const Arguments& arguments) {
  if (arguments.backend.backend != Backend::Engine) return codegen::Edition::Tina;
  return arguments.expanded ? codegen::Edition::Expanded : codegen::Edition::Compact;
}

int run(const Arguments& arguments, bool list) {
  if (ide::isFiacre(arguments.file)) return runFiacre(arguments, list);
  auto program = loadChecked(arguments.file, arguments.colour);
  if (!program) return kUsage;
  codegen::Options options;
  options.mainSkill = arguments.mainSkill;
  options.edition = editionFor(arguments);
  options.automata = arguments.automata;
  auto model = codegen::generate(*program, options);
  if (!model) return failGeneration(*program, model.error());
  if (!addAll(arguments, *program, *model)) return kUsage;
  return runModel(arguments, list, *program, *model);
}

void addSubject(CLI::App& command, Arguments& arguments, bool& list) {
  show(command.add_option("--property", arguments.properties,
                          "Verify only this property, or all whose names begin with this word and "
                          "a dot; may be repeated"),
       group::kSubject, "PROPERTY");
  show(command.add_flag("--list", list, "List the names of the properties, and stop"),
       group::kSubject);
  show(command.add_option("--properties", arguments.added,
                          "Verify the properties of this file too: Fiacre, or one formula (.ltl)"),
       group::kSubject, "FILE");
  show(command.add_option("--environment", arguments.environment,
                          "Replace the environment by the Fiacre process in this file"),
       group::kSubject, "FILE");
  show(command.add_option("--main", arguments.mainSkill,
                          "The skill that is the mission, where several could be"),
       group::kSubject, "SKILL");
}

void addOutput(CLI::App& command, Arguments& arguments) {
  addChoice<Format>(command, "--format", arguments.format,
                    {{"text", Format::Text},
                     {"json", Format::Json},
                     {"junit", Format::JUnit},
                     {"sarif", Format::Sarif}},
                    "How to print verdicts");
  addChoice<ShowTraces>(
      command, "--traces", arguments.traces,
      {{"failed", ShowTraces::Failed}, {"all", ShowTraces::All}, {"none", ShowTraces::None}},
      "Which traces to print as text: of failed properties, all, or none");
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
  show(command.add_flag("--strict", arguments.strict, "Exit with 1 for warnings too"),
       group::kOutput);
  addColour(command, arguments.colour);
}

void addLimits(CLI::App& command, Arguments& arguments) {
  show(command
           .add_option("--time-limit", arguments.timeLimit,
                       "Time limit in seconds; properties not decided by then are inconclusive")
           ->check(positiveSeconds()),
       group::kLimits, "SECONDS");
  show(command.add_option("--memory-limit", arguments.memoryLimit, "Memory limit in MiB")
           ->check(CLI::PositiveNumber),
       group::kLimits, "MIB");
  show(command.add_option("--class-limit", arguments.classLimit, "Limit of explored state classes")
           ->check(CLI::PositiveNumber),
       group::kLimits, "NUMBER");
}

void addAdvanced(CLI::App& command, Arguments& arguments) {
  show(command
           .add_option("--jobs", arguments.jobs, "Threads to explore with; this version uses one")
           ->check(CLI::Range(1U, 256U)),
       group::kAdvanced, "NUMBER");
  show(command
           .add_option("--reduce", arguments.reduce,
                       "Reductions of the state space, separated by commas; verdicts do not depend "
                       "on them")
           ->delimiter(',')
           ->transform(CLI::Validator(takeReduction, "")),
       group::kAdvanced, reductionNames());
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

void addVerify(CLI::App& app, int& exitCode) {
  auto arguments = std::make_shared<Arguments>();
  auto list = std::make_shared<bool>(false);
  auto* command = app.add_subcommand("verify", "Verify the properties of a program");
  command->add_option("file", arguments->file, "Root file of the program, or a model (.fcr)")
      ->required();
  addSubject(*command, *arguments, *list);
  addOutput(*command, *arguments);
  addLimits(*command, *arguments);
  addBackend(*command, arguments->backend);
  addAdvanced(*command, *arguments);
  showBelow(*command,
            {"proskill verify mission.proskill",
             "proskill verify --property land --time-limit 60 mission.proskill",
             "proskill verify --format junit mission.proskill > report.xml"},
            {{kGood, "all properties are as they should be"},
             {kViolated, "a property is violated (with --strict: or a warning)"},
             {kUsage, "the program has errors, the command line is wrong, or Tina cannot be run"},
             {kInconclusive, "nothing is violated, but a limit left properties undecided"},
             {kDiffer, "with --backend both: the engine and Tina disagree"}});
  command->callback([arguments, list, &exitCode] { exitCode = run(*arguments, *list); });
}

} // namespace proskill::cli
