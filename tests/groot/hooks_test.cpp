#include "tests/groot/stopping_run.h"

#include <catch2/catch.hpp>

using namespace proskill;
using Catch::Contains;
using groot::Position;
using nlohmann::json;
using test::StoppingRun;

namespace {

constexpr std::uint64_t kSecond = 1'000'000; ///< in microseconds

const std::string kSearch = R"(
  (defsv door :states (Open Closed) :init Open :transitions :all)
  (defskill fly :time_interval [1,2] :action (fly) :success there)
  (defskill search :success found :body ((fly) (set (door Closed)) (success found)))
  (defskill mission :success done :body ((search) (^ 1) (success done))))";

const std::string kLoop = R"(
  (defskill mission :body ((while true (^ 1)))))";

std::string uidOf(const StoppingRun& run, std::string_view tag) {
  return std::to_string(run.uid(tag));
}

} // namespace

TEST_CASE("a run stops at a node before it is executed, and goes on when it is unlocked") {
  StoppingRun run(kSearch);
  REQUIRE(run.insert("Set", Position::Pre) == "");
  REQUIRE(run.goOn());
  CHECK(run.heard() == uidOf(run, "Set"));
  CHECK(run.value("door") == "Open");
  CHECK(run.goOn()); // it is still there
  CHECK(run.heard() == "");
  CHECK(run.unlock("Set", Position::Pre) == "");
  CHECK_FALSE(run.goOn());
  CHECK(run.value("door") == "Closed");
}

TEST_CASE("a run stops when a node has ended, before what follows") {
  StoppingRun run(kSearch);
  REQUIRE(run.insert("Set", Position::Post) == "");
  REQUIRE(run.insert("fly", Position::Post) == "");
  REQUIRE(run.goOn());
  CHECK(run.heard() == uidOf(run, "fly"));
  CHECK(run.value("fly.status") == "success");
  CHECK(run.value("door") == "Open");
  CHECK(run.unlock("fly", Position::Post) == "");
  REQUIRE(run.goOn());
  CHECK(run.heard() == uidOf(run, "Set"));
  CHECK(run.value("door") == "Closed");
  CHECK(run.value("search.status") == "no_status");
  CHECK(run.unlock("Set", Position::Post) == "");
  CHECK_FALSE(run.goOn());
}

TEST_CASE("a basic skill is not called while the run is stopped before its call") {
  StoppingRun run(kSearch);
  REQUIRE(run.insert("fly", Position::Pre) == "");
  REQUIRE(run.goOn());
  CHECK(run.date() == 0);
  const auto before = run.steps();
  CHECK(run.unlock("fly", Position::Pre) == "");
  CHECK_FALSE(run.goOn());
  CHECK(run.steps() > before + 3);
}

TEST_CASE("where a run stops at several nodes, they are unlocked one after the other") {
  StoppingRun run(kSearch);
  const auto parent = std::to_string(run.uid("fly") - 1); // its sequence
  REQUIRE(run.hooks.insert(R"({"position":0,"uid":)" + parent + "}") == "");
  REQUIRE(run.insert("fly", Position::Pre, true) == "");
  REQUIRE(run.goOn());
  CHECK(run.heard() == parent);
  CHECK(run.hooks.unlock(R"({"position":0,"uid":)" + parent + "}") == "");
  CHECK(run.goOn());
  CHECK(run.heard() == uidOf(run, "fly"));
  CHECK(run.unlock("fly", Position::Pre) == "");
  CHECK(run.unlock("fly", Position::Pre) == "Node ID not found"); // it was for once
  CHECK_FALSE(run.goOn());
}

TEST_CASE("a breakpoint in a loop stops each round, until it is removed") {
  StoppingRun run(kLoop);
  REQUIRE(run.insert("WaitFor", Position::Pre) == "");
  for (int round = 0; round < 5; ++round) {
    REQUIRE(run.goOn());
    CHECK(run.heard() == uidOf(run, "WaitFor"));
    CHECK(run.date() == round * runtime::kSecond);
    CHECK(run.unlock("WaitFor", Position::Pre) == "");
  }
  REQUIRE(run.goOn());
  CHECK(run.remove("WaitFor", Position::Pre) == "");
  CHECK_FALSE(run.goOn());
  CHECK(run.remove("WaitFor", Position::Pre) == "Node ID not found");
}

TEST_CASE("a breakpoint that is disabled or removed lets the run go on") {
  for (const bool removes : {true, false}) {
    StoppingRun run(kLoop);
    REQUIRE(run.insert("WaitFor", Position::Pre) == "");
    REQUIRE(run.goOn());
    removes ? run.hooks.removeAll() : run.hooks.disableAll();
    CHECK_FALSE(run.goOn());
    const auto left = json::parse(run.hooks.dump());
    CHECK(left.size() == (removes ? 0 : 1));
    if (!removes) CHECK(left[0]["enabled"] == false);
  }
}

TEST_CASE("a breakpoint can be set and enabled while the run is under way") {
  StoppingRun run(kLoop);
  REQUIRE(run.insert("WaitFor", Position::Pre) == "");
  REQUIRE(run.goOn());
  run.pause.hold(); // as a page does
  run.hooks.disableAll();
  run.pause.hold();
  CHECK(run.goOn());
  run.pause.step();
  CHECK(run.goOn());
  CHECK(run.heard() == uidOf(run, "WaitFor"));
  REQUIRE(run.insert("WaitFor", Position::Post) == "");
  run.pause.resume();
  REQUIRE(run.goOn());
  CHECK(run.heard() == uidOf(run, "WaitFor"));
  CHECK(run.unlock("WaitFor", Position::Pre) == "the run has not stopped at this breakpoint");
  CHECK(run.unlock("WaitFor", Position::Post, "SUCCESS") == "");
}

TEST_CASE("a run that a page continues has passed its breakpoint") {
  StoppingRun run(kLoop);
  REQUIRE(run.insert("WaitFor", Position::Pre) == "");
  REQUIRE(run.goOn());
  run.pause.resume();
  run.hooks.followRun();
  CHECK(run.unlock("WaitFor", Position::Pre) == "the run has not stopped at this breakpoint");
  REQUIRE(run.goOn());
  CHECK(run.date() == runtime::kSecond);
  CHECK(run.unlock("WaitFor", Position::Pre) == "");
}

TEST_CASE("how a node ends is decided by the program") {
  StoppingRun run(kSearch);
  REQUIRE(run.insert("fly", Position::Pre) == "");
  REQUIRE(run.insert("fly", Position::Post) == "");
  REQUIRE(run.goOn());
  for (const auto* desired : {"SUCCESS", "FAILURE"})
    CHECK_THAT(run.unlock("fly", Position::Pre, desired), Contains("decided by the program"));
  CHECK(run.unlock("fly", Position::Pre, "WRONG") == "`desired_status` is not a status");
  CHECK(run.goOn()); // it is still there
  CHECK(run.unlock("fly", Position::Pre, "RUNNING") == "");
  REQUIRE(run.goOn());
  CHECK(run.unlock("fly", Position::Post, "FAILURE") ==
        "the node has ended with SUCCESS, which cannot be changed");
  CHECK(run.unlock("fly", Position::Post, "SUCCESS") == "");
  CHECK_FALSE(run.goOn());
}

TEST_CASE("without a sign of life from viewers for 5 s, a run does not stay at breakpoints") {
  StoppingRun run(kLoop);
  run.hooks.hear(10 * kSecond);
  REQUIRE(run.insert("WaitFor", Position::Pre) == "");
  REQUIRE(run.goOn());
  CHECK(run.hooks.nextNotice(12 * kSecond) == 3 * kSecond);
  run.hooks.notice(15 * kSecond - 1);
  CHECK(run.goOn());
  run.hooks.notice(15 * kSecond);
  CHECK_FALSE(run.pause.isHeld());
  CHECK(run.hooks.nextNotice(16 * kSecond) == std::nullopt);
  CHECK(json::parse(run.hooks.dump())[0]["enabled"] == true);
  run.hooks.hear(20 * kSecond); // a viewer has returned
  REQUIRE(run.goOn());
  CHECK(run.unlock("WaitFor", Position::Pre) == "");
  run.hooks.notice(30 * kSecond);
  CHECK_FALSE(run.goOn());
}

TEST_CASE("breakpoints do not change a run") {
  const auto stepsOf = [](bool stops) {
    StoppingRun run(kSearch);
    if (stops) {
      REQUIRE(run.insert("Set", Position::Pre) == "");
      REQUIRE(run.insert("fly", Position::Post) == "");
      REQUIRE(run.goOn());
      CHECK(run.unlock("fly", Position::Post) == "");
      REQUIRE(run.goOn());
      CHECK(run.unlock("Set", Position::Pre) == "");
    }
    CHECK_FALSE(run.goOn());
    return std::pair(run.steps(), run.date());
  };
  CHECK(stepsOf(true) == stepsOf(false));
}

TEST_CASE("breakpoints are listed as they were set") {
  StoppingRun run(kSearch);
  CHECK(run.hooks.dump() == "[]");
  REQUIRE(run.hooks.insert(R"([{"uid":3,"position":1,"mode":0,"enabled":false,"once":true,
                                "desired_status":"FAILURE"},
                               {"uid":2,"position":0,"mode":0,"enabled":true,"once":false,
                                "desired_status":"SKIPPED"}])") == "");
  CHECK(json::parse(run.hooks.dump()) == json::parse(R"([
    {"uid":2,"position":0,"mode":0,"enabled":true,"once":false,"desired_status":"SKIPPED"},
    {"uid":3,"position":1,"mode":0,"enabled":false,"once":true,"desired_status":"FAILURE"}])"));
}

TEST_CASE("a breakpoint that is not possible is an error, and sets none of its list") {
  StoppingRun run(kSearch);
  const auto error = [&](const std::string& text) { return run.hooks.insert(text); };
  const std::string good = R"({"uid":1,"position":0})";
  CHECK(error(R"({"uid":0,"position":0})") == "Node ID not found");
  CHECK(error(R"([)" + good + R"(,{"uid":500,"position":0}])") == "Node ID not found");
  CHECK(error(R"({"uid":1,"position":2})") == "Node ID not found");
  CHECK_THAT(error(R"({"uid":1,"position":0,"mode":1})"), Contains("cannot be replaced"));
  CHECK_THAT(error(R"({"uid":1,"position":0,"desired_status":"GOOD"})"), Contains("not a status"));
  CHECK_THAT(error(R"({"position":0})"), Contains("numbers `uid`"));
  CHECK_THAT(error(R"({"uid":"1","position":0})"), Contains("numbers `uid`"));
  CHECK(error(R"({"uid":1,"position":4294967296})") == "Node ID not found");
  CHECK_THAT(error(R"({"uid":-1,"position":0})"), Contains("Node ID not found"));
  CHECK(error("7") == "a breakpoint must be a JSON object");
  CHECK(error("[7]") == "a breakpoint must be a JSON object");
  CHECK(error("") == "the second part is not JSON");
  CHECK(run.hooks.remove("[]") == "the second part must be one object");
  CHECK(run.hooks.unlock(R"({"uid":1,"position":0})") == "Node ID not found");
  CHECK(run.hooks.dump() == "[]");
  CHECK_FALSE(run.goOn());
}

TEST_CASE("a run that cannot be paused has no breakpoints, and says why") {
  StoppingRun run(kSearch, false);
  CHECK(run.insert("fly", Position::Pre) == "the robot would go on");
  CHECK(run.hooks.dump() == "[]");
  run.hooks.removeAll();
  run.hooks.disableAll();
  CHECK_FALSE(run.goOn());
}
