#include "tests/embed/embedded.h"
#include "tests/embed/visitor.h"

#include <catch2/catch.hpp>

#include <csignal>
#include <cstddef>
#include <poll.h>
#include <stdexcept>
#include <thread>

using namespace proskill;
using Catch::Contains;
using test::Embedded;
using test::Visitor;

namespace {

const std::string kTwoFlights = R"(
  (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
  (defevent storm :effects (sky Stormy))
  (defskill fly :action (fly) :time_interval [1,5] :interrupt () :success there)
  (defskill mission :success done :body ((fly) (^ (sky Stormy)) (fly) (success done))))";

proskill_view_options paused() {
  proskill_view_options options = PROSKILL_VIEW_OPTIONS;
  options.paused = true;
  return options;
}

/// A run with a page.
struct Shown : Embedded {
  explicit Shown(const proskill_view_options& view = PROSKILL_VIEW_OPTIONS,
                 proskill_options options = simulated())
      : Embedded(kTwoFlights, options) {
    perform("fly", {2, "there"});
    INFO(proskill_error_text());
    REQUIRE(proskill_executor_serve_view(executor, &view) == PROSKILL_OK);
  }
  [[nodiscard]] std::string address() const { return proskill_executor_view_address(executor); }
  void start() const { REQUIRE(proskill_executor_start(executor) == PROSKILL_OK); }
  void proceed() const { REQUIRE(proskill_executor_proceed(executor) == PROSKILL_OK); }
  /// Proceeds when the run asks for it. \return whether it did
  [[nodiscard]] bool proceedWhenAsked() const {
    pollfd watched{proskill_executor_descriptor(executor), POLLIN, 0};
    if (::poll(&watched, 1, 60'000) != 1) return false;
    proceed();
    return true;
  }
  [[nodiscard]] bool hasEnded() const {
    return proskill_executor_phase(executor) == PROSKILL_ENDED;
  }
};

proskill_options inRealTime() {
  proskill_options options = PROSKILL_OPTIONS;
  options.speed = 1000;
  return options;
}

std::string refusal(const proskill_view_options& view, proskill_error code,
                    const proskill_options& options = Embedded::simulated()) {
  const Embedded run(kTwoFlights, options);
  CHECK(proskill_executor_serve_view(run.executor, &view) == code);
  CHECK(std::string(proskill_executor_view_address(run.executor)).empty());
  return proskill_error_text();
}

} // namespace

TEST_CASE("a page shows a run from before its start until the executor is freed") {
  std::optional<Visitor> visitor;
  {
    const Shown run;
    visitor.emplace(run.address());
    CHECK_THAT(visitor->request("GET", "/" + visitor->token + "/"), Contains("panel.js"));
    CHECK(visitor->status()["state"] == "running");
    run.start();
    REQUIRE(proskill_executor_report_after(run.executor, 10, "storm") == PROSKILL_OK);
    REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
    const auto status = visitor->status();
    CHECK(status["state"] == "ended");
    CHECK(status["end"]["mission"] == "success");
    CHECK(status["date"] == 12);
    const auto steps = visitor->ask("steps", {{"from", 0}})["result"];
    CHECK(steps["steps"].size() == steps["total"]);
    CHECK(steps["total"] >= proskill_executor_steps(run.executor));
    CHECK_THAT(visitor->control("close"), Contains("shows it until it ends"));
    CHECK_THAT(visitor->ask("picture", {{"kind", "skill"}, {"name", "mission"}}).dump(),
               Contains("<svg"));
  }
  CHECK(visitor->request("GET", "/" + visitor->token + "/").empty());
}

TEST_CASE("requests without the token of the page are refused") {
  const Shown run(paused());
  auto visitor = Visitor(run.address());
  CHECK(visitor.token.size() == 32);
  visitor.token.back() = visitor.token.back() == '0' ? '1' : '0';
  CHECK(visitor.ask("control", {{"do", "continue"}}) == "403");
  visitor.token.clear();
  CHECK(visitor.ask("control", {{"do", "continue"}}) == "403");
  run.start();
  run.proceed();
  CHECK(proskill_executor_steps(run.executor) == 0);
}

TEST_CASE("a run that begins paused asks to proceed when the page lets it take a step") {
  const Shown run(paused());
  const Visitor visitor(run.address());
  run.start();
  run.proceed();
  CHECK(proskill_executor_steps(run.executor) == 0);
  CHECK(proskill_executor_timeout(run.executor) < 0);
  CHECK(visitor.status()["state"] == "paused");
  CHECK(visitor.control("step") == "");
  REQUIRE(run.proceedWhenAsked());
  CHECK(proskill_executor_steps(run.executor) == 1);
  CHECK(visitor.control("step") == "");
  REQUIRE(run.proceedWhenAsked());
  CHECK(proskill_executor_steps(run.executor) == 2);
  CHECK(visitor.control("send", "storm") == "");
  REQUIRE(run.proceedWhenAsked());
  CHECK(proskill_executor_steps(run.executor) == 2); // it waits until the run goes on
  CHECK(visitor.control("continue") == "");
  while (!run.hasEnded()) REQUIRE(run.proceedWhenAsked());
  CHECK(run.value("sky") == "Stormy");
  CHECK(std::string(proskill_executor_outcome(run.executor)) == "success");
}

TEST_CASE("a page steps through simulated time while one call runs to the end") {
  const Shown run(paused());
  const Visitor visitor(run.address());
  std::thread clicks([&] {
    std::size_t steps = 0;
    for (; steps < 3; ++steps) {
      CHECK(visitor.control("step") == "");
      while (visitor.status()["steps"] <= steps) std::this_thread::yield();
    }
    CHECK(visitor.control("end") == "");
  });
  CHECK(proskill_executor_run(run.executor) == PROSKILL_OK);
  clicks.join();
  CHECK(proskill_executor_end(run.executor) == PROSKILL_ASKED_TO_END);
}

TEST_CASE("in real time a page sends events and interrupts, and ends the run") {
  const proskill_view_options view = PROSKILL_VIEW_OPTIONS;
  const Shown run(view, inRealTime());
  const Visitor visitor(run.address());
  std::thread clicks([&] {
    while (visitor.status()["steps"] == 0) std::this_thread::yield();
    CHECK(visitor.status()["date"] > 0);
    CHECK_THAT(visitor.control("pause"), Contains("only runs in simulated time"));
    CHECK(visitor.control("send", "storm") == "");
    while (visitor.status()["state"] == "running") std::this_thread::yield();
  });
  CHECK(proskill_executor_run(run.executor) == PROSKILL_OK);
  clicks.join();
  CHECK(run.value("sky") == "Stormy");
  CHECK(std::string(proskill_executor_outcome(run.executor)) == "success");
}

TEST_CASE("in real time a page pauses the run of a program that holds its actions") {
  std::vector<bool> told;
  auto view = paused();
  view.hold = [](proskill_executor*, bool held, void* data) {
    static_cast<std::vector<bool>*>(data)->push_back(held);
  };
  view.data = &told;
  const Shown run(view, inRealTime());
  const Visitor visitor(run.address());
  run.start();
  run.proceed();
  CHECK(told == std::vector{true});
  CHECK(proskill_executor_steps(run.executor) == 0);
  CHECK(proskill_executor_timeout(run.executor) < 0);
  CHECK(visitor.status()["state"] == "paused");
  CHECK(visitor.control("step") == "");
  REQUIRE(run.proceedWhenAsked());
  CHECK(proskill_executor_steps(run.executor) == 1);
  CHECK(visitor.control("continue") == "");
  REQUIRE(run.proceedWhenAsked());
  CHECK(told == std::vector{true, false});
  CHECK(visitor.control("pause") == "");
  REQUIRE(run.proceedWhenAsked());
  CHECK(told == std::vector{true, false, true});
  const auto date = visitor.status()["date"];
  run.proceed();
  CHECK(visitor.status()["date"] == date);
  CHECK(visitor.control("continue") == "");
  REQUIRE(proskill_executor_report(run.executor, "storm") == PROSKILL_OK);
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  CHECK(told == std::vector{true, false, true, false});
  CHECK(std::string(proskill_executor_outcome(run.executor)) == "success");
  CHECK_THAT(run.text(), !Contains("undershoot"));
}

TEST_CASE("an exception that leaves `hold` ends the call, and the run can go on") {
  auto view = paused();
  view.hold = [](proskill_executor*, bool held, void*) {
    if (held) throw std::runtime_error("no brake");
  };
  const Shown run(view, inRealTime());
  const Visitor visitor(run.address());
  run.start();
  CHECK(proskill_executor_proceed(run.executor) == PROSKILL_SYSTEM_ERROR);
  CHECK_THAT(std::string(proskill_error_text()), Contains("no brake"));
  CHECK(visitor.control("continue") == "");
  REQUIRE(proskill_executor_report(run.executor, "storm") == PROSKILL_OK);
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
}

TEST_CASE("view options of a program that was built before there was `hold` are accepted") {
  proskill_view_options view = PROSKILL_VIEW_OPTIONS;
  view.size = offsetof(proskill_view_options, hold);
  view.hold = [](proskill_executor*, bool, void*) { FAIL(); };
  const Shown run(view, inRealTime());
  run.start();
  CHECK_THAT(Visitor(run.address()).control("pause"), Contains("a function `hold`"));
  run.proceed();
}

TEST_CASE("a page without controls only shows the run") {
  proskill_view_options view = PROSKILL_VIEW_OPTIONS;
  view.no_controls = true;
  const Shown run(view, inRealTime());
  const Visitor visitor(run.address());
  run.start();
  for (const auto* action : {"send", "end", "pause"})
    CHECK_THAT(visitor.control(action, "storm"), Contains("cannot influence"));
  run.proceed();
  CHECK(proskill_executor_phase(run.executor) == PROSKILL_RUNNING);
  CHECK(run.value("sky") == "Clear");
}

TEST_CASE("a page does not change a run in simulated time") {
  const auto textOf = [](bool isShown) {
    Embedded run(kTwoFlights);
    run.perform("fly", {2, "there"});
    if (isShown) REQUIRE(proskill_executor_serve_view(run.executor, nullptr) == PROSKILL_OK);
    REQUIRE(proskill_executor_start(run.executor) == PROSKILL_OK);
    REQUIRE(proskill_executor_report_after(run.executor, 10, "storm") == PROSKILL_OK);
    REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
    return run.text();
  };
  CHECK(textOf(true) == textOf(false));
}

TEST_CASE("signals are left to the threads of the program") {
  static std::atomic<std::thread::id> handler;
  struct sigaction action {};
  struct sigaction before {};
  action.sa_handler = [](int) { handler = std::this_thread::get_id(); };
  sigaction(SIGUSR1, &action, &before);
  const Shown run;
  sigset_t mask;
  sigset_t old;
  sigemptyset(&mask);
  sigaddset(&mask, SIGUSR1);
  pthread_sigmask(SIG_BLOCK, &mask, &old);
  kill(getpid(), SIGUSR1); // a thread that did not block it would take it now
  CHECK(Visitor(run.address()).status()["state"] == "running");
  CHECK(handler.load() == std::thread::id());
  pthread_sigmask(SIG_SETMASK, &old, nullptr);
  CHECK(handler.load() == std::this_thread::get_id());
  sigaction(SIGUSR1, &before, nullptr);
}

TEST_CASE("a page that is not possible is an error with its reason") {
  proskill_view_options view = PROSKILL_VIEW_OPTIONS;
  CHECK_THAT(refusal(paused(), PROSKILL_INVALID_ARGUMENT, inRealTime()),
             Contains("cannot begin `paused`: only runs in simulated time"));
  auto both = paused();
  both.no_controls = true;
  CHECK_THAT(refusal(both, PROSKILL_INVALID_ARGUMENT), Contains("exclude each other"));
  view.size = 4;
  CHECK_THAT(refusal(view, PROSKILL_INVALID_ARGUMENT), Contains("PROSKILL_VIEW_OPTIONS"));
  const Shown run;
  view = PROSKILL_VIEW_OPTIONS;
  view.port = static_cast<std::uint16_t>(Visitor(run.address()).port);
  CHECK_THAT(
      refusal(view, PROSKILL_SYSTEM_ERROR),
      Contains("cannot listen on port " + std::to_string(view.port) + ": Address already in use"));
  CHECK(proskill_executor_serve_view(nullptr, nullptr) == PROSKILL_INVALID_ARGUMENT);
  CHECK(std::string(proskill_executor_view_address(nullptr)).empty());
}

TEST_CASE("a page is opened once, before the start") {
  const Shown run;
  CHECK(proskill_executor_serve_view(run.executor, nullptr) == PROSKILL_WRONG_ORDER);
  CHECK(proskill_error_text() == "the run is shown at " + run.address());
  Embedded other(kTwoFlights);
  other.perform("fly", {2, "there"});
  REQUIRE(proskill_executor_start(other.executor) == PROSKILL_OK);
  CHECK(proskill_executor_serve_view(other.executor, nullptr) == PROSKILL_WRONG_ORDER);
}
