#include "fiacre/format/format.h"

#include "codegen/model.h"
#include "fiacre/print/print.h"
#include "fiacre/syntax/lexer.h"
#include "fiacre/syntax/parse.h"
#include "tests/support/oracle/canonical.h"
#include "tests/support/random/random_model.h"
#include "tests/support/random/random_program.h"
#include "tests/support/texts.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

namespace proskill::test::format_test {

namespace {

std::string formatted(std::string_view text) {
  INFO(text);
  const auto problems = fiacre::parse(text).problems;
  INFO((problems.empty() ? "" : problems[0].message));
  const auto result = fiacre::format(text);
  REQUIRE(result.has_value());
  return *result;
}

std::vector<std::string> words(std::string_view text) {
  std::vector<std::string> all;
  for (const auto& token : fiacre::tokenizeWithComments(text)) all.emplace_back(token.text);
  return all;
}

fiacre::Program meaning(std::string_view text) {
  return test::canonical(fiacre::parse(text).program);
}

/// The first line of `got` that differs from `wanted`.
std::string firstDifference(std::string_view got, std::string_view wanted) {
  std::istringstream a{std::string(got)};
  std::istringstream b{std::string(wanted)};
  std::string lineA;
  std::string lineB;
  for (int line = 1; std::getline(a, lineA), std::getline(b, lineB), a || b; ++line)
    if (lineA != lineB)
      return std::to_string(line) + ": `" + lineA + "` where `" + lineB + "` was wanted";
  return "";
}

/// Formatting changes white space only, and formatting again changes nothing.
std::string checked(std::string_view text) {
  auto result = formatted(text);
  const bool same = words(result) == words(text) && meaning(result) == meaning(text);
  if (!same) FAIL("another text:\n" << text << "\n--- laid out\n" << result);
  CHECK(firstDifference(formatted(result), result) == "");
  return result;
}

std::string applied(std::string text, const std::vector<fiacre::Change>& changes) {
  for (auto change = changes.rbegin(); change != changes.rend(); ++change)
    text.replace(change->begin, change->end - change->begin, change->text);
  return text;
}

/// The same tokens with other white space, and comments here and there.
std::string shaken(std::string_view text, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::string result;
  const auto tokens = fiacre::tokenizeWithComments(text);
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool touched = i > 0 && tokens[i - 1].end() == tokens[i].begin;
    if (i > 0 && tokens[i - 1].text.starts_with("//")) result += '\n';
    if (!touched) {
      switch (random() % 12) {
      case 0: result += "\n\n\n"; break;
      case 1: result += " // why\n"; break;
      case 2: result += "\n// above\n\t"; break;
      case 3: result += " /* within */ "; break;
      case 4: result += "\n   "; break;
      default: result += ' ';
      }
    }
    result += tokens[i].text;
  }
  return result;
}

std::vector<std::string> examples() {
  std::vector<std::string> texts;
  for (const auto& entry :
       std::filesystem::directory_iterator(PROSKILL_SOURCE_DIR "/examples/fiacre")) {
    if (entry.path().extension() != ".fcr") continue;
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    texts.push_back(text.str());
  }
  REQUIRE(texts.size() > 10);
  return texts;
}

} // namespace

TEST_CASE("the examples of Fiacre are laid out") {
  for (const auto& text : examples()) CHECK(firstDifference(checked(text), text) == "");
}

TEST_CASE("models are printed in the layout") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto text = fiacre::print(test::randomModel(seed));
    CHECK(firstDifference(checked(text), text) == "");
  }
}

TEST_CASE("models with observers are printed in the layout") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto text = fiacre::print(test::randomModelWithObserver(seed));
    CHECK(firstDifference(checked(text), text) == "");
  }
}

TEST_CASE("compositions, probes and observers have their layout") {
  const std::string wide = "component m is port a:sync in [0,0] is(m/1/value x/2=1)and m/2/state s,"
                           "b:sync is m/event c , d:sync par*in par a->P[a]||Q end||R end m "
                           "o>m p  >  m type t is 0..1";
  CHECK(checked(wide) == R"(component m is
port a: sync in [0,0] is (m/1/value x / 2 = 1) and m/2/state s, b: sync is m/event c, d: sync
par * in
    par
        a -> P [a]
    ||  Q
    end
||  R
end

m

o > m
p > m
type t is 0..1
)");
}

TEST_CASE("models of random programs are printed in the layout") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const auto program = test::programOfText(test::textOf(test::randomProgram(seed)));
    const auto model = codegen::generate(program, {});
    if (!model) continue;
    const auto text = fiacre::print(model->fiacre);
    CHECK(firstDifference(checked(text), text) == "");
  }
}

TEST_CASE("whatever white space and comments a text has, it is laid out once and means the same") {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto text = shaken(fiacre::print(test::randomModel(seed)), seed);
    const auto result = checked(text);
    CHECK(applied(text, *fiacre::formatChanges(text)) == result);
  }
  std::uint64_t seed = 0;
  for (const auto& text : examples())
    for (int i = 0; i < 10; ++i) checked(shaken(text, ++seed));
}

TEST_CASE("the user's choices stay") {
  const std::string text = R"(// One.

// Two.
type mood is union // of a robot
    calm | // fine
    angry of 0..3
end

process P [p: in 0..3, q: sync] (&x: 0..3) is
states idle, busy // what it does

// It waits here.
from idle
    select
        p ? x where x > 0; // something came
        to busy

    // nothing came
    []  wait ]2,...[;
        #bored;
        if x = 0 then q else x := -x % 2 end;
        to idle
    unless
        case x of
          0 -> to idle
        | any ->
            x := 0;
            to busy
        end
        // never
    end

from busy
    loop

component m is
var x: 0..3 := 0, // shared
    y: array 2 of 0..3 := [0, 1]
port p: 0..3 in ]1,3[, q: sync
par p in
    P [p, q] (&x)
    // the other one
||  q -> P [p, q] (&y)
end

m

property fair is ltl [] (<> (m/1/state busy)) => () (not (m/value x / 2 = 1))
assert fair // holds
)";
  CHECK(firstDifference(checked(text), text) == "");
}

TEST_CASE("statements get lines by what they are") {
  CHECK(formatted("process P(&x:nat)is states a,b var y:nat:=1 init to a from a select x:=[] [ 0 ];"
                  "to a[]wait[0,1];while x<3 do x:=x+1;y:=-1 end;to b end from b loop component c "
                  "is var x:nat:=0 par*in P(&x)end c") ==
        "process P (&x: nat) is\nstates a, b\nvar y: nat := 1\ninit\n    to a\n\nfrom a\n"
        "    select\n        x := [][0];\n        to a\n    []  wait [0,1];\n"
        "        while x < 3 do\n            x := x + 1;\n            y := -1\n        end;\n"
        "        to b\n    end\n\nfrom b\n    loop\n\ncomponent c is\nvar x: nat := 0\npar * in\n"
        "    P (&x)\nend\n\nc\n");
}

TEST_CASE("what cannot be read is not laid out") {
  CHECK_FALSE(fiacre::format("process P is states a from a to"));
  CHECK_FALSE(fiacre::formatChanges("/* no end"));
}

} // namespace proskill::test::format_test
