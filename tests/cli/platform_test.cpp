#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <signal.h>
#include <sstream>

using namespace proskill;
using Json = nlohmann::json;

namespace {

/// A program that flies as long as it may, and a platform's program in shell.
class Platform {
public:
  explicit Platform(const std::string& script) {
    files.write("mission.proskill", R"(
      (defskill fly :action (fly) :interrupt () :success there)
      (defskill mission :success done :body ((fly) (success done))))");
    files.write("robot.sh", script);
    files.write("platform.json", R"({"kind":"process","command":["sh","robot.sh"]})");
  }

  test::Finished run(std::vector<std::string> arguments = {},
                     const test::RunOptions& options = {}) const {
    arguments.insert(arguments.begin(), {PROSKILL_PROGRAM, "run", "--format", "json", "--platform",
                                         path("platform.json"), "--record", path("run.json")});
    arguments.push_back(path("mission.proskill"));
    return test::run(arguments, options);
  }
  [[nodiscard]] std::string path(const std::string& name = "") const { return files.path(name); }
  [[nodiscard]] std::string text(const std::string& name) const {
    std::ifstream file(path(name));
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }

private:
  test::TemporaryDirectory files;
};

const std::string kReadyRobot = R"(read -r hello; echo '{"type":"ready","protocol":1}'
)";

} // namespace

TEST_CASE("run starts the program of a platform where its file is") {
  const Platform platform(kReadyRobot + R"(read -r start; pwd >&2
                          echo '{"type":"result","run":1,"result":"there"}'; cat > heard)");
  const auto done = platform.run();
  INFO(done.out << done.err);
  CHECK(done.exitCode == 0);
  CHECK(done.err == platform.path() + "\n");
  CHECK(platform.text("heard") == "{\"type\":\"end\"}\n");
}

TEST_CASE("run says why a platform cannot be used") {
  const auto why = [](const std::string& script, std::vector<std::string> arguments = {}) {
    const auto done = Platform(script).run(std::move(arguments));
    CHECK(done.exitCode == 2);
    CHECK(done.out.empty());
    return done.err;
  };
  CHECK(why("echo no robot here >&2; exit 1").find("it ended with exit code 1") !=
        std::string::npos);
  CHECK(why("", {"--clock", "simulated"}).find("this platform takes real time") !=
        std::string::npos);
  CHECK(why("", {"--script", "x.json"}).find("cannot read `x.json`") != std::string::npos);
}

TEST_CASE("a request to end stops what runs, and then the platform's program") {
  const Platform platform(kReadyRobot + R"(read -r start; kill -TERM $PPID; read -r stop
                          echo '{"type":"stopped","run":1}'; cat > /dev/null; echo over > over)");
  const auto done = platform.run();
  INFO(done.out << done.err);
  CHECK(done.exitCode == 3);
  CHECK(done.out.find("every action has ended") != std::string::npos);
  CHECK(platform.text("over") == "over\n");
  CHECK(platform.text("run.json").find("asked to end: actions are stopped") != std::string::npos);
}

TEST_CASE("a second request does not wait for actions that do not stop") {
  const Platform platform(kReadyRobot + R"(trap '' TERM; read -r start
    kill -TERM $PPID; kill -INT $PPID; while :; do sleep 600; done)");
  const auto done = platform.run();
  INFO(done.out << done.err);
  CHECK(done.out.find("not every action has ended") != std::string::npos);
  const auto recorded = Json::parse(platform.text("run.json"));
  CHECK(recorded["steps"].back()["description"] ==
        "fault: its action did not stop in time, and may still be running");
}

TEST_CASE("a program sees the end of its input when the executor is killed") {
  const Platform platform("exec 2> /dev/null; mkfifo over\n" + kReadyRobot +
                          "cat > /dev/null; echo over > over");
  const auto done = platform.run({}, {.onOutput = [](int process) { kill(process, SIGKILL); }});
  CHECK(done.exitCode == 128 + SIGKILL);
  // opening the pipe waits until the program has ended
  CHECK(test::run({"/bin/sh", "-c",
                   "until [ -p " + platform.path("over") + " ]; do :; done; cat " +
                       platform.path("over")})
            .out == "over\n");
  CHECK(Json::parse(platform.text("run.json"))["steps"].is_array());
}

TEST_CASE("a full disk ends the recording, and not the run") {
  const Platform platform(kReadyRobot + R"(read -r start
    for i in 1 2 3 4 5 6 7 8 9; do
      printf '{"type":"log","text":"%01000d"}\n' $i
    done
    echo '{"type":"result","run":1,"result":"there"}'; cat > /dev/null)");
  const auto whole = platform.run();
  CHECK(whole.exitCode == 0);
  const auto all = Json::parse(platform.text("run.json"))["steps"].size();
  const auto limited = test::run(
      {"/bin/sh", "-c",
       "trap '' XFSZ; ulimit -f 8; exec " + std::string(PROSKILL_PROGRAM) + " run --platform " +
           platform.path("platform.json") + " --record " + platform.path("run.json") + " " +
           platform.path("mission.proskill") + " | cat"});
  INFO(limited.out << limited.err);
  CHECK(limited.out.find("the mission has ended") != std::string::npos);
  CHECK(limited.err.find("File too large; the recording ends here") != std::string::npos);
  const auto recorded = Json::parse(platform.text("run.json"))["steps"].size();
  CHECK(recorded > 2);
  CHECK(recorded < all);
  const auto none = test::run({PROSKILL_PROGRAM, "run", "--record", "/dev/full", "--platform",
                               platform.path("platform.json"), platform.path("mission.proskill")});
  CHECK(none.exitCode == 0);
  CHECK(none.err.find("No space left on device; the recording ends here") != std::string::npos);
}
