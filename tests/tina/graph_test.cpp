#include "tests/support/oracle/class_graph.h"
#include "tests/support/random/random_model.h"
#include "tests/tina/model.h"
#include "tina/graph_text.h"

#include "fiacre/print/print.h"

#include <catch2/catch.hpp>

#include <regex>
#include <set>
#include <sstream>

using namespace proskill;
using verify::GraphKind;
using verify::StateGraph;

namespace {

StateGraph graphOf(const fiacre::Program& program, GraphKind kind = GraphKind::Classes) {
  auto graph = verify::stateGraph(program, kind);
  if (!graph) FAIL(graph.error().message);
  REQUIRE(graph->counts.complete);
  return std::move(*graph);
}

std::string autOf(const StateGraph& graph) {
  std::stringstream text;
  tina::writeAut(text, graph);
  return text.str();
}

std::string ktzOf(const StateGraph& graph, const std::string& name) {
  std::stringstream text;
  tina::writeKtzText(text, graph, name);
  return text.str();
}

/// One or two moves, then the end; `rung_1` and `a_b` contain underscores.
constexpr auto kPlay = R"(
process play is
states move, done_1
var a_b: 0..2 := 0
from move
    select
        on (a_b > 0); to done_1
    []  on (a_b < 2); a_b := a_b + 1; to move
    end
play)";

/// `late` may fire before or after `early` is due; then its clock keeps running.
constexpr auto kTwoClocks = R"(
process late is
states a, b
from a wait [1,3]; to b
process early is
states a, b
from a wait [2,2]; to b
component main is
par * in late || early end
main)";

/// The contents of an .aut file, read by the rules of the format only.
struct Aut {
  std::size_t transitions = 0;
  std::size_t states = 0;
  std::set<std::tuple<std::size_t, std::string, std::size_t>> edges;
};

Aut readAut(const std::string& text) {
  static const std::regex kHead(R"(des \(0, (\d+), (\d+)\))");
  static const std::regex kEdge(R"re(\((\d+), "([^"]*)", (\d+)\))re");
  std::stringstream in(text);
  std::string line;
  std::smatch match;
  std::getline(in, line);
  REQUIRE(std::regex_match(line, match, kHead));
  Aut read{std::stoul(match[1]), std::stoul(match[2]), {}};
  for (std::size_t count = 0; std::getline(in, line); ++count) {
    INFO(line);
    REQUIRE(std::regex_match(line, match, kEdge));
    read.edges.emplace(std::stoul(match[1]), match[2], std::stoul(match[3]));
    CHECK(std::stoul(match[1]) < read.states);
    CHECK(std::stoul(match[3]) < read.states);
  }
  return read;
}

} // namespace

TEST_CASE("a graph as .aut has a line for each transition, from state 0 on") {
  const auto parsed = test::model(kPlay);
  CHECK(autOf(graphOf(parsed.program)) == R"(des (0, 4, 5)
(0, "play_1_t1", 1)
(1, "play_1_t0", 2)
(1, "play_1_t1", 3)
(3, "play_1_t0", 4)
)");
}

TEST_CASE("a graph as the text of ktzio has what each marking holds, with the names of frac") {
  const auto parsed = test::model(kPlay);
  CHECK(ktzOf(graphOf(parsed.program), tina::netName(parsed.program)) == R"(# Created by ProSkill

kts process_play_1
5 nodes
4 edges
1 state property namespace(s)
  S [n]: 3 properties: play_1_smove play_1_sdone__1 play_1_va__b
1 transition property namespace(s)
  E: 2 properties: play_1_t1 play_1_t0
5 state property sets

state 0
props play_1_smove
trans play_1_t1/1

state 1
props play_1_smove play_1_va__b
trans play_1_t0/2 play_1_t1/3

state 2
props play_1_sdone__1 play_1_va__b
trans

state 3
props play_1_smove play_1_va__b*2
trans play_1_t0/4

state 4
props play_1_sdone__1 play_1_va__b*2
trans
)");
}

// Computed by hand: the initial class; `late` alone (at 1..2), with `early` then due within 0..1;
// `early` alone (at 2), with `late` due within 0..1; and both.
TEST_CASE("classes, markings and untimed markings are three graphs") {
  const auto parsed = test::model(kTwoClocks);
  const auto classes = graphOf(parsed.program);
  CHECK(classes.markingOf.size() == 4);
  CHECK(classes.edges.size() == 4);
  CHECK(classes.counts.classes == 4);
  // A loop that may restart at any time makes classes with the same marking.
  const auto timed = test::model(R"(
process tick is
states a
from a wait [1,1]; to a
process slow is
states a, b
from a wait [2,3]; to b
component main is
par * in tick || slow end
main)");
  // slow's delay: 2..3, then 1..2, 0..1, 0; after it tick's: 0 or 0..1 or 1 …, always one marking
  const auto all = graphOf(timed.program);
  const auto markings = graphOf(timed.program, GraphKind::Markings);
  const auto untimed = graphOf(timed.program, GraphKind::Untimed);
  CHECK(markings.markingOf.size() == 2);
  CHECK(markings.edges.size() == 3); // tick in both, slow once
  CHECK(untimed.markingOf.size() == 2);
  CHECK(untimed.edges.size() == 3);
  oracle::Interpreter interpreter(timed.program);
  const auto counted = oracle::countClasses(interpreter, 1000);
  CHECK(all.markingOf.size() == counted.classes);
  CHECK(all.edges.size() == counted.transitions);
  CHECK(all.markingOf.size() > 4);
}

TEST_CASE("time forbids markings that the untimed graph has") {
  const auto parsed = test::model(R"(
process both is
states a, soon, never
from a select wait [1,1]; to soon [] wait [2,2]; to never end
both)");
  CHECK(graphOf(parsed.program, GraphKind::Markings).markingOf.size() == 2);
  CHECK(graphOf(parsed.program, GraphKind::Untimed).markingOf.size() == 3);
}

TEST_CASE("what is joined is named the later member first; parts of variables as in frac's C") {
  const auto parsed = test::model(R"(
type cell is record on_off: bool, level: 0..3 end
type cells is array 2 of cell
process left_1 [p: sync] is
states s
var own: cells := [{on_off = false, level = 2}, {on_off = true, level = 0}]
from s p; to s
process right [p: sync] is
states s
from s p; to s
component main is
var shared: 0..3 := 3
port p: sync in [0,0]
par * in left_1 [p] || right [p] || right [p] end
main)");
  const auto graph = graphOf(parsed.program);
  CHECK(graph.labels == std::vector<std::string>{"right_2_t0_right_1_t0_left__1_1_t0"});
  const auto text = ktzOf(graph, "n");
  CHECK_THAT(text, Catch::Contains("props left__1_1_ss right_1_ss right_2_ss main_1_vshared*3 "
                                   "{left__1_1_vown.at[0].level}*2 "
                                   "{left__1_1_vown.at[1].on_off}\n"));
}

TEST_CASE("the graph of a random model is that of the textbook, and its .aut says the same") {
  constexpr std::uint64_t kModels = 300;
  constexpr std::size_t kLimit = 3000;
  std::size_t compared = 0;
  for (std::uint64_t seed = 0; seed < kModels; ++seed) {
    const auto program = test::randomModel(seed);
    oracle::Interpreter interpreter(program);
    const auto expected = oracle::countClasses(interpreter, kLimit);
    if (!expected.complete) continue;
    ++compared;
    INFO("seed " << seed << "\n" << fiacre::print(program));
    const auto graph = graphOf(program);
    CHECK(graph.markingOf.size() == expected.classes);
    CHECK(graph.markings.size() == expected.markings);
    REQUIRE(graph.edges.size() == expected.transitions);
    CHECK(graph.counts.domains == expected.domains);
    CHECK(graphOf(program, GraphKind::Markings).markingOf.size() == expected.markings);
    const auto text = autOf(graph);
    CHECK(autOf(graphOf(program)) == text);
    const Aut read = readAut(text);
    CHECK(read.states == expected.classes);
    CHECK(read.transitions == expected.transitions);
    std::set<std::tuple<std::size_t, std::string, std::size_t>> edges;
    for (const auto& edge : graph.edges)
      edges.emplace(edge.source, graph.labels[edge.label], edge.target);
    CHECK(read.edges == edges);
  }
  CHECK(compared > kModels / 2);
}

TEST_CASE("a graph that a limit cuts has no states to be taken for all of them") {
  const auto parsed = test::model(R"(
process count is
states s
var n: 0..1000 := 0
from s on (n < 1000); n := n + 1; to s
count)");
  verify::Options options;
  options.limits.classes = 100;
  const auto graph = verify::stateGraph(parsed.program, GraphKind::Classes, options);
  REQUIRE(graph.has_value());
  CHECK_FALSE(graph->counts.complete);
  CHECK(graph->edges.empty());
  CHECK(graph->markingOf.empty());
}
