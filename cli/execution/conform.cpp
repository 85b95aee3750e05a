#include "cli/execution/commands.h"

#include "cli/execution/learn.h"
#include "cli/output/checked_program.h"
#include "cli/terminal/choice.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "cli/terminal/number.h"
#include "cli/terminal/progress.h"
#include "disk/large_file.h"
#include "report/run/read_recording.h"
#include "report/verify_report.h"
#include "runtime/conform/conform.h"
#include "runtime/conform/durations.h"
#include "syntax/text/utf8.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <expected>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

namespace proskill::cli {

namespace {

struct ConformArguments {
  std::string recording;
  std::string file;
  double tolerance = 0;  ///< in seconds
  bool isEdited = false; ///< the program, since the recording
  bool learns = false;
  std::vector<std::string> more; ///< further recordings to learn from
  double timeLimit = 60;         ///< of the verifications, in seconds
  ColourChoice colour = ColourChoice::Auto;
};

std::string placeOf(const analysis::Program& program, const fiacre::Origin& what) {
  if (what.begin == what.end || what.file >= program.files.size()) return "";
  return report::place(program, {what.file, {what.begin, what.end}}) + ": ";
}

/// The step where a recording deviates, or its end.
std::string stepText(const analysis::Program& program, const runtime::ConformResult& result) {
  if (!result.at) return fmt::format("after step {}", result.step);
  const auto& step = *result.at;
  const auto date = static_cast<double>(step.date) / static_cast<double>(runtime::kSecond);
  return fmt::format("{}step {}, at {:.9g} s: `{}` {}", placeOf(program, step.what),
                     result.step + 1, date, step.what.actor, step.what.description);
}

int sayVerdict(const analysis::Program& program, const runtime::ConformResult& result) {
  using runtime::Conformance;
  if (result.verdict == Conformance::Conforms) {
    std::cout << fmt::format("the run conforms to the model: {} steps\n", result.step);
    return kDone;
  }
  std::cout << syntax::printable(stepText(program, result)) << '\n';
  std::cout << (result.verdict == Conformance::Unknown ? "this cannot be decided: "
                                                       : "no run of the model explains it: ")
            << result.why << '\n';
  if (result.isElsewhere)
    std::cout << "the program has been edited since: `--edited` ignores the places of steps\n";
  if (!result.assumption.empty()) std::cout << "broken assumption: " << result.assumption << '\n';
  return result.verdict == Conformance::Unknown ? kInconclusive : kFound;
}

/// Judges a recorded run while it is read, and may learn from it.
class Reading final : public runtime::RunSink {
public:
  /// \param to learns from the run, unless it is null
  Reading(runtime::RunJudge& by, runtime::DurationsOfRuns* to) : judge(by), durations(to) {}

  bool onHead(const runtime::RecordedHead& head) override {
    mainSkill = head.mainSkill;
    if (durations) (void)durations->onHead(head);
    return judge.onHead(head);
  }
  bool onStep(const runtime::RecordedStep& step) override {
    const bool isJudged = judge.onStep(step);
    return durations ? durations->onStep(step) : isJudged;
  }
  bool onCall(const runtime::RecordedCall& call) override {
    const bool isJudged = judge.onCall(call);
    return durations ? durations->onCall(call) : isJudged;
  }

  std::string mainSkill;

private:
  runtime::RunJudge& judge;
  runtime::DurationsOfRuns* durations;
};

/// \return an error message, or nothing
std::optional<std::string> readRun(const std::string& path, const analysis::Program& program,
                                   runtime::RunSink& to) {
  const auto file = disk::LargeFile::open(path);
  if (!file) return "cannot read `" + path + "`: " + file.error();
  ProgressLine progress;
  std::uint64_t shown = 0;
  const auto read = [&](std::uint64_t at, std::uint64_t bytes) {
    constexpr std::uint64_t kPart = std::uint64_t{64} << 20;
    if (at / kPart != std::exchange(shown, at / kPart))
      progress.say(
          fmt::format("reading `{}`: {} of {} MB", path, at / 1'000'000, file->size() / 1'000'000));
    return file->read(at, bytes);
  };
  const auto wrong = report::readRecording({file->size(), read}, program, to);
  if (!wrong) return std::nullopt;
  return "`" + path + "` cannot be judged: " + *wrong;
}

int runConform(const ConformArguments& arguments) {
  const auto program = loadChecked(arguments.file, arguments.colour);
  if (!program) return kFailed;
  const auto tolerance = std::llround(arguments.tolerance * static_cast<double>(runtime::kSecond));
  runtime::RunJudge judge(*program, {.tolerance = tolerance, .placesMatter = !arguments.isEdited});
  runtime::DurationsOfRuns durations(*program);
  Reading run(judge, arguments.learns ? &durations : nullptr);
  if (const auto wrong = readRun(arguments.recording, *program, run)) return fail(*wrong);
  const auto result = judge.result();
  if (!result) return failGeneration(*program, result.error());
  const auto exitCode = sayVerdict(*program, *result);
  if (!arguments.learns) return exitCode;
  for (const auto& path : arguments.more)
    if (const auto wrong = readRun(path, *program, durations)) return fail(*wrong);
  const auto end = learn(
      *program, arguments.file, durations.all(),
      {.mainSkill = run.mainSkill, .seconds = arguments.timeLimit, .colour = arguments.colour});
  return end == kDone ? exitCode : end;
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
           ->check(secondsFromZero()),
       group::kSubject, "SECONDS");
  show(command->add_flag("--edited", arguments->isEdited,
                         "Ignore where in the program steps are: it has been edited since the "
                         "recording"),
       group::kSubject);
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
  show(command
           ->add_option("--time-limit", arguments->timeLimit,
                        "With --learn: time limit of the verifications in seconds (default 60); "
                        "properties not decided by then are listed")
           ->needs(learns)
           ->check(positiveSeconds()),
       group::kLimits, "SECONDS");
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
