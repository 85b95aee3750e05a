#include "fiacre/print/print.h"
#include "runtime/check/platform_check.h"
#include "runtime/check/platform_summary.h"
#include "runtime/machine/executable.h"
#include "tests/support/memory_files.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <fstream>

using namespace proskill;

namespace {

const std::string kFlightClause = "(defplatform \"robot.json\")\n";
const std::string kFlight = kFlightClause + R"(
  (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
  (defevent storm :effects (sky Stormy))
  (defskill fly :action (fly) :interrupt () :success there :failure lost)
  (defskill mission :success done :body ((fly) (success done))))";

using Findings = std::vector<runtime::PlatformFinding>;

/// What is found about a platform file of a program.
Findings platformFindings(const std::string& program, const std::string& platform,
                          bool isSound = true, const analysis::flow::Settings& settings = {}) {
  const test::MemoryFiles files({{"w/m.proskill", program}, {"w/robot.json", platform}});
  const auto loaded = analysis::load(files, "w/m.proskill");
  return runtime::checkNamedPlatform(loaded, isSound, settings,
                                     [&](const auto& path) { return files.read(path); });
}

std::string platformMessage(const std::string& platform, bool isSound = true) {
  const auto found = platformFindings(kFlight, platform, isSound);
  return found.empty() ? "" : found.at(0).diagnostic.message;
}

analysis::Program flightProgramOf(const std::string& text) {
  return analysis::load(test::MemoryFiles({{"m.proskill", text}}), "m.proskill");
}

/// One line for each action and each signal.
std::string interfaceLines(const codegen::PlatformInterface& interface) {
  std::string lines;
  for (const auto& performed : interface.performed) {
    lines += performed.skill + ":";
    for (const auto& result : performed.results) lines += " " + result.status + " " + result.tag;
    lines += "\n";
  }
  for (const auto& signal : interface.signals)
    lines += (signal.interrupts ? "interrupt " : "event ") + signal.name + "\n";
  return lines;
}

} // namespace

TEST_CASE("a platform that suits its program has no finding") {
  CHECK(platformMessage("{}") == "");
  CHECK(platformMessage(
            R"({"actions": {"fly": {"results": {"there": 1}}}, "events": {"storm": [3, 9]},
                       "interrupts": {"fly": null}})") == "");
  CHECK(platformMessage(R"({"kind": "process", "command": ["no_such_program"]})") == "");
  CHECK(platformMessage(R"({"kind": "library", "library": "no_such_library.so"})") == "");
}

TEST_CASE("a platform that does not suit its program has the message of a run") {
  CHECK(platformMessage("{\n \"actions\": {\"flie\": {}}}") ==
        "`robot.json`:2:14: there is no basic skill `flie`");
  CHECK(platformMessage(R"({"events": {"strom": null}})") ==
        "`robot.json`:1:13: there is no event `strom`; did you mean `storm`?");
  CHECK(platformMessage(R"({"actions": {"fly": {"results": {"there": "often"}}}})") ==
        "`robot.json`:1:43: the weight of `there` must be a natural number up to a million");
  CHECK(platformMessage(R"({"kind": "process"})") ==
        "`robot.json`:1:1: `command` is missing: the program and its arguments");
  CHECK(platformMessage(R"({"kind": "library", "library": "a.so", "functions": {"flie": "f"}})") ==
        "`robot.json`:1:54: there is no basic skill `flie`");
  CHECK(platformMessage(R"({"kind": "ros2", "actions": {"fly": {"topic": "/fly"}}})") ==
        "`robot.json`:1:37: `fly`: `type` is missing");
}

TEST_CASE("a finding about a platform is at its path, and knows the place in its file") {
  const auto found = platformFindings(kFlight, "{\n \"actions\": {\"flie\": {}}}");
  REQUIRE(found.size() == 1);
  CHECK(found[0].diagnostic.location == analysis::Location{0, {14, 24}});
  CHECK(found[0].file == "w/robot.json");
  CHECK(found[0].place.value().text() == "2:14");
}

TEST_CASE("each error of a platform is a finding") {
  const auto found =
      platformFindings(kFlight, R"({"actions": {"flie": {}}, "events": {"strom": 3}})");
  REQUIRE(found.size() == 2);
  CHECK(found[0].diagnostic.message == "`robot.json`:1:14: there is no basic skill `flie`");
  CHECK(found[1].diagnostic.message ==
        "`robot.json`:1:38: there is no event `strom`; did you mean `storm`?");
  CHECK(found[0].place.value().text() == "1:14");
  CHECK(found[1].place.value().text() == "1:38");
}

TEST_CASE("a basic skill without an action on the robot is related") {
  const auto found = platformFindings(kFlight, R"({"kind": "ros1"})");
  REQUIRE(found.size() == 1);
  CHECK(found[0].diagnostic.message == "`robot.json`: the platform file has no action for `fly`");
  CHECK_FALSE(found[0].place);
  REQUIRE(found[0].diagnostic.related.size() == 1);
  CHECK(found[0].diagnostic.related[0].location.range.begin == kFlight.find("fly"));
}

TEST_CASE("an event that the robot never reports is a warning") {
  const std::string mapped = R"({"kind": "ros2", "actions": {"fly": {
    "topic": "/fly", "type": "std_msgs/msg/Empty", "result": "there"}})";
  const auto found = platformFindings(kFlight, mapped + "}");
  REQUIRE(found.size() == 1);
  CHECK(found[0].diagnostic.message == "`robot.json` never reports the event `storm`");
  CHECK(found[0].diagnostic.severity == syntax::Severity::Warning);
  CHECK(found[0].diagnostic.related.at(0).location.range.begin == kFlight.find("storm"));
  CHECK(platformFindings(kFlight, mapped + R"(, "events": {"storm": {
    "topic": "/wind", "type": "std_msgs/msg/Float64", "field": "data", "above": 20}}})")
            .empty());
  CHECK(platformFindings(kFlight, mapped + R"(, "variables": {"sky": {
    "topic": "/wind", "type": "std_msgs/msg/Float64", "field": "data",
    "values": [{"value": "Stormy"}]}}})")
            .empty());
}

TEST_CASE("settings and comments weigh warnings about a platform, not errors") {
  const std::string silent = R"({"kind": "ros2", "actions": {"fly": {
    "topic": "/fly", "type": "std_msgs/msg/Empty", "result": "there"}}})";
  const analysis::flow::Settings off{
      {{syntax::Code::SilentPlatform, std::nullopt}, {syntax::Code::WrongPlatform, std::nullopt}}};
  CHECK(platformFindings(kFlight, silent, true, off).empty());
  CHECK(platformFindings(kFlight, "{,}", true, off).size() == 1);
  const auto ignoring = "; proskill-ignore: PS1403, PS1402\n" + kFlight;
  CHECK(platformFindings(ignoring, silent).empty());
  CHECK(platformFindings(ignoring, "{,}").size() == 1);
  CHECK(analysis::flow::inspect(flightProgramOf(ignoring)).size() ==
        analysis::flow::inspect(flightProgramOf(kFlight)).size());
}

TEST_CASE("a platform file that cannot be read, or is none, is a finding") {
  const auto found = platformFindings("(defplatform \"../robot.json\")", "{}");
  REQUIRE(found.size() == 1);
  CHECK(found[0].diagnostic.message == "cannot read the platform `../robot.json`: no such file");
  CHECK(found[0].file == "robot.json");
  CHECK(platformMessage("{,}") == "`robot.json`:1:2: it is not JSON");
  CHECK(platformMessage(R"({"kind": "robot"})") ==
        "`robot.json`:1:10: `kind` must be `simulated`, `process`, `library`, `ros1` or `ros2`, "
        "not `robot`");
}

TEST_CASE("a platform is not compared with a program that has errors or several missions") {
  const std::string wrong = R"({"actions": {"flie": {}}})";
  CHECK(platformMessage(wrong, false) == "");
  CHECK(platformMessage("{,}", false) == "`robot.json`:1:2: it is not JSON");
  CHECK(platformFindings(kFlight + "(defskill other :body ((fly)))", wrong).empty());
}

TEST_CASE("a program that names no platform has no finding") {
  CHECK(platformFindings("(defresource arm)", "{,}").empty());
}

TEST_CASE("the interface for a check is that of the model that is executed") {
  for (const auto* name : {"drone/drone", "arm/arm", "lift/lift", "rover/rover", "ros1/patrol"}) {
    const auto path = std::string(PROSKILL_SOURCE_DIR "/examples/") + name + ".proskill";
    INFO(path);
    std::ifstream file(path);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const auto program = flightProgramOf(text);
    if (!analysis::check(program).empty()) continue; // it includes others
    const auto interface = codegen::platformInterface(program);
    const auto executable = runtime::makeExecutable(program, "", false);
    REQUIRE(interface);
    REQUIRE(executable);
    CHECK(interfaceLines(*interface) == interfaceLines((*executable)->model));
    CHECK(!interface->performed.empty());
  }
}

TEST_CASE("a model does not depend on the platform that its program names") {
  const auto with = codegen::generate(flightProgramOf(kFlight));
  const auto without =
      codegen::generate(flightProgramOf("; none\n" + kFlight.substr(kFlightClause.size())));
  REQUIRE(with);
  REQUIRE(without);
  CHECK(fiacre::print(with->fiacre) == fiacre::print(without->fiacre));
}

TEST_CASE("the summary of a platform says who performs the actions") {
  const auto program = flightProgramOf(kFlight);
  const auto sentence = [&](const std::string& text) {
    return runtime::platformSummary(text, program).value().sentence;
  };
  CHECK(sentence("{}") == "The actions are simulated.");
  CHECK(sentence(R"({"kind": "process", "command": ["python3", "robot.py"]})") ==
        "The program `python3 robot.py` performs the actions.");
  CHECK(sentence(R"({"kind": "library", "library": "lib`x`.so"})") ==
        "The library `libx.so` performs the actions.");
  CHECK(sentence(R"({"kind": "ros1"})") == "An adapter to ROS 1 performs the actions.");
  CHECK_FALSE(runtime::platformSummary("[]", program));
}

TEST_CASE("the summary of a platform says how each action is performed") {
  using Actions = std::vector<std::pair<std::string, std::string>>;
  const auto program = flightProgramOf(kFlight);
  const auto actions = [&](const std::string& text) {
    return runtime::platformSummary(text, program).value().actions;
  };
  CHECK(actions(R"({"kind": "process", "command": ["robot"]})").empty());
  CHECK(actions(R"({"actions": {"fly": {"duration": [1, 2]}}})") ==
        Actions{{"fly", "takes `[1,2]` s"}});
  CHECK(actions(R"({"kind": "library", "library": "a.so"})") ==
        Actions{{"fly", "function `skill_fly` or `begin_fly`"}});
  CHECK(actions(R"({"kind": "library", "library": "a.so", "functions": {"fly": "soar"}})") ==
        Actions{{"fly", "function `soar`"}});
  CHECK(actions(R"({"kind": "ros2", "actions": {"fly": {"service": "/fly"}}})") ==
        Actions{{"fly", "service `/fly`"}});
  CHECK(actions(R"({"kind": "ros2", "actions": {"fly": 3}})").empty());
}
