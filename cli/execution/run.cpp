#include "cli/execution/commands.h"

#include "cli/execution/default_recording.h"
#include "cli/execution/live_view.h"
#include "cli/execution/recording_format.h"
#include "cli/execution/run_arguments.h"
#include "cli/execution/service.h"
#include "cli/execution/stop_requests.h"
#include "cli/output/checked_program.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "disk/disk.h"
#include "disk/installation.h"
#include "groot/monitor.h"
#include "runtime/platform/process_file.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>
#include <unistd.h>

namespace proskill::cli {

namespace {

/// Passes on a run to several observers. In real time, output is flushed at once.
class Observers final : public runtime::Observer {
public:
  explicit Observers(bool atOnce) : flushes(atOnce) {}
  void add(std::unique_ptr<runtime::Observer> one) { all.push_back(std::move(one)); }
  /// Ends all.
  void clear() { all.clear(); }

  void onStep(const runtime::Machine& machine, verify::TransitionId step, runtime::Nanoseconds date,
              runtime::Nanoseconds lag) override {
    for (const auto& one : all) one->onStep(machine, step, date, lag);
    if (flushes) std::cout.flush();
  }
  void onRemark(const runtime::Remark& remark) override {
    for (const auto& one : all) one->onRemark(remark);
    if (flushes) std::cout.flush();
  }

private:
  bool flushes;
  std::vector<std::unique_ptr<runtime::Observer>> all;
};

struct Failed {
  int exitCode;
};

runtime::PlatformTools platformTools() {
  const auto folder = disk::folderOfProgram();
  return {.proskill = "/proc/self/exe",
          .ros1 = disk::pythonPackage(folder, "ros1"),
          .ros2 = disk::pythonPackage(folder, "ros2"),
          .dds = disk::ddsLibrary(folder)};
}

class Session {
public:
  /// \param named where the program names the platform; nothing if it does not
  Session(const RunArguments& given, const analysis::Program& of,
          std::optional<analysis::Location> named)
      : arguments(given), program(of), named(named) {}

  int run() {
    const auto text = read(arguments.platform, named);
    const auto scriptText = read(arguments.script);
    const auto platform = runtime::PlatformFile::parse(text.value_or("{}"));
    if (!platform) return failFile(arguments.platform, platform.error());
    return platform->kind == runtime::PlatformKind::Simulated
               ? runSimulated(platform->file, scriptText)
               : runOnProcess(*platform);
  }

private:
  /// \param place in the program that names the file, if there is one
  [[nodiscard]] std::optional<std::string>
  read(const std::string& path, std::optional<analysis::Location> place = {}) const {
    if (path.empty()) return std::nullopt;
    auto text = disk::DiskFileSystem().read(path);
    if (text) return *text;
    const auto why = "cannot read `" + path + "`: " + text.error();
    throw Failed{place ? failGeneration(program, {why, *place}) : fail(why)};
  }

  void makeExecutable(bool environment) {
    auto made = runtime::makeExecutable(program, arguments.mainSkill, environment);
    if (!made) throw Failed{failGeneration(program, made.error())};
    executable = std::move(*made);
  }

  /// Shows what is wrong with a file, each error at its place or at the skill that it is about.
  [[nodiscard]] int failFile(const std::string& path, const runtime::FileErrors& errors) const {
    for (const auto& [why, place, skill] : errors)
      if (skill.empty())
        fail(fmt::format("{}:{} {}", path, place ? place->text() + ":" : "", why));
      else
        std::ignore = failUnusable({why, skill}, path);
    return kFailed;
  }

  [[nodiscard]] std::optional<runtime::JsonFile>
  parsedScript(const std::optional<std::string>& text) const {
    if (!text) return std::nullopt;
    auto script = runtime::JsonFile::parse(*text);
    if (!script) throw Failed{failFile(arguments.script, script.error())};
    return std::move(*script);
  }

  int runSimulated(const runtime::JsonFile& file, const std::optional<std::string>& scriptText) {
    const auto script = parsedScript(scriptText);
    makeExecutable(!speaksForEnvironment(file) && !(script && speaksForEnvironment(*script)));
    auto settings = defaultSettings(*executable);
    if (const auto wrong = readSimulation(file, executable->model, settings); !wrong.empty())
      return failFile(arguments.platform, wrong);
    if (script)
      if (const auto wrong = readScript(*script, executable->model, settings); !wrong.empty())
        return failFile(arguments.script, wrong);
    const auto platform = simulatedPlatform(std::move(settings), arguments.seed + 1);
    isSimulation = true;
    return runOn(*platform, clockFactor(arguments.clock));
  }

  int runOnProcess(const runtime::PlatformFile& platform) {
    using runtime::PlatformKind;
    runtime::ProcessSettings settings;
    prepareForProcess(settings);
    const bool isRos = platform.kind == PlatformKind::Ros1 || platform.kind == PlatformKind::Ros2;
    if (isRos && arguments.clock != "real" && !arguments.clock.empty())
      return fail("`--clock` must be real: ROS takes real time");
    if (const auto wrong =
            readProcess(platform, program, executable->model, platformTools(), settings);
        !wrong.empty())
      return failFile(arguments.platform, wrong);
    return runOnProcess(std::move(settings));
  }

  /// A program needs real time.
  void prepareForProcess(runtime::ProcessSettings& settings) {
    if (!arguments.script.empty())
      throw Failed{fail(named ? "`--script` is for simulations: add `--no-platform`"
                              : "`--script` is for simulations")};
    if (arguments.clock == "simulated")
      throw Failed{fail("`--clock simulated` is for simulations: this platform takes real time")};
    makeExecutable(false);
    settings.speed = clockFactor(arguments.clock).value_or(1);
    settings.directory =
        std::filesystem::absolute(std::filesystem::path(arguments.platform)).parent_path();
  }

  int runOnProcess(runtime::ProcessSettings settings) {
    const auto factor = settings.speed;
    const auto place =
        arguments.platform + (settings.place ? ":" + settings.place->text() : std::string());
    const auto platform =
        processPlatform(*executable, std::move(settings), [] { return stopRequests() > 0; });
    if (platform) return runOn(**platform, factor);
    return failUnusable(platform.error(), place);
  }

  /// Shows the skill that a platform does not suit, or else the place.
  [[nodiscard]] int failUnusable(const runtime::Unusable& unusable,
                                 const std::string& place) const {
    const auto& [why, skill] = unusable;
    if (const auto* definition = program.skills.find(skill))
      return failGeneration(program, {why, {definition->file, definition->node().name.range}});
    return fail(place + ": " + why);
  }

  int runOn(runtime::Platform& platform, std::optional<double> factor) {
    const auto manager = ServiceManager::ofEnvironment();
    manager.tell("READY=1");
    auto clock = factor ? watchedClock(runtime::realClock(*factor), manager, *factor)
                        : runtime::simulatedClock();
    if (arguments.rate) clock = tickingClock(std::move(clock), runtime::kSecond / *arguments.rate);
    if (arguments.isRealtime) warnOfRealtime(factor.has_value());
    const auto exitCode = runShown(platform, std::move(clock), factor);
    manager.tell("STOPPING=1");
    return exitCode;
  }

  /// Five seconds of real time, which a process needs to end however fast or slow the clock is.
  static runtime::Nanoseconds endGrace(double factor) {
    return static_cast<runtime::Nanoseconds>(5 * runtime::kSecond * factor);
  }

  static void warnOfRealtime(bool isReal) {
    if (!isReal) throw Failed{fail("`--realtime` is for real clocks: see `--clock`")};
    if (const auto refused = becomeRealtime(); !refused.empty())
      std::cerr << "warning: `--realtime`: " << refused << '\n';
  }

  int runShown(runtime::Platform& platform, std::unique_ptr<runtime::Clock> clock,
               std::optional<double> factor) {
    if (arguments.groot.isOn) openMonitor(factor.has_value());
    if (isPausable()) clock = pausableClock(std::move(clock), pause);
    if (!arguments.view.isOn) return runOn(platform, *clock, factor);
    const auto shown = openView(factor);
    const auto controlled = withInbox(platform, shown->inbox, shown->waitsForPage());
    return runOn(*controlled, *clock, factor, shown.get());
  }

  /// Whether a page or a viewer may pause the run, or wakes it.
  [[nodiscard]] bool isPausable() const {
    return arguments.view.isOn || (arguments.groot.isOn && isSimulation);
  }

  /// A robot cannot be stopped in the middle of a movement, as a simulation can.
  [[nodiscard]] std::string whyNoPause() const {
    return isSimulation ? "" : "only simulations can be paused: the robot would go on";
  }

  [[nodiscard]] groot::Influence influence() {
    if (!isSimulation) return {.whyNot = whyNoPause()};
    if (arguments.isRealtime && !arguments.view.controls)
      return {.whyNot = "`--realtime`: viewers cannot pause the run without `--controls`"};
    return {.pause = &pause};
  }

  void openMonitor(bool isReal) {
    auto tree = groot::treeOf(program, *executable);
    if (!tree) throw Failed{fail("`--groot` is not possible: " + tree.error())};
    auto sockets = groot::Sockets::open(arguments.groot.port);
    if (!sockets) throw Failed{fail("`--groot` is not possible: " + sockets.error())};
    monitor = std::make_unique<groot::Monitor>(std::move(*tree), *executable, std::move(*sockets),
                                               !isReal, influence());
    std::cerr << "viewers of behavior trees can connect to port " << monitor->port() << std::endl;
  }

  [[nodiscard]] std::unique_ptr<LiveView> openView(std::optional<double> factor) {
    auto view = arguments.view;
    view.noControls = view.noControls || (arguments.isRealtime && !view.controls);
    auto shown = LiveView::open(view, {.program = program,
                                       .executable = *executable,
                                       .speed = factor,
                                       .whyNoPause = whyNoPause(),
                                       .pause = pause,
                                       .askToEnd = [] { askToStop(SIGINT); }});
    if (!shown) throw Failed{fail(shown.error())};
    return std::move(*shown);
  }

  int runOn(runtime::Platform& platform, runtime::Clock& clock, std::optional<double> factor,
            LiveView* shown = nullptr) {
    Observers observers(factor.has_value());
    const report::RunSubject subject{program, *executable};
    const bool colour = wantsColour(arguments.colour, STDOUT_FILENO);
    observers.add(arguments.format == RunFormat::Json
                      ? report::runJson(std::cout, subject)
                      : report::runText(std::cout, subject, colour));
    if (const auto file = fileToRecord(); !file.empty())
      addRecording(file, subject, factor ? record::RunTime::Real : record::RunTime::Simulated,
                   observers);
    if (shown) observers.add(shown->observer());
    if (monitor) observers.add(monitor->observer());
    runtime::RunOptions options{.seed = arguments.seed,
                                .until = arguments.until,
                                .endGrace = endGrace(factor.value_or(1)),
                                .stopRequests = &stopRequests(),
                                .stopDescriptor = stopDescriptor(),
                                .pause = isPausable() ? &pause : nullptr};
    if (!options.until && !factor)
      options.until = executable->mission == verify::kNone ? 60 * runtime::kSecond
                                                           : 24 * 3600 * runtime::kSecond;
    const auto result = execute(*executable, clock, platform, observers, options);
    observers.clear(); // completes the recording
    if (arguments.format == RunFormat::Json)
      report::writeRunSummaryJson(std::cout, subject, result);
    else
      report::writeRunSummary(std::cout, subject, result, colour);
    if (shown) shown->finish(result);
    if (shown)
      stay("at " + shown->url(), result);
    else if (monitor)
      stay("at port " + std::to_string(monitor->port()), result);
    const auto exitCode = exitCodeOf(result);
    return exitCode == kDone && lacksRecording ? kFailed : exitCode;
  }

  /// Shows the run until a request to end; the first one may have ended the run.
  static void stay(const std::string& place, const runtime::RunResult& result) {
    using runtime::End;
    std::cout.flush();
    const bool wasAsked = result.end == End::Stopped || result.end == End::Abandoned;
    if (isatty(STDERR_FILENO) != 0)
      std::cerr << "it is still shown " << place << "; Ctrl-C ends this\n";
    awaitStop(wasAsked ? 1 : 0);
  }

  /// A robot's run is recorded unless the user does not want it: it cannot be repeated. Empty: in
  /// no file.
  [[nodiscard]] std::string fileToRecord() const {
    if (!arguments.record.empty() || arguments.noRecord || isSimulation) return arguments.record;
    auto file = newRecording(recordingDirectory(), arguments.file);
    if (file)
      std::cerr << "the run is recorded in " << *file << std::endl;
    else
      std::cerr << "warning: the run is not recorded: " << file.error() << '\n';
    return file.value_or("");
  }

  void addRecording(const std::string& file, report::RunSubject subject, record::RunTime time,
                    Observers& observers) {
    auto format = recordingFormat(file, subject);
    if (!format) throw Failed{fail(format.error())};
    auto created = disk::GrowingFile::create(file);
    if (!created && !arguments.record.empty()) throw Failed{fail(created.error())};
    if (!created) return warnOfRecording(created.error() + "; the recording ends here");
    observers.add(std::make_unique<record::RunRecording>(
        std::move(*created), time, *format, [this](const auto& why) { warnOfRecording(why); }));
  }

  void warnOfRecording(const std::string& why) {
    std::cerr << "warning: " << why << '\n';
    lacksRecording = !arguments.record.empty();
  }

  static int exitCodeOf(const runtime::RunResult& result) {
    using runtime::End;
    if (result.bad > 0 || result.end == End::NoTime || result.end == End::Failed) return kFound;
    if (result.end == End::Mission) return result.missionStatus == "success" ? kDone : kFound;
    return result.missionStatus.empty() && result.end == End::Until ? kDone : kInconclusive;
  }

  const RunArguments& arguments;
  const analysis::Program& program;
  std::optional<analysis::Location> named;
  std::unique_ptr<const runtime::Executable> executable;
  bool isSimulation = false;
  bool lacksRecording = false; ///< the one that `--record` names is not complete
  runtime::Pause pause;
  std::unique_ptr<groot::Monitor> monitor; ///< the last member, since it uses the others
};

int runRun(const RunArguments& given) {
  const auto program = loadChecked(given.file, given.colour);
  if (!program) return kFailed;
  auto arguments = given;
  const auto named = takeNamedPlatform(arguments, *program);
  listenForStops();
  try {
    return Session(arguments, *program, named).run();
  } catch (const Failed& failed) {
    return failed.exitCode;
  }
}

} // namespace

void addRun(CLI::App& app, int& exitCode) {
  auto& command =
      addCommand<RunArguments>(app, "run", "Execute a program on a robot, or on a simulated one",
                               addRunOptions, runRun, exitCode);
  showBelow(
      command,
      {"proskill run mission.proskill", "proskill run --seed 7 --record run.json mission.proskill",
       "proskill run --clock 10x --script script.json mission.proskill"},
      {{kDone, "the mission succeeded, and nothing unexpected happened"},
       {kFound, "the mission did not succeed, or something happened that the program forbids"},
       {kFailed, "the command line, a file or the program is wrong; or the run succeeded, but its "
                 "`--record` is incomplete"},
       {kInconclusive, "the run ended before the mission did"}});
}

} // namespace proskill::cli
