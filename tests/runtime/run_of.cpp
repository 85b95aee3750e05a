#include "tests/runtime/run_of.h"

#include "runtime/executor/description.h"
#include "runtime/platform/settings.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace proskill::test {

namespace {

class Notes final : public runtime::Observer {
public:
  Notes(const runtime::Executable& of, Ran& to) : executable(of), ran(to) {
    ran.recorded.head.initial = runtime::initialValues(of);
  }

  void onStep(const runtime::Machine& machine, verify::TransitionId step, runtime::Nanoseconds date,
              runtime::Nanoseconds lag) override {
    ran.maxLag = std::max(ran.maxLag, lag);
    ran.recorded.steps.push_back(runtime::recorded(executable, machine, step, date));
    const auto last = runtime::lastStep(executable, machine, step);
    Ran::Taken taken{step, date, {}, {}};
    if (!last.origins.empty()) {
      const auto& origin = executable.model.provenance.origins[last.origins.back()];
      taken.actor = origin.actor;
      taken.description = origin.description;
    }
    ran.steps.push_back(std::move(taken));
  }

  void onRemark(const runtime::Remark& remark) override {
    if (remark.start)
      ran.recorded.calls.push_back(
          runtime::recorded(executable, *remark.start, remark.date, ran.recorded.steps.size()));
    ran.remarks.push_back(
        {remark.kind, remark.date, std::string(remark.subject), std::string(remark.text)});
  }

private:
  const runtime::Executable& executable;
  Ran& ran;
};

double seconds(runtime::Nanoseconds date) {
  return static_cast<double>(date) / static_cast<double>(runtime::kSecond);
}

runtime::JsonFile parsed(const std::string& text) { return runtime::JsonFile::parse(text).value(); }

} // namespace

std::string Ran::text() const {
  std::string text;
  for (const auto& step : steps)
    text += fmt::format("{} {} {}\n", seconds(step.date), step.actor, step.description);
  return text;
}

double Ran::when(std::string_view actor, std::string_view description) const {
  const auto found = std::ranges::find_if(steps, [&](const Taken& step) {
    return step.actor == actor && step.description == description;
  });
  return found == steps.end() ? -1 : seconds(found->date);
}

const Ran::Told* Ran::told(runtime::RemarkKind kind) const {
  const auto found = std::ranges::find(remarks, kind, &Told::kind);
  return found == remarks.end() ? nullptr : &*found;
}

std::unique_ptr<const runtime::Executable> executableOf(const std::string& text, bool environment) {
  auto made = runtime::makeExecutable(programOfText(text), "", environment);
  if (!made) FAIL(made.error().message << "\n" << text);
  return std::move(*made);
}

Ran runOf(const runtime::Executable& executable, runtime::Platform& platform,
          runtime::RunOptions options) {
  const auto clock = runtime::simulatedClock();
  auto ran = runOf(executable, platform, *clock, options);
  if (ran.maxLag != 0) FAIL("simulated time is late");
  return ran;
}

Ran runInRealTime(const runtime::Executable& executable, runtime::Platform& platform,
                  runtime::RunOptions options) {
  const auto clock = runtime::realClock();
  return runOf(executable, platform, *clock, options);
}

Ran runOf(const runtime::Executable& executable, runtime::Platform& platform, runtime::Clock& clock,
          runtime::RunOptions options) {
  Ran ran;
  ran.recorded.head.environment = executable.model.hasEnvironment;
  Notes notes(executable, ran);
  ran.result = execute(executable, clock, platform, notes, options);
  return ran;
}

Ran runOf(const runtime::Executable& executable, std::uint64_t seed, const std::string& script,
          const std::string& platform, double until) {
  auto settings = defaultSettings(executable);
  if (!platform.empty())
    CHECK(readSimulation(parsed(platform), executable.model, settings).empty());
  if (!script.empty()) CHECK(readScript(parsed(script), executable.model, settings).empty());
  const auto simulated = simulatedPlatform(std::move(settings), seed + 1);
  return runOf(
      executable, *simulated,
      {.seed = seed, .until = static_cast<runtime::Nanoseconds>(until * 1e9), .mostAtOnce = 5'000});
}

Ran runOf(const std::string& text, const std::string& script, std::uint64_t seed) {
  return runOf(*executableOf(text, false), seed, script);
}

} // namespace proskill::test
