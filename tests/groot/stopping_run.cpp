#include "tests/groot/stopping_run.h"

#include "runtime/platform/settings.h"
#include "runtime/platform/simulated.h"
#include "verify/compile/watch.h"
#include "verify/state/evaluate.h"

#include <catch2/catch.hpp>

#include <utility>

namespace proskill::test {

using nlohmann::json;
using runtime::Progress;

StoppingRun::StoppingRun(const std::string& text, bool mayStop)
    : it(text),
      breakpoints(it.tree, *it.executable, mayStop ? &pause : nullptr),
      hooks(it.tree.size(), breakpoints, "the robot would go on",
            [this](groot::Uid uid) {
              messages += (messages.empty() ? "" : " ") + std::to_string(uid);
            }),
      clock(runtime::pausableClock(runtime::simulatedClock(), pause)),
      platform(runtime::simulatedPlatform(runtime::defaultSettings(*it.executable), 1)),
      observer(
          std::make_unique<Watcher>([this](const runtime::Machine& machine, runtime::Nanoseconds) {
            breakpoints.follow(machine);
          })),
      execution(*it.executable, *clock, *platform, *observer,
                {.until = 600 * runtime::kSecond, .pause = &pause}) {
  execution.start();
}

bool StoppingRun::goOn() {
  while (true) {
    const auto progress = execution.proceed();
    hooks.followRun();
    if (progress == Progress::Ended) return false;
    if (progress != Progress::Waits) continue;
    if (!pause.admits()) return true;
    clock->wait(execution.wakeDate(), {});
  }
}

std::string StoppingRun::heard() { return std::exchange(messages, {}); }

std::string StoppingRun::value(std::string_view variable) const {
  const auto& system = it.executable->system;
  for (const auto& watched : system.watched)
    if (watched.display == variable)
      return verify::shown(
          watched, verify::readCell(system, watched.cell, execution.state().state().data()));
  return "?";
}

groot::Uid StoppingRun::uid(std::string_view tag) const {
  const auto all = it.tagged(tag);
  REQUIRE(all.size() == 1);
  return all.front();
}

std::string StoppingRun::insert(std::string_view tag, groot::Position position, bool isOnce) {
  return hooks.insert(json{
      {"uid", uid(tag)},
      {"position", static_cast<int>(position)},
      {"mode", 0},
      {"enabled", true},
      {"once", isOnce},
      {"desired_status",
       "SKIPPED"}}.dump());
}

std::string StoppingRun::unlock(std::string_view tag, groot::Position position,
                                const std::string& desired) {
  return hooks.unlock(json{
      {"uid", uid(tag)},
      {"position", static_cast<int>(position)},
      {"desired_status", desired},
      {"remove_when_done",
       false}}.dump());
}

std::string StoppingRun::remove(std::string_view tag, groot::Position position) {
  return hooks.remove(json{{"uid", uid(tag)}, {"position", static_cast<int>(position)}}.dump());
}

} // namespace proskill::test
