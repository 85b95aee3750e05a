#include "cli/commands/commands.h"
#include "cli/commands/generated.h"

#include "cache/verdict_cache.h"
#include "cli/commands/verify_arguments.h"
#include "cli/output/checked_program.h"
#include "cli/output/difference_report.h"
#include "cli/output/graph_file.h"
#include "cli/output/report.h"
#include "cli/output/save_traces.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "cli/terminal/number.h"
#include "cli/terminal/paint.h"
#include "cli/terminal/progress.h"
#include "disk/disk.h"
#include "disk/output.h"
#include "ide/snapshot/fiacre_file.h"
#include "ide/verdicts/model_additions.h"
#include "report/text/render.h"
#include "report/verify_report.h"
#include "syntax/text/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <memory>
#include <thread>
#include <unistd.h>

namespace proskill::cli {

namespace {

/// Set by the first Ctrl-C: the verdicts so far are then reported. The second Ctrl-C ends the
/// process.
std::atomic<bool> interrupted{false};

void onInterrupt(int signal) {
  interrupted = true;
  std::signal(signal, SIG_DFL);
}

double secondsSince(std::chrono::steady_clock::time_point moment) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - moment).count();
}

/// Each thread has caches of its own, so that very many would take much memory.
unsigned defaultJobs() {
  constexpr unsigned kMost = 8;
  return std::clamp(std::thread::hardware_concurrency(), 1U, kMost);
}

/// Whether this process helps another one to verify, which prints the results.
bool isAssistant(const VerifyArguments& arguments) {
  return arguments.ranks && arguments.ranks->isAssistant();
}

/// The time limit applies to the whole command.
verify::Options engineOptions(const VerifyArguments& arguments, ProgressLine* progress,
                              cache::CheckpointFile* checkpoint = nullptr) {
  verify::Options options;
  options.reductions = chosenReductions(arguments.reduce);
  if (arguments.timeLimit)
    options.limits.seconds = std::max(0.0, *arguments.timeLimit - secondsSince(arguments.begun));
  if (arguments.memoryLimit) options.limits.bytes = bytesOfMiB(*arguments.memoryLimit);
  options.limits.classes = arguments.classLimit;
  options.jobs = arguments.jobs.value_or(defaultJobs());
  options.cancelled = &interrupted;
  options.checkpoint = checkpoint;
  if (arguments.ranks) options.ranks = &arguments.ranks->connected();
  options.spill = arguments.spillDirectory;
  if (progress && !isAssistant(arguments))
    options.progress = progress->callback(timeOfCheckpoint(checkpoint));
  return options;
}

void write(const VerifyArguments& arguments, const report::VerifyReport& report) {
  switch (arguments.format) {
  case VerifyFormat::Text:
    return writeText(std::cout, report, wantsColour(arguments.colour, STDOUT_FILENO));
  case VerifyFormat::Json: return writeJson(std::cout, report);
  case VerifyFormat::JUnit: return writeJUnit(std::cout, report);
  case VerifyFormat::Sarif: return writeSarif(std::cout, report);
  }
}

int exitCodeOf(const ide::VerificationReport& report, bool strict) {
  auto violated = [&](const ide::VerdictRow& row) {
    return row.bad() && (strict || row.check->weight == codegen::Weight::Error);
  };
  auto open = [](const ide::VerdictRow& row) { return row.verdict == ide::Verdict::Inconclusive; };
  if (std::ranges::any_of(report.rows, violated)) return kFound;
  return std::ranges::any_of(report.rows, open) ? kInconclusive : kDone;
}

/// The first name that selects no property, which is an error.
std::optional<std::string> unknownName(const codegen::Model& model,
                                       const std::vector<std::string>& names) {
  for (const auto& name : names)
    if (std::ranges::none_of(model.checks,
                             [&](const auto& check) { return ide::selects({name}, check); }))
      return name;
  return std::nullopt;
}

/// Measures how long skills take, within what is left of the time limit.
std::vector<ide::SkillDuration> durationsOf(const VerifyArguments& arguments,
                                            const codegen::Model& model) {
  if (!arguments.durations) return {};
  const auto asked = ide::askForDurations(model);
  ProgressLine progress;
  auto options = engineOptions(arguments, &progress);
  const auto known = cache::cacheFor(arguments.cache, asked.model);
  options.answers = known.get();
  return ide::measureDurations(asked, options);
}

/// Prints and saves a finished report. \return the exit code
int deliver(const VerifyArguments& arguments, const report::VerifyReport& report) {
  report::VerifyReport printed = report;
  printed.traces = arguments.traces;
  write(arguments, printed);
  if (!arguments.saveTraces.empty())
    if (auto error = saveTraces(arguments.saveTraces, report)) return fail(*error);
  if (!arguments.report.empty())
    if (auto error = writeReport(arguments.report, report)) return fail(*error);
  std::cout.flush();
  if (!std::cout) return fail("the report could not be written to standard output");
  return exitCodeOf(report.result, arguments.strict);
}

/// Directories of traces and reports of differences contain all traces.
ide::WantedTraces wantedTraces(const VerifyArguments& arguments) {
  if (!arguments.saveTraces.empty() || arguments.backend.backend != Backend::Engine)
    return ide::kAllTraces;
  if (!arguments.report.empty() && arguments.traces != report::ShowTraces::All)
    return ide::kTracesOfPage;
  switch (arguments.traces) {
  case report::ShowTraces::Failed: return ide::kFindings;
  case report::ShowTraces::All: return ide::kAllTraces;
  case report::ShowTraces::None: return ide::kNoTraces;
  }
  std::unreachable();
}

std::expected<ide::VerificationReport, verify::Unsupported>
askEngine(const VerifyArguments& arguments, const analysis::Program& program,
          const codegen::Model& model, cache::CheckpointFile* checkpoint = nullptr) {
  ProgressLine progress;
  auto options = engineOptions(arguments, &progress, checkpoint);
  const auto known = cache::cacheFor(arguments.cache, model);
  options.answers = known.get();
  auto report = ide::verifyModel(model, arguments.properties, options, {}, wantedTraces(arguments));
  if (report) ide::noteOriginals(program, *report);
  if (!known) return report;
  if (const auto problem = known->save())
    std::cerr << "warning: verdicts are not kept: " << syntax::printable(*problem) << '\n';
  return report;
}

int verifyByTina(const VerifyArguments& arguments, const analysis::Program& program,
                 const codegen::Model& model) {
  auto run =
      runTina(arguments.backend, model, arguments.properties, engineOptions(arguments, nullptr));
  if (!run) return fail(run.error());
  if (!run->said) return fail(tina::explain(run->said.error()));
  ide::noteOriginals(program, run->said->report);
  return deliver(arguments, {program, model, run->said->report, model.mainSkill, "tina"});
}

/// Verifies with both. The report has the engine's verdicts; a difference from Tina's is a bug in
/// one of them.
int verifyByBoth(const VerifyArguments& arguments, const analysis::Program& program,
                 const codegen::Model& model) {
  const auto options = engineOptions(arguments, nullptr);
  const auto run = runTina(arguments.backend, model, arguments.properties, options);
  if (!run) return fail(run.error());
  const auto engine = askEngine(arguments, program, model);
  if (!engine) return failUnsupported(engine.error());
  const report::VerifyReport report{program, model, *engine, model.mainSkill, "both"};
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
  if (auto problem = disk::writeOutput(file, differenceReport(report, *run, differences)))
    return fail(*problem);
  if (!run->said) fail(tina::explain(run->said.error()));
  std::cerr << fmt::format("the engine and Tina differ: {}; a bug report is in {}\n",
                           namesOf(differences), syntax::printable(file.string()));
  return kDiffer;
}

/// Saves the state of the search also when a terminal is closed, or the machine shuts down.
void noticeEndings() {
  std::signal(SIGTERM, onInterrupt);
  std::signal(SIGHUP, onInterrupt);
}

/// The file for the state of a search of this kind; see openCheckpoint().
std::expected<std::unique_ptr<cache::CheckpointFile>, std::string>
checkpointOf(const std::string& kind, const VerifyArguments& arguments, const codegen::Model& model,
             const std::vector<verify::Question>& questions) {
  if (arguments.checkpoint.file.empty()) return nullptr;
  if (disk::replaces(arguments.checkpoint.file, arguments.file))
    return std::unexpected("`--checkpoint` names the file that is read");
  noticeEndings();
  return openCheckpoint(
      arguments.checkpoint,
      cache::checkpointKey(kind, model, questions, engineOptions(arguments, nullptr)));
}

/// Whether all ranks verify the same.
bool isAgreed(const std::string& kind, const VerifyArguments& arguments,
              const codegen::Model& model, const std::vector<verify::Question>& questions) {
  if (!arguments.ranks) return true;
  const auto key = cache::checkpointKey(kind, model, questions, engineOptions(arguments, nullptr));
  const auto problem = arguments.ranks->disagreement(
      fmt::format("{} {} {} {}", key.build, key.model, key.questions, key.settings));
  if (problem && !isAssistant(arguments)) fail(*problem);
  return !problem;
}

int verifyProperties(const VerifyArguments& arguments, const analysis::Program& program,
                     const codegen::Model& model) {
  if (auto unknown = unknownName(model, arguments.properties))
    return fail(fmt::format("no property is called `{}`; `--list` shows their names", *unknown));
  std::signal(SIGINT, onInterrupt);
  if (arguments.backend.backend != Backend::Engine) {
    noticeEndings(); // to remove temporary files
    return arguments.backend.backend == Backend::Tina ? verifyByTina(arguments, program, model)
                                                      : verifyByBoth(arguments, program, model);
  }
  const auto checkpoint =
      checkpointOf("verify", arguments, model, ide::askedOf(model, arguments.properties).questions);
  if (!checkpoint) return fail(checkpoint.error());
  if (!isAgreed("verify", arguments, model, ide::askedOf(model, arguments.properties).questions))
    return kFailed;
  const auto result = askEngine(arguments, program, model, checkpoint->get());
  if (isAssistant(arguments)) return kDone;
  if (!result) return failUnsupported(result.error());
  report::VerifyReport report{program, model, *result, model.mainSkill};
  report.durations = durationsOf(arguments, model);
  if (arguments.explainSize) {
    auto size =
        ide::explainSize(program, model, arguments.properties, engineOptions(arguments, nullptr));
    if (size) report.size = std::move(*size);
  }
  const int code = deliver(arguments, report);
  if (code != kFailed) closeCheckpoint(checkpoint->get());
  return code;
}

/// Counts or writes the state graph.
int exploreStateGraph(const VerifyArguments& arguments, const codegen::Model& model) {
  std::signal(SIGINT, onInterrupt);
  const bool isCount =
      arguments.graph == "counts" && arguments.graphOf == verify::GraphKind::Classes;
  if (!isCount && !arguments.checkpoint.file.empty())
    return fail("`--checkpoint` saves verifications and `--graph counts`, but no other graphs");
  const auto checkpoint = checkpointOf("classes", arguments, model, {});
  if (!checkpoint) return fail(checkpoint.error());
  if (!isAgreed("classes", arguments, model, {})) return kFailed;
  if (isAssistant(arguments)) {
    (void)verify::countClasses(model.fiacre, engineOptions(arguments, nullptr));
    return kDone;
  }
  int code = kDone;
  {
    ProgressLine progress;
    code = exploreGraph(arguments.graph, arguments.graphOf, model,
                        engineOptions(arguments, &progress, checkpoint->get()));
  }
  std::fflush(stdout);
  if (code != kFailed) closeCheckpoint(checkpoint->get());
  return code;
}

int runModel(const VerifyArguments& arguments, const analysis::Program& program,
             const codegen::Model& model) {
  if (arguments.list) {
    for (const auto& check : model.checks) fmt::print("{}\n", check.name);
    return kDone;
  }
  if (!arguments.graph.empty()) return exploreStateGraph(arguments, model);
  return verifyProperties(arguments, program, model);
}

/// Reads an addition to a model. \return whether it is valid; errors were printed
template <class Add>
bool add(const VerifyArguments& arguments, const std::string& file, analysis::Program& program,
         codegen::Model& model, Add addTo) {
  auto text = disk::DiskFileSystem().read(file);
  if (!text) {
    fail(fmt::format("cannot read `{}`: {}", file, text.error()));
    return false;
  }
  const auto diagnostics = addTo(model, program, file, std::move(*text));
  render(std::cerr, program, diagnostics,
         report::Paint{wantsColour(arguments.colour, STDERR_FILENO)});
  return diagnostics.empty();
}

bool addAll(const VerifyArguments& arguments, analysis::Program& program, codegen::Model& model) {
  if (!arguments.environment.empty() &&
      !add(arguments, arguments.environment, program, model, ide::replaceEnvironment))
    return false;
  return std::ranges::all_of(arguments.added, [&](const std::string& file) {
    return add(arguments, file, program, model, ide::addProperties);
  });
}

/// Verifies a Fiacre model.
int runFiacre(const VerifyArguments& arguments) {
  auto text = disk::DiskFileSystem().read(arguments.file);
  if (!text) return fail(fmt::format("cannot read `{}`: {}", arguments.file, text.error()));
  if (!arguments.environment.empty())
    return fail("a model in Fiacre has its environment: `--environment` is for programs");
  auto read = ide::readFiacre(arguments.file, std::move(*text));
  render(std::cerr, read.program, read.diagnostics,
         report::Paint{wantsColour(arguments.colour, STDERR_FILENO)});
  if (read.hasErrors()) return kFailed;
  if (!read.isModel())
    return fail(fmt::format("`{}` names no model: write the name of a component at its end",
                            arguments.file));
  if (!addAll(arguments, read.program, read.model)) return kFailed;
  if (read.model.checks.empty() && arguments.graph.empty())
    return fail("nothing is asserted: write `property p is deadlockfree` and `assert p`");
  return runModel(arguments, read.program, read.model);
}

int verifyFile(const VerifyArguments& arguments) {
  if (!arguments.checkpoint.file.empty() && arguments.backend.backend != Backend::Engine)
    return fail("`--checkpoint` needs `--backend engine`");
  if (ide::isFiacre(arguments.file)) return runFiacre(arguments);
  auto made = generated(arguments);
  if (!made) return made.error();
  if (!addAll(arguments, made->program, made->model)) return kFailed;
  return runModel(arguments, made->program, made->model);
}

int verifyWithSpill(VerifyArguments arguments) {
  const auto directory = openSpill(arguments);
  if (!directory) return fail(directory.error());
  arguments.spillDirectory = directory->get();
  return verifyFile(arguments);
}

int runVerify(const VerifyArguments& arguments) {
  if (!arguments.spill.empty()) return verifyWithSpill(arguments);
  if (!arguments.mpi) return verifyFile(arguments);
  if (const auto problem = problemWithRanks(arguments)) return fail(*problem);
  const auto ranks = VerifyRanks::open();
  if (!ranks) return fail(ranks.error());
  noticeEndings();
  VerifyArguments own = arguments;
  own.ranks = ranks->get();
  if (own.ranks->isAssistant()) own.cache.clear();
  return verifyFile(own);
}

} // namespace

void addVerify(CLI::App& app, int& exitCode) {
  auto& command = addCommand<VerifyArguments>(app, "verify", "Verify the properties of a program",
                                              addVerifyOptions, runVerify, exitCode);
  showBelow(command,
            {"proskill verify mission.proskill",
             "proskill verify --property land --time-limit 60 mission.proskill",
             "proskill verify --format junit mission.proskill > report.xml"},
            {{kDone, "all properties are as they should be"},
             {kFound, "a property is violated (with --strict: or a warning)"},
             {kFailed, "the program has errors, the command line is wrong, or Tina cannot be run"},
             {kInconclusive, "nothing is violated, but a limit left properties undecided"},
             {kDiffer, "with --backend both: the engine and Tina disagree"}});
}

} // namespace proskill::cli
