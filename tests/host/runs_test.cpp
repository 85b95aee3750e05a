#include "host/runs.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <poll.h>
#include <thread>

using namespace proskill::host;
using namespace std::chrono_literals;

namespace {

constexpr auto kForEver = 1000s;

bool isReadable(int descriptor) {
  pollfd one{descriptor, POLLIN, 0};
  return ::poll(&one, 1, 0) == 1;
}

} // namespace

TEST_CASE("a run is asked to stop whoever waits for it, and however") {
  Runs runs;
  const std::string fly = "fly";
  runs.begin(1, fly);
  const int early = runs.descriptor(1);
  CHECK_FALSE(isReadable(early));
  CHECK_FALSE(runs.isAsked(1));
  CHECK_FALSE(runs.wait(1, 0s));
  CHECK(std::string(runs.skill(1)) == "fly");
  bool waited = false;
  std::thread waiter([&] { waited = runs.wait(1, kForEver); });
  runs.askToStop(1);
  waiter.join();
  CHECK(waited);
  CHECK(isReadable(early));
  CHECK(runs.isAsked(1));
  const auto ended = runs.end(1);
  REQUIRE(ended);
  CHECK(ended->wasAsked);
  CHECK_FALSE(runs.end(1));
}

TEST_CASE("what has ended is not touched") {
  Runs runs;
  CHECK(runs.isAsked(7));
  CHECK(runs.wait(7, kForEver));
  CHECK(runs.descriptor(7) == -1);
  CHECK(std::string(runs.skill(7)).empty());
  runs.askToStop(7);
  runs.abandon(7);
  runs.onStop(
      7, [](proskill_run, void*) { FAIL("there is no such run"); }, nullptr);
  CHECK(runs.stopAll(0s).empty());
}

TEST_CASE("a function is called once when its run is to stop, and may end it") {
  Runs runs;
  const std::string fly = "fly";
  struct Called {
    Runs& runs;
    int times = 0;
  } called{runs};
  const auto end = [](proskill_run run, void* data) {
    auto& to = *static_cast<Called*>(data);
    ++to.times;
    CHECK(to.runs.end(run));
  };
  runs.begin(1, fly);
  runs.onStop(1, end, &called);
  runs.askToStop(1);
  runs.askToStop(1);
  CHECK(called.times == 1);
  runs.begin(2, fly); // asked before the callback is registered
  runs.askToStop(2);
  runs.onStop(2, end, &called);
  CHECK(called.times == 2);
}

TEST_CASE("the end of a run waits for the function that is called") {
  // The callback's data may be freed as soon as the run has ended.
  for (int i = 0; i < 2'000; ++i) {
    Runs runs;
    const std::string fly = "fly";
    runs.begin(1, fly);
    auto data = std::make_unique<int>(0);
    runs.onStop(
        1, [](proskill_run, void* given) { ++*static_cast<int*>(given); }, data.get());
    std::thread asker([&] { runs.askToStop(1); });
    CHECK(runs.end(1));
    data.reset();
    asker.join();
  }
}

TEST_CASE("many threads begin, stop, wait for and end runs at once") {
  Runs runs;
  const std::string fly = "fly";
  constexpr proskill_run kRuns = 2'000;
  std::atomic<int> ends = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&, i] {
      for (proskill_run run = 1; run <= kRuns; ++run) {
        if (i == 0) runs.begin(run, fly);
        if (i == 1) runs.askToStop(run);
        if (i == 2) std::ignore = runs.descriptor(run);
        if (i == 3) runs.abandon(run);
        if (i == 0) {
          if (run % 2 == 0) runs.askToStop(run);
          std::ignore = runs.wait(run, 0s);
          ends += runs.end(run).has_value();
        }
      }
    });
  for (auto& thread : threads) thread.join();
  CHECK(ends == kRuns);
  CHECK(runs.stopAll(0s).empty());
}

TEST_CASE("at the end all are asked, and those that did not stop are named") {
  Runs runs;
  const std::string fly = "fly";
  const std::string look = "look";
  runs.begin(1, fly);
  runs.begin(2, look);
  std::thread flight([&] {
    std::ignore = runs.wait(1, kForEver);
    std::ignore = runs.end(1);
  });
  CHECK(runs.stopAll(50ms) == std::vector<std::string>{"look"});
  flight.join();
}

TEST_CASE("arguments have the types of the program") {
  const Arguments all(nlohmann::ordered_json::parse(R"([3, 2.5, true, "dock", null])"));
  REQUIRE(all.size() == 5);
  CHECK(all.data()[0].type == PROSKILL_INTEGER);
  CHECK(all.data()[0].integer == 3);
  CHECK(all.data()[0].number == 3.0);
  CHECK(all.data()[1].type == PROSKILL_FLOAT);
  CHECK(all.data()[1].number == 2.5);
  CHECK(all.data()[2].type == PROSKILL_BOOLEAN);
  CHECK(all.data()[2].integer == 1);
  CHECK(std::string(all.data()[3].string) == "dock");
  CHECK(all.data()[4].type == PROSKILL_NONE);
  CHECK(std::string(all.data()[4].string).empty());
}
