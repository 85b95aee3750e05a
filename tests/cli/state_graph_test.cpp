#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace proskill::test::state_graph_test {

namespace {

const std::string kFischer = PROSKILL_SOURCE_DIR "/examples/fiacre/fischer.fcr";
const std::string kLift = PROSKILL_SOURCE_DIR "/examples/lift/lift.proskill";

Finished graph(const std::vector<std::string>& arguments) {
  std::vector<std::string> command{PROSKILL_PROGRAM, "verify"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run(command);
}

std::string contents(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Doors that are independent of each other, in a number that gives more states than fit into
/// any memory limit of the tests.
std::string manyDoors() {
  std::string text = "process door is\nstates open, shut\nfrom open to shut\nfrom shut to open\n\n"
                     "component main is\npar * in\n   door\n";
  for (int i = 1; i < 24; ++i) text += "|| door\n";
  return text + "end\n\nmain\n";
}

} // namespace

TEST_CASE("verify --graph writes the graph and prints the four counts of sift") {
  const TemporaryDirectory files;
  const auto path = files.path("fischer.aut");
  const auto written = graph({kFischer, "--graph", path});
  CHECK(written.exitCode == 0);
  CHECK_THAT(written.out, Catch::StartsWith("104 classe(s), 65 marking(s), 104 domain(s), "
                                            "225 transition(s)\n"));
  CHECK_THAT(contents(path), Catch::StartsWith("des (0, 225, 104)\n(0, \"contender_1_t0\", 1)\n"));
  const auto again = files.path("again.aut");
  CHECK(graph({kFischer, "--graph", again}).exitCode == 0);
  CHECK(contents(again) == contents(path));
}

TEST_CASE("verify --graph-of markings and untimed print how large the file's graph is") {
  const TemporaryDirectory files;
  const auto path = files.path("fischer.txt");
  const auto markings = graph({kFischer, "--graph", path, "--graph-of", "markings"});
  CHECK_THAT(markings.out, Catch::EndsWith("\n65 state(s), 150 edge(s)\n"));
  CHECK_THAT(contents(path), Catch::Contains("\n65 nodes\n150 edges\n"));
  const auto untimed = graph({kFischer, "--graph", "counts", "--graph-of", "untimed"});
  CHECK_THAT(untimed.out, Catch::EndsWith("\n152 state(s), 408 edge(s)\n"));
}

TEST_CASE("a state graph that a limit cuts is an error, and leaves no file") {
  const TemporaryDirectory files;
  const auto path = files.path("lift.aut");
  const auto cut = graph({kLift, "--graph", path, "--class-limit", "1000"});
  CHECK(cut.exitCode == 3);
  CHECK_THAT(cut.err, Catch::Contains("not complete: the limit of classes was reached"));
  CHECK(std::filesystem::is_empty(files.path()));
}

TEST_CASE("a state graph is only for a file of a known kind, where there is room") {
  const TemporaryDirectory files;
  const auto odd = graph({kFischer, "--graph", files.path("graph.bcg")});
  CHECK(odd.exitCode == 2);
  CHECK_THAT(odd.err, Catch::Contains("`.aut` or `.txt`"));
  const auto nowhere = graph({kFischer, "--graph", files.path("no/such.aut")});
  CHECK(nowhere.exitCode == 2);
  CHECK_THAT(nowhere.err, Catch::Contains("cannot be written: No such file or directory"));
  CHECK(std::filesystem::is_empty(files.path()));
}

TEST_CASE("counting classes keeps the memory limit while its tables grow") {
  const TemporaryDirectory files;
  const auto path = files.write("doors.fcr", manyDoors());
  for (const long limit : {32, 40, 48, 56, 64}) {
    CAPTURE(limit);
    const auto cut = graph({path, "--graph", "counts", "--memory-limit", std::to_string(limit)});
    CHECK(cut.exitCode == 3);
    CHECK_THAT(cut.err, Catch::Contains("not complete: the memory limit was reached"));
    CHECK(cut.peakKiB < limit * 1024 * 105 / 100);
  }
}

} // namespace proskill::test::state_graph_test
