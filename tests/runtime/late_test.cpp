/// Runs that are asked to end, or whose clock jumps: what is due is then handled late.
#include "tests/runtime/flying.h"
#include "tests/runtime/run_of.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <utility>

using namespace proskill;
using runtime::End;
using runtime::RemarkKind;
using test::mission;
using test::runOf;

namespace {

/// Performs nothing, and calls what a test sets.
class Silent final : public runtime::Platform {
public:
  void start(const runtime::Start&, runtime::Nanoseconds) override { onStart(); }
  bool stop(std::uint32_t, runtime::RunNumber, runtime::Nanoseconds) override {
    onStop();
    return false;
  }
  [[nodiscard]] std::optional<runtime::Nanoseconds> next() const override { return {}; }
  bool poll(runtime::Nanoseconds date, runtime::Report& report) override {
    return onPoll(date, report);
  }
  [[nodiscard]] bool mayReport() const override { return true; }

  std::function<bool(runtime::Nanoseconds, runtime::Report&)> onPoll = [](auto, auto&) {
    return false;
  };
  std::function<void()> onStart = [] {};
  std::function<void()> onStop = [] {};
};

/// A clock that a test sets.
class Jumping final : public runtime::Clock {
public:
  explicit Jumping(std::vector<runtime::Nanoseconds> all) : dates(std::move(all)) {}
  void start() override {}
  runtime::Nanoseconds now() override { return dates[at]; }
  void wait(std::optional<runtime::Nanoseconds>, const std::vector<int>&) override {
    at = std::min(at + 1, dates.size() - 1);
    onWait();
  }
  [[nodiscard]] bool isReal() const override { return true; }

  std::function<void()> onWait = [] {};

private:
  std::vector<runtime::Nanoseconds> dates;
  std::size_t at = 0;
};

} // namespace

TEST_CASE("a request to end before the start takes no step") {
  const auto executable = test::executableOf(mission("(fly) (success done)"), false);
  const std::atomic<int> requests = 1;
  Silent silent;
  const auto before = runOf(*executable, silent, {.stopRequests = &requests});
  CHECK(before.result.end == End::Stopped);
  CHECK(before.result.steps == 0);
}

TEST_CASE("a request to end stops what runs; a second one does not wait for it") {
  const auto executable = test::executableOf(mission("(fly) (success done)"), false);
  const auto endedBy = [&](int more) {
    std::atomic<int> requests = 0;
    Silent silent;
    silent.onStart = [&] { ++requests; };
    silent.onStop = [&] { requests += more; };
    return runOf(*executable, silent, {.grace = runtime::kSecond, .stopRequests = &requests});
  };
  const auto once = endedBy(0);
  CHECK(once.result.end == End::Abandoned);
  CHECK(once.result.date == runtime::kSecond);
  REQUIRE(once.told(RemarkKind::Asked));
  REQUIRE(once.told(RemarkKind::Fault));
  CHECK(once.told(RemarkKind::Fault)->text ==
        "its action did not stop in time, and may still be running");
  const auto twice = endedBy(1);
  CHECK(twice.result.end == End::Abandoned);
  CHECK(twice.result.date == 0);
  CHECK(twice.told(RemarkKind::Fault));
}

TEST_CASE("a request to end long after the last step leaves actions their time to stop") {
  const auto executable = test::executableOf(mission("(fly) (success done)"), false);
  std::atomic<int> requests = 0;
  Silent slow;
  bool hasStopped = false;
  slow.onPoll = [&](runtime::Nanoseconds date, runtime::Report& report) {
    report = {.run = 1};
    return date == 10 * runtime::kSecond && !std::exchange(hasStopped, true);
  };
  Jumping clock({0, 9 * runtime::kSecond, 10 * runtime::kSecond, 20 * runtime::kSecond});
  clock.onWait = [&] { requests = 1; };
  const auto ran = runOf(*executable, slow, clock, {.stopRequests = &requests});
  CHECK(ran.result.end == End::Stopped);
  CHECK_FALSE(ran.told(RemarkKind::Fault));
  REQUIRE(ran.told(RemarkKind::Asked));
  CHECK(ran.told(RemarkKind::Asked)->date == 9 * runtime::kSecond);
  CHECK(ran.told(RemarkKind::Note)->date == 9 * runtime::kSecond);
}

TEST_CASE("after a clock has jumped, steps keep their own dates, and it is said") {
  const auto executable = test::executableOf(mission("(^ 1) (^ 2) (^ 0.5) (success done)"), false);
  Silent silent;
  Jumping clock({0, 3600 * runtime::kSecond});
  const auto ran = runOf(*executable, silent, clock, {});
  INFO(ran.text());
  CHECK(ran.result.end == End::Mission);
  CHECK(ran.when("mission", "succeeds with `done`") == 3.5);
  CHECK(ran.maxLag == 3599 * runtime::kSecond);
  REQUIRE(ran.told(RemarkKind::Note));
  CHECK(ran.told(RemarkKind::Note)->text ==
        "this process was suspended: steps are taken later than their dates, and what the platform "
        "has reported is dated later");
  CHECK(std::ranges::count(ran.remarks, RemarkKind::Note, &test::Ran::Told::kind) == 1);
}

TEST_CASE("a result that is read late, since a clock has jumped, comes with a note") {
  const auto executable = test::executableOf(mission("(fly) (success done)"), false);
  Silent late;
  bool isOver = false;
  late.onPoll = [&](runtime::Nanoseconds date, runtime::Report& report) {
    report = {.kind = runtime::ReportKind::Result, .date = date, .run = 1, .result = 0};
    return date > runtime::kSecond && !std::exchange(isOver, true);
  };
  Jumping clock({0, runtime::kSecond, 3600 * runtime::kSecond});
  const auto ran = runOf(*executable, late, clock, {});
  INFO(ran.text());
  CHECK(ran.result.end == End::Mission);
  CHECK(std::ranges::count(ran.remarks, RemarkKind::Note, &test::Ran::Told::kind) == 1);
}

TEST_CASE("what is judged late is reported with its own date, and in the order of dates") {
  const auto executable = test::executableOf(
      "(defskill fly :time_interval [2,5] :action (fly) :success there)"
      "(defskill look :time_interval [1,4] :action (look) :success seen)"
      "(defskill mission :success done :body ((// ((fly)) ((look))) (success done)))"
      "(defproperty early (leadsto (running fly) (= fly.status success) :within [0,4.5]))"
      "(defproperty late (leadsto (running fly) (= fly.status success) :within [0,6]))",
      false);
  Silent silent;
  Jumping clock({0, 60 * runtime::kSecond});
  const auto ran = runOf(*executable, silent, clock, {.until = 60 * runtime::kSecond});
  std::string said;
  for (const auto& [kind, date, subject, text] : ran.remarks)
    if (kind == RemarkKind::Overshoot || kind == RemarkKind::Violated)
      said += fmt::format("{} {}\n", subject, date);
  CHECK(said == "look 4000000001\nearly 4500000001\nfly 5000000001\nlate 6000000001\n");
}

TEST_CASE("a clock that goes back does not take time back") {
  const auto executable = test::executableOf(mission("(^ 2) (^ 2) (success done)"), false);
  Silent silent;
  Jumping clock({0, 3 * runtime::kSecond, runtime::kSecond, 4 * runtime::kSecond});
  const auto ran = runOf(*executable, silent, clock, {});
  CHECK(ran.when("mission", "succeeds with `done`") == 4);
  for (std::size_t i = 1; i < ran.steps.size(); ++i)
    CHECK(ran.steps[i - 1].date <= ran.steps[i].date);
}
