#include "tests/embed/embedded.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <memory>
#include <poll.h>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace proskill;
using Catch::Contains;
using test::Embedded;

namespace {

const std::string kProgram = R"(
  (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
  (defevent storm :effects (sky Stormy))
  (defskill fly :action (fly 3 "north" true -0.5) :interrupt () :time_interval [0,60]
    :success there :failure lost)
  (defskill mission :success done :failure failed
    :body ((fly) (if (= fly.status success) (success done) else (failure failed))))
)";

/// A mission that waits for the event.
const std::string kWaits = R"(
  (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
  (defevent storm :effects (sky Stormy))
  (defskill mission :success done :body ((^ (sky Stormy)) (success done)))
)";

std::string errorOf(proskill_error code, proskill_error expected) {
  CHECK(code == expected);
  return proskill_error_text();
}

std::string outcome(const Embedded& run) { return proskill_executor_outcome(run.executor); }

void never(proskill_executor*, proskill_run, const proskill_value*, size_t, void*) {}

/// The loop that a program writes around the executor.
void runInLoop(proskill_executor* executor) {
  pollfd watched{proskill_executor_descriptor(executor), POLLIN, 0};
  while (true) {
    REQUIRE(proskill_executor_proceed(executor) == PROSKILL_OK);
    if (proskill_executor_phase(executor) == PROSKILL_ENDED) return;
    const auto seconds = proskill_executor_timeout(executor);
    ::poll(&watched, 1, seconds < 0 ? -1 : static_cast<int>(seconds * 1000) + 1);
  }
}

} // namespace

TEST_CASE("functions perform the actions in simulated time") {
  Embedded run(kProgram);
  run.perform("fly", {2.5, "there"});
  CHECK(proskill_executor_phase(run.executor) == PROSKILL_READY);
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  INFO(run.text());
  CHECK(proskill_executor_phase(run.executor) == PROSKILL_ENDED);
  CHECK(proskill_executor_end(run.executor) == PROSKILL_MISSION_ENDED);
  CHECK(outcome(run) == "success");
  CHECK(proskill_executor_time(run.executor) == 2.5);
  CHECK(proskill_executor_faults(run.executor) == 0);
  CHECK(proskill_executor_steps(run.executor) > 2);
  CHECK_THAT(run.text(), Contains("0 fly: (fly 3 \"north\" true -0.5)"));
  CHECK_THAT(run.text(), Contains("2.5 fly: succeeds with `there`"));
}

TEST_CASE("another result leads the mission elsewhere") {
  Embedded run(kProgram);
  run.perform("fly", {1, "lost"});
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  CHECK(outcome(run) == "failure");
  CHECK(run.value("fly.status") == "failure");
}

TEST_CASE("an action gets its arguments with their types") {
  Embedded run(kProgram);
  const auto begin = [](proskill_executor* in, proskill_run start, const proskill_value* all,
                        size_t count, void*) {
    REQUIRE(count == 4);
    CHECK(all[0].type == PROSKILL_INTEGER);
    CHECK(all[0].integer == 3);
    CHECK(std::string(all[1].string) == "north");
    CHECK(all[2].type == PROSKILL_BOOLEAN);
    CHECK(all[3].number == -0.5);
    proskill_executor_finish(in, start, "there");
  };
  REQUIRE(run.performBy("fly", begin) == PROSKILL_OK);
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  CHECK(outcome(run) == "success");
}

TEST_CASE("an event loop proceeds in simulated time") {
  Embedded run(kProgram);
  run.perform("fly", {50, "there"});
  REQUIRE(proskill_executor_start(run.executor) == PROSKILL_OK);
  CHECK(proskill_executor_phase(run.executor) == PROSKILL_RUNNING);
  runInLoop(run.executor);
  CHECK(outcome(run) == "success");
  CHECK(proskill_executor_time(run.executor) == 50);
}

TEST_CASE("an event loop proceeds in real time, and waits for what threads report") {
  auto options = Embedded::simulated();
  options.clock = PROSKILL_REAL_TIME;
  Embedded run(kWaits, options);
  REQUIRE(proskill_executor_start(run.executor) == PROSKILL_OK);
  REQUIRE(proskill_executor_proceed(run.executor) == PROSKILL_OK);
  CHECK(proskill_executor_timeout(run.executor) < 0);
  std::thread sensor([&] { proskill_executor_report(run.executor, "storm"); });
  runInLoop(run.executor);
  sensor.join();
  CHECK(outcome(run) == "success");
  CHECK(run.value("sky") == "Stormy");
}

TEST_CASE("a timeout fits the milliseconds of poll") {
  auto options = Embedded::simulated();
  options.clock = PROSKILL_REAL_TIME;
  options.until = 1e9;
  Embedded run(kWaits, options);
  CHECK(proskill_executor_timeout(run.executor) == 0);
  REQUIRE(proskill_executor_start(run.executor) == PROSKILL_OK);
  REQUIRE(proskill_executor_proceed(run.executor) == PROSKILL_OK);
  CHECK(proskill_executor_timeout(run.executor) == 24 * 3600);
}

TEST_CASE("a thread ends an action, in real and in simulated time") {
  for (const auto clock : {PROSKILL_REAL_TIME, PROSKILL_SIMULATED_TIME}) {
    auto options = Embedded::simulated();
    options.clock = clock;
    Embedded run(kProgram, options);
    static std::thread worker;
    const auto begin = [](proskill_executor* in, proskill_run start, const proskill_value*, size_t,
                          void*) {
      worker = std::thread([=] { proskill_executor_finish(in, start, "there"); });
    };
    REQUIRE(run.performBy("fly", begin) == PROSKILL_OK);
    REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
    worker.join();
    CHECK(outcome(run) == "success");
  }
}

TEST_CASE("simulated time ends when nothing can happen, and events can be planned") {
  Embedded stuck(kWaits);
  REQUIRE(proskill_executor_run(stuck.executor) == PROSKILL_OK);
  CHECK(proskill_executor_end(stuck.executor) == PROSKILL_STUCK);
  Embedded run(kWaits);
  REQUIRE(proskill_executor_start(run.executor) == PROSKILL_OK);
  REQUIRE(proskill_executor_report_after(run.executor, 7, "storm") == PROSKILL_OK);
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  CHECK(outcome(run) == "success");
  CHECK(proskill_executor_time(run.executor) == 7);
}

TEST_CASE("an interrupt asks the action to stop") {
  Embedded run(kProgram);
  run.perform("fly", {});
  REQUIRE(proskill_executor_start(run.executor) == PROSKILL_OK);
  REQUIRE(proskill_executor_proceed(run.executor) == PROSKILL_OK);
  REQUIRE(proskill_executor_interrupt(run.executor, "fly") == PROSKILL_OK);
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  INFO(run.text());
  CHECK(outcome(run) == "failure");
  CHECK_THAT(run.text(), Contains("fly: is asked to stop"));
  CHECK(proskill_executor_faults(run.executor) == 0);
}

TEST_CASE("what was planned for an action that has stopped does not happen") {
  Embedded run(R"(
    (defskill fly :action (fly) :interrupt () :success there)
    (defskill mission :success done :body ((fly) (fly) (success done))))");
  static int starts = 0;
  starts = 0;
  const auto begin = [](proskill_executor* in, proskill_run start, const proskill_value*, size_t,
                        void*) {
    proskill_executor_finish_after(in, start, ++starts == 1 ? 100 : 1000, "there");
  };
  const auto stop = [](proskill_executor* in, proskill_run start, void*) {
    CHECK(proskill_executor_stop_requested(in, start));
    proskill_executor_finish(in, start, PROSKILL_STOPPED);
  };
  REQUIRE(run.performBy("fly", begin, stop) == PROSKILL_OK);
  REQUIRE(proskill_executor_start(run.executor) == PROSKILL_OK);
  REQUIRE(proskill_executor_interrupt(run.executor, "fly") == PROSKILL_OK);
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  INFO(run.text());
  CHECK(starts == 2);
  CHECK(proskill_executor_time(run.executor) == 1000);
  CHECK(proskill_executor_faults(run.executor) == 0);
}

TEST_CASE("a request to end stops the actions, and ends the run") {
  Embedded run(kProgram);
  run.perform("fly", {});
  REQUIRE(proskill_executor_start(run.executor) == PROSKILL_OK);
  REQUIRE(proskill_executor_proceed(run.executor) == PROSKILL_OK);
  proskill_executor_stop(run.executor);
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  INFO(run.text());
  CHECK(proskill_executor_end(run.executor) == PROSKILL_ASKED_TO_END);
  CHECK(outcome(run) == "no_status");
}

TEST_CASE("a request to end wakes a run that waits in another thread") {
  auto options = Embedded::simulated();
  options.clock = PROSKILL_REAL_TIME;
  Embedded run(kWaits, options);
  REQUIRE(proskill_executor_start(run.executor) == PROSKILL_OK);
  std::thread runner([&] { CHECK(proskill_executor_run(run.executor) == PROSKILL_OK); });
  proskill_executor_stop(run.executor);
  runner.join();
  CHECK(proskill_executor_end(run.executor) == PROSKILL_ASKED_TO_END);
}

TEST_CASE("an action that does not stop is abandoned after its grace") {
  auto options = Embedded::simulated();
  options.grace = 3;
  Embedded run(kProgram, options);
  REQUIRE(run.performBy("fly", never) == PROSKILL_OK);
  REQUIRE(proskill_executor_start(run.executor) == PROSKILL_OK);
  REQUIRE(proskill_executor_proceed(run.executor) == PROSKILL_OK);
  proskill_executor_stop(run.executor);
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  CHECK(proskill_executor_end(run.executor) == PROSKILL_ABANDONED);
  CHECK_THAT(run.text(), Contains("! fly: its action did not stop in time"));
  CHECK(proskill_executor_stop_requested(run.executor, 1));
}

TEST_CASE("a time limit ends the run") {
  auto options = Embedded::simulated();
  options.until = 10;
  Embedded run(kProgram, options);
  run.perform("fly", {50, "there"});
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  CHECK(proskill_executor_end(run.executor) == PROSKILL_TIME_LIMIT);
  CHECK(proskill_executor_time(run.executor) == 10);
}

TEST_CASE("the program's environment causes the events if it is asked to") {
  const std::string program = R"(
    (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
    (defevent storm :effects (sky Stormy))
    (defenvironment weather :body ((^ 5) (emit storm)))
    (defskill mission :success done :body ((^ (sky Stormy)) (success done))))";
  auto options = Embedded::simulated();
  options.environment = true;
  Embedded run(program, options);
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  CHECK(outcome(run) == "success");
  CHECK(proskill_executor_time(run.executor) == 5);
}

TEST_CASE("an executor outlives the handle of its program") {
  Embedded run(kProgram);
  run.perform("fly", {1, "there"});
  proskill_program_free(std::exchange(run.program, nullptr));
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  CHECK(outcome(run) == "success");
}

TEST_CASE("values have names that can be listed") {
  Embedded run(kProgram);
  std::string names;
  for (size_t i = 0; const char* name = proskill_executor_name(run.executor, i); ++i)
    names += std::string(name) + " ";
  CHECK_THAT(names, Contains("sky ") && Contains("fly.status ") && Contains("mission.status "));
}

TEST_CASE("a planned result of an unknown name is an error, and a fault of the run") {
  Embedded run(kProgram);
  const auto begin = [](proskill_executor* in, proskill_run start, const proskill_value*, size_t,
                        void*) {
    CHECK(errorOf(proskill_executor_finish(in, start, "ther"), PROSKILL_UNKNOWN_NAME) ==
          "there is no result of `fly` `ther`; did you mean `there`?");
  };
  REQUIRE(run.performBy("fly", begin) == PROSKILL_OK);
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  INFO(run.text());
  CHECK_THAT(run.text(), Contains("! fly: its action has no result `ther`"));
  CHECK(outcome(run) == "failure");
}

TEST_CASE("an action that throws ends with a fault") {
  Embedded run(kProgram);
  const auto begin = [](proskill_executor*, proskill_run, const proskill_value*, size_t, void*) {
    throw std::runtime_error("no wind");
  };
  REQUIRE(run.performBy("fly", begin) == PROSKILL_OK);
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  CHECK_THAT(run.text(), Contains("! fly: its action failed: no wind"));
  CHECK(outcome(run) == "failure");
}

TEST_CASE("an action that stops by itself is a fault") {
  Embedded run(kProgram);
  const auto begin = [](proskill_executor* in, proskill_run start, const proskill_value*, size_t,
                        void*) { proskill_executor_finish(in, start, PROSKILL_STOPPED); };
  REQUIRE(run.performBy("fly", begin) == PROSKILL_OK);
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  CHECK_THAT(run.text(), Contains("! fly: its action has stopped without being asked to"));
}

TEST_CASE("a second end of an action is nothing") {
  Embedded run(kProgram);
  const auto begin = [](proskill_executor* in, proskill_run start, const proskill_value*, size_t,
                        void*) {
    CHECK(proskill_executor_finish(in, start, "there") == PROSKILL_OK);
    CHECK(proskill_executor_fail(in, start, "too late") == PROSKILL_OK);
  };
  REQUIRE(run.performBy("fly", begin) == PROSKILL_OK);
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  CHECK(proskill_executor_finish(run.executor, 1, "there") == PROSKILL_OK);
  CHECK(outcome(run) == "success");
  CHECK(proskill_executor_faults(run.executor) == 0);
}

TEST_CASE("what many threads report at once arrives, and the run ends when one of them says so") {
  auto options = Embedded::simulated();
  options.clock = PROSKILL_REAL_TIME;
  Embedded run(kProgram, options);
  REQUIRE(run.performBy("fly", never) == PROSKILL_OK);
  REQUIRE(proskill_executor_start(run.executor) == PROSKILL_OK);
  REQUIRE(proskill_executor_proceed(run.executor) == PROSKILL_OK); // run 1 has begun
  constexpr int kThreads = 4;
  constexpr int kNotes = 100;
  std::atomic<int> left = kThreads;
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i)
    threads.emplace_back([&] {
      for (int k = 0; k < kNotes; ++k) proskill_executor_log(run.executor, "here");
      if (--left == 0) proskill_executor_finish(run.executor, 1, "there");
    });
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  for (auto& thread : threads) thread.join();
  CHECK(outcome(run) == "success");
  int heard = 0;
  for (auto at = run.text().find(": here\n"); at != std::string::npos;
       at = run.text().find(": here\n", at + 1))
    ++heard;
  CHECK(heard == kThreads * kNotes);
}

TEST_CASE("several executors run at the same time, each in its thread") {
  std::vector<std::unique_ptr<Embedded>> runs;
  for (int i = 0; i < 4; ++i) {
    runs.push_back(std::make_unique<Embedded>(kProgram));
    runs.back()->perform("fly", {1.0 + i, "there"});
  }
  std::vector<std::thread> threads;
  for (const auto& run : runs)
    threads.emplace_back([executor = run->executor] { proskill_executor_run(executor); });
  for (auto& thread : threads) thread.join();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    CHECK(outcome(*runs[i]) == "success");
    CHECK(proskill_executor_time(runs[i]->executor) == 1.0 + static_cast<double>(i));
  }
}
