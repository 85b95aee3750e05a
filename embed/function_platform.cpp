#include "embed/function_platform.h"

#include "host/runs.h"
#include "runtime/platform/messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <tuple>

namespace proskill::embed {

using runtime::Nanoseconds;
using runtime::Report;
using runtime::ReportKind;
using runtime::RunNumber;

FunctionPlatform::FunctionPlatform(const runtime::Executable& of, runtime::Clock& with,
                                   proskill_executor* by)
    : executable(of),
      clock(with),
      owner(by),
      performers(of.actions.size()),
      runs(of.actions.size()) {}

std::optional<std::uint32_t> FunctionPlatform::unperformed() const {
  const auto found = std::ranges::find(performers, nullptr, &Functions::begin);
  if (found == performers.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - performers.begin());
}

bool FunctionPlatform::performsAny() const {
  return std::ranges::any_of(performers, [](const auto& each) { return each.begin != nullptr; });
}

std::vector<std::string> FunctionPlatform::performed() const {
  std::vector<std::string> skills;
  for (std::uint32_t i = 0; i < performers.size(); ++i)
    if (performs(i)) skills.push_back(executable.model.performed[i].skill);
  return skills;
}

// --- For any thread

Done FunctionPlatform::finish(RunNumber run, const char* result, Nanoseconds delay) {
  const std::lock_guard lock(mutex);
  const auto action = actionOf(run);
  if (!action) return std::unexpected(action.error());
  if (!*action) return {};
  Report report{.kind = ReportKind::Result, .action = **action, .run = run};
  auto done = setResult(report, result);
  plan(std::move(report), delay);
  return done;
}

Done FunctionPlatform::fail(RunNumber run, std::string_view why) {
  const std::lock_guard lock(mutex);
  const auto action = actionOf(run);
  if (!action) return std::unexpected(action.error());
  if (*action)
    plan({.kind = ReportKind::Result,
          .action = **action,
          .run = run,
          .text = fmt::format("its action failed: {}", why)},
         0);
  return {};
}

Done FunctionPlatform::send(std::string_view name, bool interrupts, Nanoseconds delay) {
  const auto& all = executable.model.signals;
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    if (all[i].interrupts != interrupts) continue;
    names.push_back(all[i].name);
    if (all[i].name != name) continue;
    const std::lock_guard lock(mutex);
    plan({.kind = ReportKind::Signal, .signal = i}, delay);
    return {};
  }
  return unknownName(interrupts ? "skill with `:interrupt`" : "event", name, names);
}

void FunctionPlatform::log(std::string text) {
  const std::lock_guard lock(mutex);
  plan({.kind = ReportKind::Note, .text = std::move(text)}, 0);
}

bool FunctionPlatform::isAsked(RunNumber run) const {
  const std::lock_guard lock(mutex);
  if (run == 0 || run > lastRun) return false;
  const auto found = std::ranges::find(runs, run, &Run::number);
  return found == runs.end() || !found->isRunning || found->isAsked;
}

/// nullopt: the run of the action has ended.
std::expected<std::optional<std::uint32_t>, Failure>
FunctionPlatform::actionOf(RunNumber run) const {
  if (run == 0 || run > lastRun)
    return failed(PROSKILL_INVALID_ARGUMENT, fmt::format("no action has run {}", run));
  const auto found = std::ranges::find(runs, run, &Run::number);
  if (found == runs.end() || !found->isRunning) return std::nullopt;
  return static_cast<std::uint32_t>(found - runs.begin());
}

Done FunctionPlatform::setResult(Report& report, const char* result) const {
  if (!result) return {};
  const auto& performed = executable.model.performed[report.action];
  const auto found = std::ranges::find(performed.results, result, runtime::resultName);
  if (found != performed.results.end()) {
    report.result = static_cast<std::uint32_t>(found - performed.results.begin());
    return {};
  }
  report.text = fmt::format("its action has no result `{}`", result);
  std::vector<std::string> names;
  for (const auto& each : performed.results) names.push_back(runtime::resultName(each));
  return unknownName(fmt::format("result of `{}`", performed.skill), result, names);
}

/// For any thread.
Nanoseconds FunctionPlatform::now() const {
  if (!clock.isReal()) return seen;
  // What is planned while an action starts is not early, however the two clocks are read.
  return pause ? std::max(pause->date(speedOfPause), seen.load()) : clock.now();
}

/// \pre the mutex is locked
void FunctionPlatform::plan(Report report, Nanoseconds delay) {
  if (hasClosed) return;
  Nanoseconds date = 0;
  if (delay > 0) date = now() + delay;
  planned.emplace(date, std::move(report));
  wakeUp.ring();
}

// --- For the run

void FunctionPlatform::start(const runtime::Start& start, Nanoseconds date) {
  seen = date;
  {
    const std::lock_guard lock(mutex);
    runs[start.action] = {.number = start.run, .isRunning = true};
    lastRun = start.run;
  }
  const auto& functions = performers[start.action];
  const host::Arguments arguments(runtime::argumentsOf(start));
  guarded(start.run, [&] {
    functions.begin(owner, start.run, arguments.data(), arguments.size(), functions.data);
  });
}

bool FunctionPlatform::stop(std::uint32_t action, RunNumber run, Nanoseconds date) {
  seen = date;
  {
    const std::lock_guard lock(mutex);
    runs[action].isAsked = true;
  }
  const auto& functions = performers[action];
  if (functions.stop) guarded(run, [&] { functions.stop(owner, run, functions.data); });
  return false;
}

void FunctionPlatform::abandon(std::uint32_t action, RunNumber run, Nanoseconds date) {
  static_cast<void>(run);
  static_cast<void>(date);
  const std::lock_guard lock(mutex);
  end(action);
}

std::optional<Nanoseconds> FunctionPlatform::next() const {
  const std::lock_guard lock(mutex);
  return planned.empty() ? std::nullopt : std::optional(planned.begin()->first);
}

bool FunctionPlatform::poll(Nanoseconds date, Report& report) {
  seen = date;
  const std::lock_guard lock(mutex);
  while (!planned.empty() && planned.begin()->first <= date) {
    auto first = planned.extract(planned.begin());
    report = std::move(first.mapped());
    report.date = date;
    if (counts(report)) return true;
  }
  return false;
}

/// In simulated time, events that nobody has planned would come never, or at once.
bool FunctionPlatform::mayReport() const {
  const std::lock_guard lock(mutex);
  return clock.isReal() || std::ranges::any_of(runs, &Run::isRunning);
}

void FunctionPlatform::close() {
  const std::lock_guard lock(mutex);
  hasClosed = true;
}

void FunctionPlatform::addDescriptors(std::vector<int>& all) const {
  all.push_back(wakeUp.descriptor());
}

/// Whether a report concerns a run that has not ended. A result ends its run.
bool FunctionPlatform::counts(Report& report) {
  if (report.kind != ReportKind::Result) return true;
  const auto& run = runs[report.action];
  if (run.number != report.run || !run.isRunning) return false;
  const bool hasStopped = report.result == runtime::kUnknownResult && report.text.empty();
  if (hasStopped && !run.isAsked) report.text = "its action has stopped without being asked to";
  end(report.action);
  return true;
}

/// Ends the run of an action; what was planned for it does not happen.
void FunctionPlatform::end(std::uint32_t action) {
  runs[action].isRunning = false;
  std::erase_if(planned, [&](const auto& each) {
    const Report& report = each.second;
    return report.kind == ReportKind::Result && report.action == action;
  });
}

/// Calls a function of another program. An exception that leaves it ends the action.
template <class Call> void FunctionPlatform::guarded(RunNumber run, Call&& call) {
  try {
    call();
  } catch (const std::exception& error) {
    std::ignore = fail(run, error.what());
  } catch (...) {
    std::ignore = fail(run, "an exception has left it");
  }
}

} // namespace proskill::embed
