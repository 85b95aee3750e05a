#include "codegen/plan/body_automaton.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace proskill;

namespace {

/// `NS1 -> NS2`, a line per state: its successor, and its targets in brackets.
std::string shape(const codegen::BodyAutomaton& automaton) {
  std::string text;
  for (const auto& state : automaton.states) {
    text += state.name;
    if (state.statement) text += " -> " + (state.next.empty() ? "nowhere" : state.next);
    for (const auto& target : state.targets) text += " [" + target + "]";
    text += "\n";
    for (const auto& branch : state.branches) text += branch.name + ":\n" + shape(branch);
  }
  return text;
}

std::string shapeOf(const std::string& body) {
  const auto program = test::programOfText("(defskill mission :body (" + body + "))");
  return shape(codegen::bodyAutomaton(*program.skills.find("mission")->node().body, "mission"));
}

} // namespace

TEST_CASE("a state stands before each statement, and one at the end") {
  CHECK(shapeOf("(a) (b)") == "NS1 -> NS2\nNS2 -> NS3\nNS3\n");
  CHECK(shapeOf("") == "NS1\n");
}

TEST_CASE("nothing stands behind an outcome or a loop for ever") {
  CHECK(shapeOf("(a) (success done)") == "NS1 -> NS2\nNS2 -> nowhere\n");
  CHECK(shapeOf("(while true (a))") == "NS1 -> nowhere [N1_T]\nN1_T -> NS1\n");
}

TEST_CASE("arms are called after their test") {
  CHECK(shapeOf("(if x (a) (b) elseif y (c) else (d)) (e)") ==
        R"(NS1 -> nowhere [N1_T] [N1_T2] [N1_F]
N1_T -> NS2
NS2 -> NS3
N1_T2 -> NS3
N1_F -> NS3
NS3 -> NS4
NS4
)");
}

TEST_CASE("an empty arm goes on where the if does") {
  CHECK(shapeOf("(if x) (a)") == "NS1 -> NS2 [NS2]\nNS2 -> NS3\nNS3\n");
}

TEST_CASE("a break leaves the innermost loop") {
  CHECK(shapeOf("(while x (do (if y break) until z) (a))") == R"(NS1 -> NS4 [N1_T]
N1_T -> NS2 [N2_T]
N2_T -> NS3
NS2 -> NS3 [N1_T]
NS3 -> NS1
NS4
)");
}

TEST_CASE("do until enters its body first") {
  CHECK(shapeOf("(do (a) (b) until x) (c)") ==
        "NS1 -> NS2\nNS2 -> NS3\nNS3 -> NS4 [NS1]\nNS4 -> NS5\nNS5\n");
}

TEST_CASE("a label has no state of its own, a goto goes to what follows it") {
  CHECK(shapeOf("(label again) (a) (if x (goto again)) (goto out) (b) (label out)") ==
        R"(NS1 -> NS2
NS2 -> NS3 [N1_T]
N1_T -> NS1
NS3 -> NS5
NS4 -> NS5
NS5
)");
  CHECK(shapeOf("(label here) (goto here)") == "NS1 -> NS1\n");
}

TEST_CASE("branches are automata of their own, counted in the order of the text") {
  CHECK(shapeOf("(// ((a)) ((// ((b)) ((c))))) (// ((d)))") == R"(NS1 -> NS2
mission_branch_1_0:
NS1 -> NS2
NS2
mission_branch_1_1:
NS1 -> NS2
mission_branch_2_0:
NS1 -> NS2
NS2
mission_branch_2_1:
NS1 -> NS2
NS2
NS2
NS2 -> NS3
mission_branch_3_0:
NS1 -> NS2
NS2
NS3
)");
}
