#include "tests/embed/embedded.h"

#include <catch2/catch.hpp>

#include <cstddef>
#include <fstream>
#include <poll.h>

using namespace proskill;
using Catch::Contains;
using test::Embedded;

namespace {

const std::string kNamed = R"((defplatform "robot.json")
  (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
  (defevent storm :effects (sky Stormy))
  (defskill fly :action (fly) :interrupt () :success there :failure lost)
  (defskill land :action (land) :success landed :failure crashed)
  (defskill mission :success done :failure failed
    :body ((fly) (land) (if (= land.status success) (success done)) (failure failed))))";

/// A program of a platform, in shell, which is ready after `hello`.
std::string inShell(const std::string& script) {
  return R"({"kind": "process", "command": ["/bin/sh", "-c", ")"
         R"(read -r hello; echo '{\"type\":\"ready\",\"protocol\":1}'; )" +
         script + R"("]})";
}

/// Lands once it is asked to.
const std::string kLands =
    R"(read -r start; echo '{\"type\":\"result\",\"run\":2,\"result\":\"landed\"}'; cat >/dev/null)";

proskill_options realTime() {
  proskill_options options = PROSKILL_OPTIONS;
  options.until = 60;
  return options;
}

/// A run in real time whose function performs `fly`.
struct Flight : Embedded {
  explicit Flight(const std::string& platform, const std::string& text = kNamed,
                  const proskill_options& options = realTime())
      : Embedded(text, platform, &options) {
    REQUIRE(made == PROSKILL_OK);
    perform("fly", {0.001, "there"});
  }
  std::string outcome() const { return proskill_executor_outcome(executor); }
};

/// How the executor of a program is refused, with its platform.
std::string refusal(const std::string& platform, proskill_error code,
                    const proskill_options& options = realTime(),
                    const std::string& text = kNamed) {
  const Embedded run(text, platform, &options);
  CHECK(run.made == code);
  return run.error();
}

/// How a start is refused.
std::string startError(const std::string& platform) {
  const Flight run(platform);
  CHECK(proskill_executor_start(run.executor) == PROSKILL_INVALID_PLATFORM);
  return run.error();
}

} // namespace

TEST_CASE("the platform that a program names performs what no function performs") {
  const auto simulated = Embedded::simulated();
  Embedded run(kNamed, R"({"actions": {"land": {"duration": [7, 7], "results": {"landed": 1}},
                                       "fly": {"duration": [100, 100]}}, "events": {"storm": null}})",
               &simulated);
  run.perform("fly", {2, "there"});
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  INFO(run.text());
  CHECK(proskill_executor_time(run.executor) == 9);
  CHECK(std::string(proskill_executor_outcome(run.executor)) == "success");
  CHECK(run.value("sky") == "Clear");
}

TEST_CASE("a simulated platform sends events, also to a program of functions alone") {
  auto options = Embedded::simulated();
  options.until = 50;
  Embedded run(kNamed, R"({"events": {"storm": [3, 3]}})", &options);
  run.perform("fly", {});
  run.perform("land", {});
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  CHECK_THAT(run.text(), Contains("\n3 storm: "));
  CHECK_THAT(run.text(), Contains("\n6 storm: "));
}

TEST_CASE("a platform's program performs what no function performs, and sends events") {
  Flight run(inShell(R"(echo '{\"type\":\"event\",\"name\":\"storm\"}'; )" + kLands));
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  INFO(run.text());
  CHECK(run.outcome() == "success");
  CHECK(run.value("sky") == "Stormy");
  CHECK(proskill_executor_faults(run.executor) == 0);
}

TEST_CASE("the descriptor of a run is readable when the platform has a report") {
  Flight run(inShell(kLands));
  pollfd watched{proskill_executor_descriptor(run.executor), POLLIN, 0};
  REQUIRE(proskill_executor_start(run.executor) == PROSKILL_OK);
  while (proskill_executor_phase(run.executor) != PROSKILL_ENDED) {
    REQUIRE(proskill_executor_proceed(run.executor) == PROSKILL_OK);
    const auto seconds = proskill_executor_timeout(run.executor);
    if (proskill_executor_phase(run.executor) != PROSKILL_ENDED)
      ::poll(&watched, 1, seconds < 0 ? -1 : static_cast<int>(seconds * 1000) + 1);
  }
  CHECK(run.outcome() == "success");
}

TEST_CASE("a platform learns nothing of the actions of functions") {
  Flight run(inShell("echo \\\"$hello\\\" > hello; " + kLands));
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  std::ifstream file(run.path("hello"));
  const std::string hello{std::istreambuf_iterator<char>(file), {}};
  CHECK_THAT(hello, Contains(R"("skills":[{"name":"land")"));
  CHECK_THAT(hello, !Contains(R"("name":"fly")"));
}

TEST_CASE("functions go on without a platform that has ended, and its actions fail") {
  Flight run(inShell("read -r start; exit 3"), kNamed + "(defskill alone :body ((land) (fly)))",
             [] {
               auto options = realTime();
               options.main_skill = "alone";
               return options;
             }());
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  INFO(run.text());
  CHECK(proskill_executor_end(run.executor) == PROSKILL_MISSION_ENDED);
  CHECK_THAT(run.text(), Contains("ended with exit code 3"));
  CHECK_THAT(run.text(), Contains("! land: its action has ended with the platform's program"));
  CHECK(run.value("fly.status") == "success");
}

TEST_CASE("a platform that has ended ends a run without functions") {
  const auto options = realTime();
  Embedded run(kNamed, inShell("read -r start; exit 3"), &options);
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  INFO(run.text());
  CHECK(proskill_executor_end(run.executor) == PROSKILL_PLATFORM_LOST);
}

TEST_CASE("options name another platform, or none") {
  auto options = Embedded::simulated();
  const test::TemporaryDirectory files;
  const auto other = files.write(
      "other.json", R"({"actions": {"land": {"duration": [5, 5], "results": {"crashed": 1}}}})");
  options.platform = other.c_str();
  Embedded run(kNamed, "{,}", &options);
  run.perform("fly", {1, "there"});
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  CHECK(proskill_executor_time(run.executor) == 6);
  CHECK(std::string(proskill_executor_outcome(run.executor)) == "failure");

  options.no_platform = true;
  Embedded alone(kNamed, "{,}", &options);
  alone.perform("fly", {1, "there"});
  CHECK(proskill_executor_run(alone.executor) == PROSKILL_MISSING_ACTION);
  CHECK(alone.error() == "nobody performs the action of `land`");
}

TEST_CASE("the options of an older header know no platform") {
  auto options = Embedded::simulated();
  options.size = offsetof(proskill_options, platform);
  options.platform = "/nowhere.json";
  const Embedded run(kNamed, "{,}", &options);
  REQUIRE(run.made == PROSKILL_OK);
  CHECK(proskill_executor_run(run.executor) == PROSKILL_MISSING_ACTION);
  --options.size;
  CHECK(refusal("{}", PROSKILL_INVALID_ARGUMENT, options) ==
        "options must begin as PROSKILL_OPTIONS");
}

TEST_CASE("a platform file that cannot be used has its places") {
  CHECK(refusal("{,}", PROSKILL_INVALID_PLATFORM) == "robot.json:1:2: error: it is not JSON");
  CHECK(refusal(R"({"kind": "robot"})", PROSKILL_INVALID_PLATFORM)
            .starts_with("robot.json:1:10: error: `kind` must be"));
  CHECK(startError("{\"kind\": \"process\",\n \"command\": [], \"startup\": 0}") ==
        "robot.json:2:13: error: `command` must begin with a program\n"
        "robot.json:2:28: error: `startup` must be more than 0 s");
  CHECK(startError(R"({"kind": "ros1", "actions": {"flie": {}}})") ==
        "mission.proskill:5:13: error: the platform file has no action for `land`\n"
        "robot.json:1:30: error: there is no basic skill `flie`");
  CHECK(startError(R"({"kind": "process", "command": ["./none"]})") ==
        "robot.json: error: `./none` cannot be started: No such file or directory");
}

TEST_CASE("a platform file that is not there is an error at its name") {
  const auto options = realTime();
  const auto text = "(defplatform \"other.json\")" + kNamed.substr(kNamed.find('\n'));
  CHECK(refusal("{}", PROSKILL_UNREADABLE, options, text) ==
        "mission.proskill:1:15: error: cannot read `other.json`: no such file or directory");
}

TEST_CASE("a platform that takes real time needs a real clock") {
  CHECK(refusal(inShell(kLands), PROSKILL_INVALID_ARGUMENT, Embedded::simulated()) ==
        "robot.json: `clock` must be PROSKILL_REAL_TIME: this platform takes real time");
  auto fast = realTime();
  fast.speed = 10;
  CHECK(refusal(R"({"kind": "ros2"})", PROSKILL_INVALID_ARGUMENT, fast) ==
        "robot.json: `speed` must be 1: ROS takes real time");
}

TEST_CASE("a request to end ends the wait for a platform") {
  Flight run(R"({"kind": "process", "command": ["/bin/cat"], "startup": 600})");
  proskill_executor_stop(run.executor);
  CHECK(proskill_executor_start(run.executor) == PROSKILL_INVALID_PLATFORM);
  CHECK_THAT(run.error(), Contains("asked to end before the platform's program was ready"));
}
