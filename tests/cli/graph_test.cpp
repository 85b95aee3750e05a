#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <set>

namespace proskill::test::graph_test {

namespace {

constexpr auto kDrone = PROSKILL_SOURCE_DIR "/examples/drone/drone.proskill";

Finished graph(std::vector<std::string> words) {
  words.insert(words.begin(), {PROSKILL_PROGRAM, "graph", kDrone});
  return run(words);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::set<std::string> filesIn(const std::string& directory) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    names.insert(entry.path().filename().string());
  return names;
}

} // namespace

TEST_CASE("graph draws the calls where nothing else is asked for") {
  const auto done = graph({});
  CHECK(done.exitCode == 0);
  CHECK(done.err.empty());
  CHECK(contains(done.out, "<svg"));
  CHECK(contains(done.out, "who calls whom"));
  CHECK(done.out == graph({"--kind", "calls", "--format", "svg"}).out);
}

TEST_CASE("graph draws one thing by its name, with or without its kind") {
  const auto battery = graph({"--kind", "sv", "--name", "battery", "--format", "dot"});
  CHECK(battery.exitCode == 0);
  CHECK(battery.out.starts_with("digraph proskill {"));
  CHECK(battery.out == graph({"--name", "battery", "--format", "dot"}).out);
  CHECK(contains(graph({"--kind", "body", "--name", "uav_mission"}).out, "mission_accomplished"));
  CHECK(contains(graph({"--kind", "skill", "--name", "takeoff"}).out, "at_altitude"));
}

TEST_CASE("graph draws forbidden moves and dark pages on request") {
  const auto plain = graph({"--name", "battery"}).out;
  const auto forbidden = graph({"--name", "battery", "--forbidden"}).out;
  CHECK_FALSE(contains(plain, "must not happen"));
  CHECK(contains(forbidden, "must not happen"));
  CHECK(graph({"--name", "battery", "--dark"}).out != plain);
}

TEST_CASE("graph takes the format from the output's name, unless it is told") {
  const TemporaryDirectory directory;
  CHECK(graph({"--name", "battery", "-o", directory.path("a.dot")}).exitCode == 0);
  CHECK(graph({"--name", "battery", "-o", directory.path("a.png")}).exitCode == 0);
  CHECK(std::filesystem::file_size(directory.path("a.png")) > 1000);
  CHECK(filesIn(directory.path()) == std::set<std::string>{"a.dot", "a.png"});
  CHECK(graph({"--name", "battery", "--format", "png"}).out.starts_with("\x89PNG"));
}

TEST_CASE("graph draws everything into a directory, and says what it wrote") {
  const TemporaryDirectory directory;
  const auto done = graph({"--out-dir", directory.path("pictures")});
  CHECK(done.exitCode == 0);
  const auto names = filesIn(directory.path("pictures"));
  CHECK(names.size() == 7 + 6 + 2 + 1);
  for (const auto* name :
       {"sv_battery.svg", "skill_takeoff.svg", "body_uav_mission.svg", "calls.svg"}) {
    CHECK(names.contains(name));
    CHECK(contains(done.out, directory.path("pictures/") + name));
  }
  graph({"--out-dir", directory.path("bodies"), "--kind", "body", "--format", "dot"});
  CHECK(filesIn(directory.path("bodies")) ==
        std::set<std::string>{"body_monitor_battery_critical.dot", "body_uav_mission.dot"});
}

TEST_CASE("graph asks which one where there are several, and says what there is not") {
  const auto which = graph({"--kind", "skill"});
  CHECK(which.exitCode == 2);
  CHECK(contains(which.err, "--name"));
  CHECK(contains(which.err, "takeoff, goto_waypoint"));
  CHECK(graph({"--name", "nothing"}).err == "error: there is no picture of `nothing`\n");
  CHECK(graph({"--kind", "sv", "--name", "nothing"}).err ==
        "error: there is no state variable `nothing`\n");
  CHECK(graph({"--kind", "tree"}).exitCode == 2);
  CHECK(graph({"-o", "/no/such/directory/a.svg"}).exitCode == 2);
}

} // namespace proskill::test::graph_test
