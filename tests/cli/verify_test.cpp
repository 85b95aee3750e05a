#include "tests/cli/forbidden_move.h"
#include "tests/support/chain_program.h"
#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <csignal>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

namespace proskill::test::verify_test {

using Json = nlohmann::json;

namespace {

const std::string kDrone = PROSKILL_SOURCE_DIR "/examples/drone/drone.proskill";

/// A lamp that is switched on and may fail; all default properties are good.
constexpr auto kGood = R"((defsv lamp :states (Off On) :init Off)
(defskill switch_on
  :time_interval [1,2]
  :action (on)
  :success lit (:effects (lamp On)))
(defskill mission
  :body ((switch_on)
         (^ (lamp On))))
)";

Finished verify(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {PROSKILL_PROGRAM, "verify"});
  return run(arguments);
}

const Json& property(const Json& report, const std::string& name) {
  const auto& all = report["properties"];
  auto found = std::ranges::find_if(all, [&](const Json& row) { return row["name"] == name; });
  REQUIRE(found != all.end());
  return *found;
}

std::string contents(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

TEST_CASE("verdicts are kept where the user says, and it is said where they cannot be") {
  const TemporaryDirectory files;
  const auto directory = files.path("kept");
  const auto first = verify({"--cache", directory, "--traces", "none", kDrone});
  CHECK(first.out.find("known from before") == std::string::npos);
  const auto second = verify({"--cache", directory, "--traces", "none", kDrone});
  CHECK(second.exitCode == first.exitCode);
  CHECK(second.out.find(" of 86 verdicts were known from before") != std::string::npos);
  const auto verdicts = [](const std::string& out) {
    return out.substr(0, out.rfind('\n', out.rfind(" classes,"))); // without the last line
  };
  CHECK(verdicts(second.out) == verdicts(first.out));
  const auto blocked = verify({"--cache", files.write("file", "") + "/below", kDrone});
  CHECK(blocked.exitCode == first.exitCode);
  CHECK(blocked.err.find("warning: verdicts are not kept: the directory") != std::string::npos);
}

TEST_CASE("a program that is all good ends with 0") {
  TemporaryDirectory files;
  auto result = verify({files.write("good.proskill", kGood)});
  CHECK(result.exitCode == 0);
  CHECK(result.err.empty());
  CHECK(result.out.find("violated") == std::string::npos);
  CHECK(result.out.find("inconclusive") == std::string::npos);
}

TEST_CASE("with --durations the report says how long skills take") {
  TemporaryDirectory files;
  const auto path = files.write("good.proskill", kGood);
  const auto text = verify({"--durations", path}).out;
  CHECK(text.find("durations, over all runs\n  switch_on  1 to 2 s\n  mission    1 to 2 s\n") !=
        std::string::npos);
  CHECK(verify({path}).out.find("durations") == std::string::npos);
  const auto stops =
      files.write("stops.proskill",
                  "(defsv v :states (A B) :init A) (defevent e :effects (v B))\n"
                  "(defskill drive :precondition (p (v B)) :time_interval [1,1] :action (x))\n"
                  "(defskill m :body ((while (/= drive.status success) (drive))))\n");
  CHECK(verify({"--durations", stops})
            .out.find("durations, over runs in which time goes on: `program.time_progress` is "
                      "violated\n") != std::string::npos);
  const auto json = Json::parse(verify({"--durations", "--format", "json", path}).out)["durations"];
  REQUIRE(json.size() == 2);
  CHECK(json[0]["skill"] == "switch_on");
  CHECK(json[0]["text"] == "1 to 2 s");
  CHECK(json[0]["shortest"]["value"]["exact"] == "1");
  CHECK(json[0]["longest"]["value"]["strict"] == false);
  const auto kept = files.path("kept");
  const auto first = verify({"--durations", "--cache", kept, path}).out;
  const auto second = verify({"--durations", "--cache", kept, path}).out;
  CHECK(first.substr(0, first.find(" properties")) == second.substr(0, second.find(" properties")));
}

TEST_CASE("with --explain-size the report says what multiplies the states, also within a limit") {
  TemporaryDirectory files;
  const auto path = files.write(
      "day.proskill", "(defsv go :states (Yes No) :init Yes)\n(defevent stop :effects (go No))\n"
                      "(defskill look :time_interval [1,2] :action (l))\n"
                      "(defskill m :time_interval [43200,86400]\n"
                      "  :body ((while (go Yes) (look) (^ 1))))\n");
  const auto text = verify({"--explain-size", "--class-limit", "500", path}).out;
  CHECK(text.find("where the states come from\n  There are more classes") != std::string::npos);
  CHECK(text.find("× watchdog of m: ") != std::string::npos);
  CHECK(text.find(path + ":4:28") != std::string::npos);
  const auto json =
      Json::parse(verify({"--explain-size", "--format", "json", "--class-limit", "500", path}).out);
  const auto& size = json["size"];
  CHECK(size["complete"] == false);
  CHECK(size["parts"][0]["name"] == "watchdog of m");
  CHECK(size["parts"][0]["factor"].get<double>() > 10);
  CHECK(size["parts"][0]["location"]["begin"]["line"] == 4);
  CHECK(size["kinds"][0]["name"] == "all watchdogs");
  CHECK_FALSE(json["exploration"]["stopped"].get<std::string>().empty());
}

TEST_CASE("a violation ends with 1 and shows its trace, every step with its place") {
  TemporaryDirectory files;
  auto path = files.write("bad.proskill", kForbiddenMove);
  auto result = verify({path});
  CHECK(result.exitCode == 1);
  CHECK(result.out.find("`lamp` makes no forbidden move: violated") != std::string::npos);
  CHECK(result.out.find("lamp: Off → Broken") != std::string::npos);
  CHECK(result.out.find(path + ":5:27") != std::string::npos);
}

TEST_CASE("the report as JSON has verdicts, traces and what was explored") {
  TemporaryDirectory files;
  auto path = files.write("bad.proskill", kForbiddenMove);
  auto report = Json::parse(verify({path, "--format", "json"}).out);
  CHECK(report["version"] == 1);
  CHECK(report["main"] == "mission");
  CHECK(report["exploration"]["complete"] == true);
  CHECK(report["exploration"]["classes"].get<int>() > 0);
  const auto& row = property(report, "lamp.no_forbidden_transition");
  CHECK(row["verdict"] == "violated");
  CHECK(row["severity"] == "error");
  const auto& steps = row["trace"]["steps"];
  REQUIRE(!steps.empty());
  for (const auto& step : steps) {
    CHECK(step["location"]["file"] == path);
    CHECK(!step["actor"].get<std::string>().empty());
    CHECK(!step["description"].get<std::string>().empty());
    CHECK(!step["transitions"].empty());
  }
  CHECK(row["trace"]["initial"]["lamp"] == "Off");
  CHECK(steps.back()["changes"][0] ==
        Json{{"variable", "lamp"}, {"before", "Off"}, {"after", "Broken"}});
  CHECK(steps.back()["earliest"]["exact"] == "1");
  CHECK(steps.back()["latest"]["exact"] == "2");
}

TEST_CASE("a report contains the traces that --traces asks for, whatever its format") {
  const auto tracesOf = [](const std::string& which) {
    const auto report = Json::parse(verify({kDrone, "--format", "json", "--traces", which}).out);
    std::set<std::string> found;
    for (const auto& row : report["properties"])
      if (!row["trace"].is_null()) found.insert(row["verdict"].get<std::string>());
    return found;
  };
  CHECK(tracesOf("all") == std::set<std::string>{"reachable", "violated"});
  CHECK(tracesOf("failed") == std::set<std::string>{"violated"});
  CHECK(tracesOf("none").empty());
  CHECK(verify({kDrone, "--format", "sarif"}).out.contains("codeFlows"));
  CHECK_FALSE(verify({kDrone, "--format", "sarif", "--traces", "none"}).out.contains("codeFlows"));
  const auto failed = verify({kDrone, "--format", "json"}).out;
  CHECK(failed == nlohmann::ordered_json::parse(failed).dump(2) + "\n");
}

TEST_CASE("the page of a large program leaves out traces, and says so") {
  TemporaryDirectory files;
  const auto path = files.write("chain.proskill", chainProgram(60));
  const auto page = files.path("report");
  CHECK(verify({path, "--report", page}).exitCode == 0);
  const auto bounded = contents(page + "/index.html");
  CHECK(bounded.size() < 40'000'000);
  CHECK(bounded.contains("this page would be too large"));
  CHECK(verify({path, "--report", page, "--traces", "all"}).exitCode == 0);
  const auto whole = contents(page + "/index.html");
  CHECK(whole.size() > bounded.size());
  CHECK_FALSE(whole.contains("this page would be too large"));
}

TEST_CASE("the drone's verdicts are all decided, and are those of the paper") {
  auto result = verify({kDrone, "--format", "json", "--traces", "all"});
  CHECK(result.exitCode == 1);
  CHECK(result.peakKiB < 1024 * 1024);
  auto report = Json::parse(result.out);
  CHECK(report["exploration"]["stopped"] == "all questions decided");
  for (const auto& row : report["properties"]) {
    CAPTURE(row["name"].get<std::string>());
    CHECK(row["verdict"] != "inconclusive");
    bool hasTrace = !row["trace"].is_null();
    CHECK(hasTrace == (row["verdict"] == "violated" || row["verdict"] == "reachable"));
  }
  CHECK(property(report, "landing.invariant_may_fail.in_control")["verdict"] == "unreachable");
  CHECK(property(report, "uav_mission.no_undershoot")["verdict"] == "violated");
  CHECK(property(report, "uav_mission.no_overshoot")["verdict"] == "violated");
  CHECK(property(report, "battery.no_forbidden_transition")["verdict"] == "violated");
  CHECK(property(report, "takeoff.can_succeed.at_altitude")["verdict"] == "reachable");
}

TEST_CASE("only the properties that are named are asked") {
  TemporaryDirectory files;
  auto path = files.write("bad.proskill", kForbiddenMove);
  auto report = Json::parse(verify({path, "--property", "kick", "--format", "json"}).out);
  CHECK(!report["properties"].empty());
  for (const auto& row : report["properties"]) CHECK(row["subject"] == "kick");
  CHECK(Json::parse(verify({"--property", "kick", path, "--format", "json"}).out)["properties"] ==
        report["properties"]);
  auto wrong = verify({path, "--property", "kik"});
  CHECK(wrong.exitCode == 2);
  CHECK(wrong.err.find("`kik`") != std::string::npos);
}

TEST_CASE("one property is counted in the singular") {
  const auto one = verify({"--property", "target.no_forbidden_transition", kDrone});
  CHECK(one.out.find("\n1 property: ") != std::string::npos);
}

TEST_CASE("a date that is no decimal is rounded, and its fraction follows") {
  const auto dock = verify({PROSKILL_SOURCE_DIR "/docs/tour/dock.proskill"});
  CHECK(dock.out.find("In step 9, at about 2.09 s (23/11), watchdog of recharge") !=
        std::string::npos);
}

TEST_CASE("if several skills could be the mission, the error names the option that chooses") {
  const TemporaryDirectory files;
  const auto path = files.write("two.proskill", R"(
    (defskill morning :body ((^ 1)))
    (defskill evening :body ((^ 2))))");
  const auto two = verify({path});
  CHECK(two.exitCode == 2);
  CHECK(two.err.find("error: several skills could be the mission: `morning`, `evening`\n"
                     "  = help: choose one with `--main SKILL`\n") != std::string::npos);
  CHECK(verify({"--main", "evening", path}).exitCode != 2);
}

TEST_CASE("a limit that is met leaves the rest inconclusive and ends with 3") {
  TemporaryDirectory files;
  auto path = files.write("good.proskill", kGood);
  auto result = verify({path, "--class-limit", "1", "--format", "json"});
  CHECK(result.exitCode == 3);
  auto report = Json::parse(result.out);
  CHECK(report["exploration"]["complete"] == false);
  CHECK(!report["exploration"]["stopped"].get<std::string>().empty());
  CHECK(std::ranges::any_of(report["properties"], [](const Json& row) {
    return row["verdict"] == "inconclusive" && !row["reason"].get<std::string>().empty();
  }));
  CHECK(verify({path, "--class-limit", "1"}).out.find("`--class-limit` raises it") !=
        std::string::npos);
}

TEST_CASE("a violation that was found before a limit counts") {
  auto result = verify({kDrone, "--reduce", "none", "--class-limit", "2000", "--format", "json"});
  CHECK(result.exitCode == 1);
  auto report = Json::parse(result.out);
  CHECK(property(report, "battery.no_forbidden_transition")["verdict"] == "violated");
}

TEST_CASE("the former name of a reduction is taken, with a hint") {
  TemporaryDirectory files;
  auto good = files.write("good.proskill", kGood);
  const auto former = verify({good, "--reduce", "safe-steps,inclusion"});
  CHECK(former.exitCode == 0);
  CHECK(former.err.find("hint: the reduction `safe-steps` is called `stubborn-sets` now") !=
        std::string::npos);
  const auto today = verify({good, "--reduce", "stubborn-sets,free-inputs"});
  CHECK(today.exitCode == 0);
  CHECK(today.err.find("hint") == std::string::npos);
}

TEST_CASE("bad usage, missing files and programs with errors end with 2") {
  TemporaryDirectory files;
  auto good = files.write("good.proskill", kGood);
  CHECK(verify({}).exitCode == 2);
  CHECK(verify({good, "--format", "yaml"}).exitCode == 2);
  CHECK(verify({good, "--reduce", "magic"}).exitCode == 2);
  CHECK(verify({good, "--main", "nobody"}).exitCode == 2);
  auto missing = verify({files.path("missing.proskill")});
  CHECK(missing.exitCode == 2);
  CHECK(missing.err.find("missing.proskill") != std::string::npos);
  auto broken = verify({files.write("broken.proskill", "(defskill a :body ((nobody)))")});
  CHECK(broken.exitCode == 2);
  CHECK(broken.err.find("nobody") != std::string::npos);
}

TEST_CASE("JUnit has a test case a property, and a failure for the bad one") {
  TemporaryDirectory files;
  auto result = verify({files.write("bad.proskill", kForbiddenMove), "--format", "junit"});
  CHECK(result.exitCode == 1);
  CHECK(result.out.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>"));
  CHECK(result.out.find("<failure type=\"violated\"") != std::string::npos);
  CHECK(result.out.find("<testsuite name=\"lamp\" tests=\"1\" failures=\"1\"") !=
        std::string::npos);
}

TEST_CASE("SARIF has a result with the trace as a code flow") {
  TemporaryDirectory files;
  auto log =
      Json::parse(verify({files.write("bad.proskill", kForbiddenMove), "--format", "sarif"}).out);
  CHECK(log["version"] == "2.1.0");
  const auto& results = log["runs"][0]["results"];
  auto bad = std::ranges::find_if(
      results, [](const Json& row) { return row["ruleId"] == "no_forbidden_transition"; });
  REQUIRE(bad != results.end());
  CHECK((*bad)["level"] == "error");
  const auto& steps = (*bad)["codeFlows"][0]["threadFlows"][0]["locations"];
  CHECK(steps.back()["location"]["physicalLocation"]["region"]["startLine"] == 5);
}

TEST_CASE("traces are saved as JSON and text") {
  TemporaryDirectory files;
  auto path = files.write("bad.proskill", kForbiddenMove);
  verify({path, "--save-traces", files.path("deep/traces")});
  auto base = files.path("deep/traces/lamp.no_forbidden_transition");
  auto trace = Json::parse(contents(base + ".json"));
  CHECK(trace["description"] == "`lamp` makes no forbidden move");
  CHECK(trace["verdict"] == "violated");
  CHECK(!trace["steps"].empty());
  CHECK(contents(base + ".txt").find("Off → Broken") != std::string::npos);
}

TEST_CASE("traces that cannot be saved are an error, after the report") {
  TemporaryDirectory files;
  auto path = files.write("bad.proskill", kForbiddenMove);
  auto result = verify({path, "--save-traces", path + "/below/a/file"});
  CHECK(result.exitCode == 2);
  CHECK(result.err.find("cannot create the directory") != std::string::npos);
  CHECK(result.out.find("violated") != std::string::npos);
}

TEST_CASE("a full disk is an error") {
  auto full =
      run({"/bin/sh", "-c",
           std::string(PROSKILL_PROGRAM) + " verify --class-limit 100 " + kDrone + " >/dev/full"});
  CHECK(full.exitCode == 2);
  CHECK(full.err.find("could not be written") != std::string::npos);
}

TEST_CASE("the graph of classes is counted as sift prints it") {
  TemporaryDirectory files;
  auto result = verify({files.write("good.proskill", kGood), "--graph", "counts"});
  CHECK(result.exitCode == 0);
  CHECK(result.out.find(" classe(s), ") != std::string::npos);
  CHECK(result.out.find(" transition(s)\n") != std::string::npos);
}

TEST_CASE("Ctrl-C on a terminal with its line of progress keeps what is decided") {
  int terminal = -1;
  auto child = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    execl(PROSKILL_PROGRAM, PROSKILL_PROGRAM, "verify", "--reduce", "none", "--traces", "none",
          kDrone.c_str(), nullptr);
    _exit(127);
  }
  std::string seen;
  char buffer[4096];
  bool interrupted = false;
  for (auto count = read(terminal, buffer, sizeof buffer); count > 0;
       count = read(terminal, buffer, sizeof buffer)) {
    seen.append(buffer, static_cast<std::size_t>(count));
    if (!interrupted && seen.find("classes/s") != std::string::npos) {
      kill(child, SIGINT);
      interrupted = true;
    }
  }
  int status = 0;
  waitpid(child, &status, 0);
  close(terminal);
  CHECK(interrupted);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 1);
  CHECK(seen.find("`battery` makes no forbidden move: \x1b[1;31mviolated") != std::string::npos);
  CHECK(seen.find("inconclusive") != std::string::npos);
}

} // namespace proskill::test::verify_test
