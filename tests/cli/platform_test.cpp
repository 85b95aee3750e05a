#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <signal.h>
#include <sstream>
#include <unistd.h>

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

TEST_CASE("a robot's run is recorded unless the user does not want it") {
  const Platform platform(kReadyRobot + R"(read -r start
                          echo '{"type":"result","run":1,"result":"there"}'; cat > /dev/null)");
  const auto run = [&](const std::string& state, std::vector<std::string> options = {}) {
    std::vector<std::string> command{PROSKILL_PROGRAM, "run", "--platform",
                                     platform.path("platform.json"),
                                     platform.path("mission.proskill")};
    command.insert(command.end(), options.begin(), options.end());
    const auto done =
        test::run(command, {.environment = {"XDG_STATE_HOME=" + state, "STATE_DIRECTORY="}});
    INFO(done.out << done.err);
    CHECK(done.exitCode == 0);
    return done.err;
  };
  const std::filesystem::path directory(platform.path("state/proskill/recordings"));
  const auto said = run(platform.path("state"));
  REQUIRE(said.starts_with("the run is recorded in " + directory.string() + "/mission-"));
  const auto file = said.substr(said.find('/'), said.size() - said.find('/') - 1);
  std::ifstream bytes(file);
  std::string magic(8, ' ');
  bytes.read(magic.data(), 8);
  CHECK(magic == "\x89MCAP0\r\n");
  CHECK(test::run({PROSKILL_PROGRAM, "conform", file, platform.path("mission.proskill")})
            .out.starts_with("the run conforms"));

  // The oldest are deleted, but none of a process that runs, and nothing else.
  const auto number = [&] {
    std::size_t count = 0;
    for (const auto& each : std::filesystem::directory_iterator(directory))
      if (each.path().filename().string().starts_with("mission-")) ++count;
    return count;
  };
  const auto touch = [&](const std::string& name) { std::ofstream(directory / name) << "x"; };
  const auto mine = "mission-20200101T000000Z-" + std::to_string(getpid()) + ".mcap";
  touch(mine);
  for (const auto* other : {"mission-2.mcap", "missions-20200101T000000Z-999999999.mcap"})
    touch(other);
  for (int day = 10; day < 40; ++day)
    touch("mission-202001" + std::to_string(day) + "T000000Z-999999999.mcap");
  run(platform.path("state"));
  CHECK(number() == 20 + 2); // the one of this process, and one with another name
  for (const auto& kept : {mine, std::string("mission-2.mcap"),
                           std::string("missions-20200101T000000Z-999999999.mcap"),
                           std::filesystem::path(file).filename().string()})
    CHECK(std::filesystem::exists(directory / kept));

  // So are large ones, although there are not many; the newest one stays.
  const std::string large = "mission-20980101T000000Z-999999999.mcap";
  const std::string newest = "mission-20990101T000000Z-999999999.mcap";
  for (const auto& each : {large, newest}) {
    touch(each);
    std::filesystem::resize_file(directory / each, std::uint64_t{9} << 30); // takes no space
  }
  run(platform.path("state"));
  CHECK_FALSE(std::filesystem::exists(directory / large));
  CHECK(std::filesystem::exists(directory / newest));
  CHECK(std::filesystem::exists(directory / mine));

  CHECK(run(platform.path("none"), {"--no-record"}).empty());
  CHECK_FALSE(std::filesystem::exists(platform.path("none")));
  CHECK(
      run("/proc/none").starts_with("warning: the run is not recorded: cannot create `/proc/none"));
  CHECK(test::run({PROSKILL_PROGRAM, "run", platform.path("mission.proskill")},
                  {.environment = {"XDG_STATE_HOME=" + platform.path("none")}})
            .err.empty());
  CHECK_FALSE(std::filesystem::exists(platform.path("none")));
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
  CHECK(none.exitCode == 2);
  CHECK(none.err.find("No space left on device; the recording ends here") != std::string::npos);
}

namespace {

/// A program in a folder that names a platform file beside it.
class NamedPlatform {
public:
  explicit NamedPlatform(const std::string& platform) {
    std::filesystem::create_directory(files.path("robot"));
    files.write("robot/skills.proskill", R"((defplatform "robot.json")
(defskill fly :time_interval [1,9] :action (fly) :success there))");
    files.write("mission.proskill", R"((include "robot/skills.proskill")
(defskill mission :success done :body ((case (fly) ((success there) (success done))))))");
    if (!platform.empty()) files.write("robot/robot.json", platform);
  }

  /// The output has paths from the folder on. The last argument is a file in it.
  [[nodiscard]] test::Finished call(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), PROSKILL_PROGRAM);
    arguments.back() = path(arguments.back());
    auto done = test::run(arguments);
    for (auto* text : {&done.out, &done.err}) removeAll(*text, path("") + "/");
    return done;
  }
  [[nodiscard]] test::Finished run(std::vector<std::string> arguments = {}) const {
    arguments.insert(arguments.begin(), "run");
    arguments.push_back("mission.proskill");
    return call(arguments);
  }
  void write(const std::string& name, const std::string& text) const { files.write(name, text); }
  [[nodiscard]] std::string path(const std::string& name) const { return files.path(name); }

private:
  static void removeAll(std::string& text, const std::string& part) {
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at))
      text.erase(at, part.size());
  }

  test::TemporaryDirectory files;
};

bool hasPart(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("run takes the platform that the program names, and an option wins") {
  const NamedPlatform named(R"({"actions": {"fly": {"duration": [3, 3]}}})");
  CHECK(hasPart(named.run().out, "has ended after 3 s"));
  named.write("other.json", R"({"actions": {"fly": {"duration": [4, 4]}}})");
  CHECK(hasPart(named.run({"--platform", named.path("other.json")}).out, "has ended after 4 s"));
  const auto without = named.run({"--no-platform"});
  CHECK(without.exitCode == 0);
  CHECK_FALSE(hasPart(without.out, "has ended after 3 s"));
}

TEST_CASE("the program of a platform that is named is started where its file is") {
  const NamedPlatform named(R"({"kind": "process", "command": ["sh", "robot.sh"]})");
  named.write("robot/robot.sh", kReadyRobot + R"(read -r start; pwd >&2
                          echo '{"type":"result","run":1,"result":"there"}'; cat > heard)");
  const auto done = named.run({"--no-record"});
  INFO(done.out << done.err);
  CHECK(done.exitCode == 1); // it is sooner than its interval
  CHECK(hasPart(done.err, "robot\n"));
  CHECK(hasPart(done.out, "mission: success"));
}

TEST_CASE("a script needs a simulation, also where the program names a platform") {
  const NamedPlatform named(R"({"kind": "process", "command": ["sh", "robot.sh"]})");
  named.write("script.json", "{}");
  const auto done = named.run({"--script", named.path("script.json")});
  CHECK(done.exitCode == 2);
  CHECK(done.err == "error: `--script` is for simulations: add `--no-platform`\n");
  CHECK(named.run({"--script", named.path("script.json"), "--no-platform"}).exitCode == 0);
}

TEST_CASE("run says what is wrong with the platform that the program names") {
  const NamedPlatform missing("");
  auto done = missing.run();
  CHECK(done.exitCode == 2);
  CHECK(done.err == "robot/skills.proskill:1:15: error: cannot read `robot/robot.json`: no such "
                    "file or directory\n");
  const NamedPlatform wrong(R"({"actions": {"flie": {}}, "events": 3})");
  done = wrong.run();
  CHECK(done.exitCode == 2);
  CHECK(done.err == "error: robot/robot.json:1:14: there is no basic skill `flie`\n"
                    "error: robot/robot.json:1:37: `events` must be an object\n");
}

TEST_CASE("check reports the platform that the program names, verify does not read it") {
  const NamedPlatform wrong(R"({"actions": {"flie": {}}})");
  auto done = wrong.call({"check", "--format", "short", "mission.proskill"});
  CHECK(done.exitCode == 1);
  CHECK(done.out == "robot/skills.proskill:1:15: error[PS1402]: `robot.json`:1:14: there is no "
                    "basic skill `flie`\n");
  CHECK(wrong.call({"verify", "mission.proskill"}).exitCode ==
        NamedPlatform("{}").call({"verify", "mission.proskill"}).exitCode);
  CHECK(NamedPlatform("{}").call({"check", "mission.proskill"}).exitCode == 0);
  done = NamedPlatform("").call({"check", "--format", "short", "mission.proskill"});
  CHECK(done.out == "robot/skills.proskill:1:15: error[PS1401]: cannot read the platform "
                    "`robot.json`: no such file or directory\n");
}

TEST_CASE("a part of a program is checked without its platform's actions") {
  const NamedPlatform wrong(R"({"actions": {"other": {}}})");
  CHECK(wrong.call({"check", "--fragment", "robot/skills.proskill"}).exitCode == 0);
}
