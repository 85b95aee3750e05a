#include "embed/executor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <poll.h>

using namespace proskill;
using embed::Done;
using embed::failed;
using embed::Failure;
using runtime::Execution;
using runtime::Progress;

namespace {

Failure notExecutable(const analysis::Program& program, const runtime::NotExecutable& error) {
  return {PROSKILL_INVALID_PROGRAM, embed::errorAt(program, error.location, error.message)};
}

} // namespace

std::expected<std::unique_ptr<proskill_executor>, Failure>
proskill_executor::make(const proskill_program& of, const proskill_options* given) {
  const auto options = embed::completed(given);
  if (!options) return std::unexpected(options.error());
  const auto settings = settingsOf(*options);
  if (!settings) return std::unexpected(settings.error());
  auto named = embed::NamedPlatform::read(*of.program, *options);
  if (!named) return std::unexpected(std::move(named.error()));
  if (*named)
    if (auto done = (*named)->suits(settings->isReal, settings->speed); !done)
      return std::unexpected(std::move(done.error()));
  auto executable =
      runtime::makeExecutable(*of.program, options->main_skill ? options->main_skill : "",
                              options->environment || (*named && (*named)->needsEnvironment()));
  if (!executable) return std::unexpected(notExecutable(*of.program, executable.error()));
  return std::unique_ptr<proskill_executor>(
      new proskill_executor(of.program, std::move(*executable), *settings, std::move(*named)));
}

proskill_executor::proskill_executor(std::shared_ptr<const analysis::Program> of,
                                     std::unique_ptr<const runtime::Executable> made,
                                     const Settings& with,
                                     std::optional<embed::NamedPlatform> others)
    : program(std::move(of)),
      executable(std::move(made)),
      settings(with),
      clock(with.isReal ? runtime::realClock(with.speed) : runtime::simulatedClock()),
      platform(std::make_unique<embed::FunctionPlatform>(*executable, *clock, this)),
      shared(*platform),
      named(std::move(others)),
      entries(*program, *executable, this) {
  settings.run.stopRequests = &stopRequests;
}

Done proskill_executor::notStarted() const {
  if (hasStarted) return failed(PROSKILL_WRONG_ORDER, "the run has already started");
  return {};
}

Done proskill_executor::perform(const char* skill, embed::Functions functions) {
  if (auto done = notStarted(); !done) return done;
  const auto& all = executable->model.performed;
  const auto found = std::ranges::find(all, skill, &codegen::Performed::skill);
  if (found != all.end()) {
    platform->perform(static_cast<std::uint32_t>(found - all.begin()), functions);
    return {};
  }
  std::vector<std::string> names;
  for (const auto& each : all) names.push_back(each.skill);
  return embed::unknownName("basic skill", skill, names);
}

Done proskill_executor::observe(proskill_observer observer, void* data) {
  if (auto done = notStarted(); !done) return done;
  entries.observe(observer, data);
  return {};
}

proskill_executor::~proskill_executor() {
  entries.observe(nullptr, nullptr); // the end of a recording concerns nobody any more
}

Done proskill_executor::record(const char* path) {
  if (auto done = notStarted(); !done) return done;
  if (file)
    return failed(PROSKILL_WRONG_ORDER, fmt::format("the run is recorded in `{}`", recordedIn));
  recordedIn = path;
  if (recordedIn.ends_with(".btlog"))
    return failed(PROSKILL_INVALID_ARGUMENT, "only `proskill run` writes .btlog files");
  auto created = disk::GrowingFile::create(recordedIn);
  if (!created) return failed(PROSKILL_UNWRITABLE, std::move(created.error()));
  file.emplace(std::move(*created));
  return {};
}

Done proskill_executor::serveView(const proskill_view_options* options) {
  if (auto done = notStarted(); !done) return done;
  if (live)
    return failed(PROSKILL_WRONG_ORDER, fmt::format("the run is shown at {}", live->address()));
  auto made = embed::LiveView::open(
      {.program = *program,
       .executable = *executable,
       .speed = settings.isReal ? std::optional(settings.speed) : std::nullopt,
       .whoGoesOn = named && !named->isSimulated() ? "the platform of this run would go on" : "",
       .askToEnd = [this] { stop(); }},
      options);
  if (!made) return std::unexpected(std::move(made.error()));
  live = std::move(*made);
  return {};
}

const std::string& proskill_executor::viewAddress() const {
  static const std::string none;
  return live ? live->address() : none;
}

Done proskill_executor::start() {
  if (auto done = notStarted(); !done) return done;
  if (auto done = openPlatform(); !done) return done;
  execution = std::make_unique<Execution>(*executable, *clock, controlledPlatform(), audience,
                                          settings.run);
  beginRecording();
  execution->start();
  if (live && !live->canPause()) live->started();
  hasStarted = true;
  return {};
}

/// The platform, and what the page sends if there is one.
runtime::Platform& proskill_executor::controlledPlatform() {
  if (!live) return shared;
  shared.addDescriptor(live->wakeUp().descriptor());
  audience.add(live->observer());
  if (live->canPause()) {
    clock = live->pausable(std::move(clock));
    settings.run.pause = &live->pause();
    if (settings.isReal) platform->timesFrom(live->pause(), settings.speed);
  }
  return live->control(shared);
}

void proskill_executor::beginRecording() {
  if (!file) return;
  recording = std::make_unique<record::RunRecording>(
      std::move(*file), settings.isReal ? record::RunTime::Real : record::RunTime::Simulated,
      record::formatOf(recordedIn, {*program, *executable}), [this](const std::string& why) {
        lacking = why;
        entries.onRemark({.kind = runtime::RemarkKind::Note, .date = date(), .text = why});
      });
  audience.add(*recording);
}

void proskill_executor::endRun() {
  hasEnded = true;
  if (recording) recording->finish();
  if (live) live->finish(execution->result());
}

/// Makes sure that somebody performs each action.
Done proskill_executor::openPlatform() {
  const auto missing = platform->unperformed();
  if (missing && !named)
    return failed(PROSKILL_MISSING_ACTION,
                  fmt::format("nobody performs the action of `{}`",
                              executable->model.performed[*missing].skill));
  if (!named) return {};
  auto opened = named->open({.program = *program,
                             .executable = *executable,
                             .elsewhere = platform->performed(),
                             .speed = settings.speed,
                             .seed = settings.run.seed,
                             .stopRequests = stopRequests});
  if (!opened) return std::unexpected(std::move(opened.error()));
  shared.add(std::move(*opened));
  return {};
}

std::expected<embed::FunctionPlatform*, Failure> proskill_executor::started() const {
  if (!hasStarted) return failed(PROSKILL_WRONG_ORDER, "the run has not started");
  return platform.get();
}

Done proskill_executor::proceed() {
  if (!hasStarted) return failed(PROSKILL_WRONG_ORDER, "the run has not started");
  if (hasEnded) return failed(PROSKILL_WRONG_ORDER, "the run has ended");
  platform->wakeUp.acknowledge();
  if (live) {
    live->wakeUp().acknowledge();
    std::ignore = clock->now(); // stands still from here on, if the page has paused the run
    if (auto done = live->tellHold(this); !done) return done;
  }
  if (!doWhatIsDue() && jump()) doWhatIsDue();
  if (auto trouble = entries.takeTrouble(); !trouble.empty())
    return failed(PROSKILL_SYSTEM_ERROR, std::move(trouble));
  return {};
}

/// Does everything that is possible without waiting, unless the observer throws.
/// \return false if that was nothing
bool proskill_executor::doWhatIsDue() {
  auto progress = execution->proceed();
  if (progress == Progress::Waits) return false;
  while (progress == Progress::Moved && !entries.hasTrouble()) progress = execution->proceed();
  if (progress == Progress::Ended) endRun();
  return true;
}

/// Moves simulated time to what comes next. \return false if there is nothing to move to
bool proskill_executor::jump() {
  if (settings.isReal || hasEnded || !execution->wakeDate()) return false;
  if (live && !live->pause().admits()) return false; // the clock would wait for the page
  clock->wait(execution->wakeDate(), {});
  return true;
}

Done proskill_executor::runToEnd() {
  if (!hasStarted)
    if (auto done = start(); !done) return done;
  while (true) {
    if (auto done = proceed(); !done) return done;
    if (hasEnded) return {};
    wait();
  }
}

void proskill_executor::wait() {
  if (settings.isReal) return clock->wait(execution->wakeDate(), execution->descriptors());
  if (execution->wakeDate()) return;
  pollfd report{descriptor(), POLLIN, 0};
  ::poll(&report, 1, -1);
}

double proskill_executor::timeout() {
  if (!execution || hasEnded) return 0;
  const auto date = execution->wakeDate();
  if (!date) return -1;
  if (!settings.isReal) return 0;
  constexpr double kDay = 24.0 * 3600; // fits poll's milliseconds
  const auto rest = static_cast<double>(std::max<Nanoseconds>(*date - clock->now(), 0));
  return std::min(kDay, rest / static_cast<double>(runtime::kSecond) / settings.speed);
}

void proskill_executor::stop() {
  const int before = errno;
  ++stopRequests;
  platform->wakeUp.ring();
  errno = before;
}
