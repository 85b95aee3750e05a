#include "tina/ktz_text.h"
#include "tina/outputs.h"

#include <catch2/catch.hpp>

#include <sstream>

using namespace proskill;
using Names = std::vector<std::string>;

namespace {

std::expected<tina::KtzGraph, std::string> ktz(const std::string& text) {
  std::istringstream in(text);
  return tina::readKtzText(in);
}

/// The head and two states of a file from ktzio.
constexpr auto kGenuine = R"(# Created Sun May 12 22:09:35 2019 by TINA version 3.4.4

kts process_play_1
4 nodes
8 edges
2 state property namespace(s)
  L: 1 property: scc
  S [n]: 3 properties: play_1_smove play_1_vx play_1_vy ...
1 transition property namespace(s)
  E: 4 properties: play_1_t0 play_1_t1 play_1_t2 ...
8 state property sets

state 0
props play_1_smove play_1_vx play_1_vy
trans play_1_t1/1 play_1_t3/2

state 1
props play_1_smove play_1_vx*2 play_1_vy
trans play_1_t0/0 play_1_t3/3
)";

} // namespace

TEST_CASE("frac's formulas are definitions and, for each assert, a query") {
  // The end is that of a file from frac.
  const auto file = tina::readLtl("op deadlockFree = [] - dead; # a; comment\n"
                                  "infix 0 p W q = p U (q \\/ []p);\n\n"
                                  "# user formulas\n"
                                  "op impossible = [] (- ((play_1_sdone)));\n"
                                  "impossible;\n[] (a => <> b);\n");
  CHECK(file.queries == Names{"impossible", "[] (a => <> b)"});
  CHECK(file.definitions == "op deadlockFree = [] - dead;\ninfix 0 p W q = p U (q \\/ []p);\n"
                            "op impossible = [] (- ((play_1_sdone)));\n");
}

TEST_CASE("the counts of sift are found among other lines") {
  const auto counts =
      tina::readCounts("Sift version 3.8\n16 classe(s), 14 marking(s), 6 domain(s), "
                       "22 transition(s)\n0.000s\n");
  REQUIRE(counts.has_value());
  CHECK(counts->classes == 16);
  CHECK(counts->markings == 14);
  CHECK(counts->domains == 6);
  CHECK(counts->transitions == 22);
  CHECK(tina::readCounts("1 class, 1 marking, 1 domain, 0 transitions").has_value());
  CHECK_FALSE(tina::readCounts("16 classe(s), 14 marking(s)").has_value());
  CHECK_FALSE(tina::readCounts("").has_value());
}

TEST_CASE("the digest of tina has states and transitions of the graph behind those of the net") {
  const auto counts = tina::readCounts("# net main, 7 places, 6 transitions, 18 arcs #\n"
                                       "places 7 transitions 6 bounded Y live Y reversible Y\n"
                                       "states 45 45 Y\ntransitions 112 6 Y\n");
  REQUIRE(counts.has_value());
  CHECK(counts->classes == 45);
  CHECK(counts->transitions == 112);
  CHECK_FALSE(tina::readCounts("states 45\n").has_value());
}

TEST_CASE("an explorer that stopped early is noticed; names of the model are no such words") {
  CHECK(tina::saysUnfinished("16 classe(s)\nexploration aborted\n"));
  CHECK(tina::saysUnfinished("Limit exceeded"));
  CHECK_FALSE(tina::saysUnfinished("p_1_sinterrupted skill_interrupted_1_t0 # bounded Y\n"));
}

TEST_CASE("endless lines and very many of them are read in no time, and hold nothing") {
  const std::string line(8'000'000, '1');
  CHECK_FALSE(tina::readCounts(line).has_value());
  CHECK_FALSE(tina::saysUnfinished(line));
  CHECK_FALSE(tina::readVerdicts(line, 1).has_value());
  std::string lines;
  for (int i = 0; i < 300'000; ++i) lines += "states 1\n";
  CHECK_FALSE(tina::readCounts(lines).has_value());
  CHECK(tina::readCounts(lines + "transitions 2\n").has_value());
}

TEST_CASE("verdicts are read with and without formulas and banners; their number has to be right") {
  CHECK(tina::readVerdicts("TRUE\nFALSE\n", 2) == std::vector<bool>{true, false});
  CHECK(tina::readVerdicts("Selt version 3.8\nktz loaded, 4 states, 8 transitions\n"
                           "[] (T => - p)\nTRUE\nimpossible: FALSE\n0.000s\n",
                           2) == std::vector<bool>{true, false});
  CHECK_FALSE(tina::readVerdicts("TRUE\n", 2).has_value());
  CHECK_FALSE(tina::readVerdicts("TRUE\nTRUE\nTRUE\n", 2).has_value());
  CHECK_FALSE(tina::readVerdicts("true\n", 1).has_value());
  CHECK_FALSE(tina::readVerdicts("UNTRUE\n", 1).has_value());
  CHECK_FALSE(tina::readVerdicts("syntax error in formula\n", 1).has_value());
}

TEST_CASE("a scenario has transitions, with or without dates of either kind") {
  CHECK(tina::readScenario("# a scenario\nt1@0.5 t2@3\n\n{a b}\n") == std::nullopt);
  CHECK(tina::readScenario("# a scenario\nt1@0.5 t2@3\n\n{x.at[0]}@2\n") ==
        Names{"t1", "t2", "{x.at[0]}"});
  CHECK(tina::readScenario("t1 t2\nt1") == Names{"t1", "t2", "t1"});
  CHECK(tina::readScenario("t1$0 t2$1e1") == Names{"t1", "t2"});
  CHECK_FALSE(tina::readScenario("t1@soon").has_value());
  CHECK_FALSE(tina::readScenario("t1@-1").has_value());
  CHECK_FALSE(tina::readScenario("# nothing\n").has_value());
}

TEST_CASE("selt's own words have transitions between arrows") {
  CHECK(tina::readCounterexample("FALSE\n"
                                 "  state 0: L.scc*5 play_1_smove play_1_vx\n"
                                 "  -play_1_t1 ... (preserving - play_1_sdone)->\n"
                                 "* [accepting] state 7: L.dead play_1_sdone\n"
                                 "  -L.deadlock->\n"
                                 "  state 7: L.dead play_1_sdone\n"
                                 "  [accepting all]\n0.000s\n") == Names{"play_1_t1"});
}

TEST_CASE("the text of ktzio is read; one that ends too early is noticed") {
  const auto cut = ktz(kGenuine);
  REQUIRE_FALSE(cut.has_value());
  CHECK(cut.error() == "some of its states are missing");
  const auto whole = ktz(std::string(kGenuine) + "\nstate 2\nprops play_1_smove\ntrans "
                                                 "play_1_t1/0 play_1_t0/3\n\nstate 3\nprops "
                                                 "L.scc*2 {play_1_va.at[0]}*3\ntrans a/0 b/1\n");
  if (!whole) FAIL(whole.error());
  REQUIRE(whole->states.size() == 4);
  CHECK(whole->properties == Names{"play_1_smove", "play_1_vx", "play_1_vy", "{play_1_va.at[0]}"});
  CHECK(whole->states[1].has ==
        std::vector<std::pair<std::uint32_t, std::int64_t>>{{0, 1}, {1, 2}, {2, 1}});
  CHECK(whole->states[3].has == std::vector<std::pair<std::uint32_t, std::int64_t>>{{3, 3}});
  CHECK(whole->labels == Names{"play_1_t1", "play_1_t3", "play_1_t0", "a", "b"});
  CHECK(whole->states[1].edges ==
        std::vector<std::pair<std::uint32_t, std::uint32_t>>{{2, 0}, {1, 3}});
}

TEST_CASE("text that is not ktzio's is an error with its line") {
  CHECK(ktz("").error() == "it has no states");
  CHECK(ktz("state 1\n").error() == "line 1 is not understood: state 1");
  CHECK(ktz("state 0\nprops a*x\n").error() == "line 2 is not understood: props a*x");
  CHECK(ktz("state 0\ntrans a\n").error() == "line 2 is not understood: trans a");
  CHECK(ktz("state 0\nwhat is this\n").error() == "line 2 is not understood: what is this");
  CHECK(ktz("state 0\ntrans a/7\n").error() == "an edge leads to a state that is missing");
  CHECK(ktz("1 nodes\n2 edges\nstate 0\ntrans a/0\n").error() == "some of its edges are missing");
}
