#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <signal.h>
#include <sstream>
#include <sys/stat.h>

using namespace proskill;
using Json = nlohmann::json;

namespace {

const std::string kRunTree = PROSKILL_SOURCE_DIR;
const std::string kDockToRun = kRunTree + "/docs/tour/dock.proskill";

test::Finished executed(std::vector<std::string> arguments, const test::RunOptions& options = {}) {
  arguments.insert(arguments.begin(), {PROSKILL_PROGRAM, "run"});
  return test::run(arguments, options);
}

std::string recordedIn(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

} // namespace

TEST_CASE("run works on every example with nothing else") {
  std::size_t programs = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kRunTree + "/examples")) {
    if (entry.path().extension() != ".proskill") continue;
    const auto done = executed({entry.path().string()});
    if (done.exitCode == 2) {
      CHECK(done.err.find("unknown") != std::string::npos); // a part of a program
      continue;
    }
    INFO(entry.path() << "\n" << done.err << done.out.substr(0, 2000));
    CHECK((done.exitCode == 0 || done.exitCode == 1 || done.exitCode == 3));
    CHECK(done.out.find(" steps") != std::string::npos);
    ++programs;
  }
  CHECK(programs >= 6);
}

TEST_CASE("run prints a JSON object a line") {
  const auto done = executed({"--format", "json", kDockToRun});
  CHECK(done.exitCode == 0);
  std::istringstream lines(done.out);
  std::vector<Json> all;
  for (std::string line; std::getline(lines, line);) all.push_back(Json::parse(line));
  REQUIRE(all.size() > 5);
  CHECK(all.front()["kind"] == "step");
  CHECK(all.front()["actor"] == "recharge");
  CHECK(all.front()["location"]["begin"]["line"] == 23);
  CHECK(all.back()["kind"] == "end");
  CHECK(all.back()["mission"] == "success");
}

TEST_CASE("a recording in a pipe is refused at once") {
  const test::TemporaryDirectory files;
  const auto pipe = files.path("pipe.mcap");
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  const auto done = executed({"--record", pipe, kDockToRun});
  CHECK(done.exitCode == 2);
  CHECK(done.err.find("cannot be written: it is a pipe") != std::string::npos);
}

TEST_CASE("run follows a script") {
  const test::TemporaryDirectory files;
  const auto script = files.write("script.json", R"({
    "actions": {"drive_onto_dock": [{"result": "docked", "after": 3}]},
    "signals": [{"at": 5, "event": "pushed_away"}]})");
  const auto done = executed({"--script", script, kDockToRun});
  CHECK(done.exitCode == 1);
  CHECK(done.out.find("3 s  drive_onto_dock  succeeds with `docked`") != std::string::npos);
  CHECK(done.out.find("5 s  charge           finds its invariant `at_dock` violated") !=
        std::string::npos);
  CHECK(done.out.find("5 s  recharge         fails with `gave_up`") != std::string::npos);
}

TEST_CASE("run says what is wrong with a script or a platform") {
  const test::TemporaryDirectory files;
  const auto wrong = [&](const std::string& option, const std::string& text) {
    const auto done = executed({option, files.write("file.json", text), kDockToRun});
    CHECK(done.exitCode == 2);
    return done.err;
  };
  const auto says = [](const std::string& text, const std::string& part) {
    INFO(text);
    CHECK(text.find(part) != std::string::npos);
  };
  says(wrong("--script", R"({"signals":[{"at":1,"event":"pushed_awy"}]})"),
       "there is no event `pushed_awy`; did you mean `pushed_away`?");
  says(wrong("--script", R"({"actions":{"charge":[{"result":"empty"}]}})"),
       "there is no result of `charge` `empty`");
  says(wrong("--script", "[]"), "it is not an object");
  says(wrong("--platform", R"({"actions":{"charge":{"duration":[3,2]}}})"),
       "`charge.duration` ends before it begins");
  says(wrong("--platform", R"({"kind":"magic"})"),
       "`kind` must be `simulated`, `process`, `library`, `ros1` or `ros2`, not `magic`");
  says(wrong("--platform", "{\n  \"kind\":"), ":2:10: it is not JSON");
  says(wrong("--platform", R"({"action":{}})"), "did you mean `actions`?");
}

TEST_CASE("run records a trace that others open") {
  const test::TemporaryDirectory files;
  const auto path = files.path("run.json");
  CHECK(executed({"--record", path, kDockToRun}).exitCode == 0);
  const auto recorded = Json::parse(recordedIn(path));
  CHECK(recorded["initial"]["place"] == "Floor");
  CHECK(recorded["steps"].size() == 14);
  CHECK(recorded["steps"][0]["actor"] == "recharge");
  CHECK(recorded["steps"][3]["remark"] == "started");
  CHECK(recorded["steps"][3]["action"]["command"] == "drive");
}

TEST_CASE("a run that is killed leaves a recording that can be read") {
  const test::TemporaryDirectory files;
  const auto path = files.path("run.json");
  const auto endless = files.write("endless.proskill", "(defskill m :body ((while true (^ 1))))");
  for (const std::string clock : {"real", "1000x", "simulated"}) {
    const auto killed =
        executed({"--clock", clock, "--record", path, clock == "real" ? kDockToRun : endless},
                 {.onOutput = [](int process) { kill(process, SIGKILL); }});
    INFO(clock);
    CHECK(killed.exitCode == 128 + SIGKILL);
    const auto recorded = Json::parse(recordedIn(path));
    CHECK(recorded["steps"].is_array());
  }
}

TEST_CASE("a run of a day is recorded whole, in as much memory as a short one") {
  const test::TemporaryDirectory files;
  const auto path = files.path("run.json");
  const auto day = files.write("day.proskill", "(defskill m :body ((while true (^ 1))))");
  const auto done = executed({"--until", "1d", "--format", "json", "--record", path, day});
  const auto steps = Json::parse(done.out.substr(done.out.rfind("\n{") + 1))["steps"];
  CHECK(steps > 100'000);
  CHECK(Json::parse(recordedIn(path))["steps"].size() == steps);
  constexpr std::size_t kMost = 128'000; // KiB of address space; the recording is larger
  CHECK(std::filesystem::file_size(path) / 1024 > kMost / 4);
  const auto small =
      test::run({"/bin/sh", "-c",
                 "ulimit -v 128000; exec " PROSKILL_PROGRAM " run --until 1d --record " + path +
                     " " + day + " | tail -n 1"});
  CHECK(small.out.find("the time limit was reached after 86400 s") == 0);
  CHECK(small.err.empty());
}

TEST_CASE("run ends in order when it is asked to") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const auto ended = executed({"--clock", "real", "--format", "json", kDockToRun},
                                {.onOutput = [signal](int process) { kill(process, signal); }});
    INFO(ended.out << ended.err);
    CHECK(ended.exitCode == 3);
    CHECK(ended.out.find("stopped: every action has ended") != std::string::npos);
  }
}

TEST_CASE("a run whose output nobody reads any more ends in order") {
  const test::TemporaryDirectory files;
  const auto path = files.path("run.json");
  const auto chatty =
      files.write("chatty.proskill", "(defskill act :action (act) :interrupt ()) (defskill m :body "
                                     "((// ((act)) ((while true (^ 0.01))))))");
  const auto platform = files.write("platform.json", R"({"actions":{"act":{"duration":[600,600],)"
                                                     R"("stops":[0.02,0.02]}}})");
  const auto done = test::run({"/bin/bash", "-c",
                               PROSKILL_PROGRAM " run --clock real --until 600 --platform " +
                                   platform + " --record " + path + " " + chatty +
                                   " | head -n 30 >/dev/null; exit ${PIPESTATUS[0]}"});
  INFO(done.out << done.err);
  CHECK(done.exitCode == 3);
  const auto recorded = recordedIn(path);
  const auto asked = recorded.find("asked to end: actions are stopped");
  REQUIRE(asked != std::string::npos);
  CHECK(recorded.find("the platform is asked to stop its action", asked) != std::string::npos);
}

TEST_CASE("a run that nohup protects goes on without its terminal") {
  const test::TemporaryDirectory files;
  const auto waits = files.write("waits.proskill", "(defskill m :body ((^ 0.3)))");
  const auto done =
      test::run({"/bin/sh", "-c",
                 "trap '' HUP; exec " PROSKILL_PROGRAM " run --clock real --format json " + waits},
                {.onOutput = [](int process) { kill(process, SIGHUP); }});
  INFO(done.out << done.err);
  CHECK(done.exitCode == 0);
}

TEST_CASE("conform reads MCAP, whole or cut off") {
  const test::TemporaryDirectory files;
  const auto path = files.path("run.mcap");
  executed({"--seed", "3", "--record", path, kDockToRun});
  const auto conform = [&](const std::string& recording) {
    return test::run({PROSKILL_PROGRAM, "conform", recording, kDockToRun});
  };
  const auto good = conform(path);
  INFO(good.out << good.err);
  CHECK(good.out.find("the run conforms to the model: ") == 0);
  CHECK(good.exitCode == 0);
  const auto whole = recordedIn(path);
  for (std::size_t length = whole.size() / 2; length < whole.size(); length += 311) {
    const auto cut = conform(files.write("cut.mcap", whole.substr(0, length)));
    INFO(length << "\n" << cut.out << cut.err);
    CHECK(cut.exitCode == 0);
  }
  CHECK(conform(files.write("short.mcap", whole.substr(0, 20))).exitCode == 2);
}

TEST_CASE("conform distinguishes files with the same name, wherever the program is now") {
  const test::TemporaryDirectory files;
  const auto main = [&](const std::string& folder) {
    std::filesystem::create_directories(files.path(folder + "/a"));
    std::filesystem::create_directories(files.path(folder + "/b"));
    files.write(folder + "/a/s.proskill", "(defskill one :time_interval [1,2] :action (one))");
    files.write(folder + "/b/s.proskill", "\n(defskill two :time_interval [1,2] :action (two))");
    return files.write(folder + "/m.proskill",
                       "(include \"a/s.proskill\")(include \"b/s.proskill\")"
                       "(defskill m :body ((one) (two)))");
  };
  const auto here = main("here");
  const auto there = main("there");
  for (const std::string recording : {"run.json", "run.mcap"}) {
    const auto path = files.path(recording);
    executed({"--record", path, here});
    for (const auto& program : {here, there}) {
      const auto done = test::run({PROSKILL_PROGRAM, "conform", path, program});
      INFO(program << "\n" << done.out << done.err);
      CHECK(done.exitCode == 0);
    }
  }
}

TEST_CASE("conform learns intervals, and names the properties that change") {
  const auto late = kRunTree + "/docs/tour/late.json";
  const auto done =
      test::run({PROSKILL_PROGRAM, "conform", "--learn", "--also", late, late, kDockToRun});
  INFO(done.out << done.err);
  CHECK(done.exitCode == 1);
  CHECK(done.out.find("`drive_onto_dock` took 6.2 s in 2 runs of its action; it promises "
                      "[2,5]\nwith [2,6.2] for `drive_onto_dock` 1 property changes\n") !=
        std::string::npos);
  CHECK(done.out.find("`recharge` takes at most 25 s from its start: holds → violated\n") !=
        std::string::npos);
  const test::TemporaryDirectory files;
  const auto path = files.path("run.json");
  executed({"--seed", "3", "--record", path, kDockToRun});
  const auto kept = test::run({PROSKILL_PROGRAM, "conform", "--learn", path, kDockToRun});
  CHECK(kept.out.find("every action kept its interval: there is nothing to learn\n") !=
        std::string::npos);
  CHECK(kept.exitCode == 0);
}

TEST_CASE("conform judges a recording of the program before an edit") {
  const test::TemporaryDirectory files;
  const std::string skills = "(defskill fly :time_interval [1,2] :action (fly))"
                             "(defskill m :body ((fly)))";
  const auto program = files.write("m.proskill", skills);
  const auto recording = files.path("run.mcap");
  executed({"--record", recording, program});
  files.write("m.proskill", "; since today\n" + skills);
  const auto strict = test::run({PROSKILL_PROGRAM, "conform", recording, program});
  INFO(strict.out << strict.err);
  CHECK(strict.exitCode == 1);
  CHECK(strict.out.ends_with("`--edited` ignores the places of steps\n"));
  CHECK(test::run({PROSKILL_PROGRAM, "conform", "--edited", recording, program}).exitCode == 0);
}

TEST_CASE("a recording that somebody removes or replaces during the run is missed") {
  const test::TemporaryDirectory files;
  const auto path = files.path("run.mcap");
  const auto waits = files.write("waits.proskill", "(defskill m :body ((^ 0.2)))");
  for (const bool isReplaced : {false, true}) {
    const auto done = test::run(
        {PROSKILL_PROGRAM, "run", "--clock", "real", "--record", path, "--format", "json", waits},
        {.onOutput = [&](int) {
          std::filesystem::remove(path);
          if (isReplaced) files.write("run.mcap", "of another run");
        }});
    INFO(done.out << done.err);
    CHECK(done.exitCode == 2);
    CHECK(done.err.find(path + " was removed or replaced during the run: the recording is lost") !=
          std::string::npos);
  }
}

TEST_CASE("a recording in the place of a program is called one") {
  const test::TemporaryDirectory files;
  for (const std::string name : {"run.json", "run.mcap"}) {
    const auto recording = files.path(name);
    executed({"--record", recording, kDockToRun});
    for (const std::string command : {"run", "verify", "conform"}) {
      std::vector<std::string> line{PROSKILL_PROGRAM, command};
      if (command == "conform") line.push_back(kDockToRun);
      line.push_back(recording);
      const auto done = test::run(line);
      INFO(command << "\n" << done.out << done.err);
      CHECK(done.exitCode == 2);
      CHECK(done.err.find("is not a program, but a ") != std::string::npos);
      CHECK(std::ranges::count(done.err, '\n') == 1);
    }
  }
}

TEST_CASE("conform lists what it could not decide with the intervals that it learnt") {
  const auto late = kRunTree + "/docs/tour/late.json";
  const auto done = test::run(
      {PROSKILL_PROGRAM, "conform", "--learn", "--time-limit", "0.000001", late, kDockToRun});
  INFO(done.out << done.err);
  CHECK(done.exitCode == 1);
  CHECK(done.out.find("with [2,6.2] for `drive_onto_dock` no properties change\n") !=
        std::string::npos);
  CHECK(done.out.find(" properties were not decided in 1e-06 s (--time-limit):\n") !=
        std::string::npos);
  CHECK(done.out.find("  ? `recharge` takes at most 25 s from its start\n") != std::string::npos);
}

TEST_CASE("an empty name of a file is an error, and nothing is run") {
  for (const std::string option : {"--record", "--platform", "--script"}) {
    const auto done = executed({option, "", kDockToRun});
    INFO(option << "\n" << done.out << done.err);
    CHECK(done.exitCode == 2);
    CHECK(done.out.empty());
    CHECK(done.err.find(option + ": the name of the file is empty") != std::string::npos);
  }
}

TEST_CASE("what a run decides about the program's properties is reported, and decides its exit") {
  const auto watched = kRunTree + "/docs/tour/watched.proskill";
  const auto text = executed({watched});
  INFO(text.out);
  CHECK(text.exitCode == 1);
  CHECK(text.out.find("violated: (always (place Dock))") != std::string::npos);
  CHECK(text.out.find("prints \"it stands on the Floor\"") != std::string::npos);
  CHECK(text.out.find("✗ stays_on_dock: false since 2 s\n") != std::string::npos);
  CHECK(text.out.find("… comes_back: not yet\n") != std::string::npos);
  CHECK(text.out.find("✓ ends: true since 3 s\n") != std::string::npos);
  const auto json = executed({"--format", "json", watched});
  const auto end =
      nlohmann::json::parse(json.out.substr(json.out.rfind('\n', json.out.size() - 2) + 1));
  CHECK(end["bad"] == 1);
  CHECK(end["properties"][0]["verdict"] == "false");
  CHECK(end["properties"][0]["date"] == "2");
  CHECK(end["properties"][1]["verdict"] == "not yet");
  CHECK(end["properties"][1]["date"].is_null());
}

TEST_CASE("conform judges recordings, whole or cut off") {
  const test::TemporaryDirectory files;
  const auto path = files.path("run.json");
  executed({"--seed", "3", "--record", path, kDockToRun});
  const auto conform = [&](const std::string& recording, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {PROSKILL_PROGRAM, "conform", recording, kDockToRun});
    return test::run(more);
  };
  const auto good = conform(path);
  CHECK(good.out.find("the run conforms to the model: ") == 0);
  CHECK(good.exitCode == 0);
  const auto whole = recordedIn(path);
  for (std::size_t length = whole.size() / 3; length < whole.size(); length += 97) {
    const auto cut = conform(files.write("cut.json", whole.substr(0, length)));
    INFO(length << "\n" << cut.out << cut.err);
    CHECK(cut.exitCode == 0);
  }
  CHECK(conform(kRunTree + "/docs/tour/late.json").exitCode == 1);
  CHECK(conform(kRunTree + "/docs/tour/late.json", {"--tolerance", "1.5"}).exitCode == 0);
  CHECK(conform(kRunTree + "/docs/tour/late.json", {"--tolerance", "0"}).exitCode == 1);
  const auto negative = conform(kRunTree + "/docs/tour/late.json", {"--tolerance=-1"});
  CHECK(negative.exitCode == 2);
  CHECK(negative.err.find("`-1` is not a number of seconds from 0 to 1e9") != std::string::npos);
  CHECK(conform(files.write("no.json", "{}")).exitCode == 2);
  CHECK(conform(files.path("missing.json")).exitCode == 2);
}
