#include "fiacre/check/check.h"
#include "fiacre/format/format.h"
#include "fiacre/print/print.h"
#include "fiacre/syntax/parse.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

/// The errors in a text; empty if it is valid.
std::string problemsOf(const std::string& text) {
  const auto parsed = fiacre::parse(text);
  std::string all;
  for (const auto& problem : parsed.problems) all += problem.message + "\n";
  if (all.empty())
    for (const auto& problem : fiacre::check(parsed.program))
      if (problem.place != "model") all += problem.message + "\n";
  return all;
}

/// The text is valid, and formatting its formatted form changes nothing.
void isRead(const std::string& text) {
  INFO(text);
  CHECK(problemsOf(text) == "");
  const auto once = fiacre::format(text);
  REQUIRE(once.has_value());
  CHECK(problemsOf(*once) == "");
  CHECK(fiacre::format(*once) == once);
}

} // namespace

TEST_CASE("an `end` may repeat the word that it ends") {
  isRead("type three is 0..2\n"
         "process P (&a: array 3 of 0..9) is\nstates s\nvar i: three\n"
         "from s\n    foreach i do a[i] := 1 end foreach;\n    while a[0] > 5 do a[0] := 0 end "
         "while;\n    if a[1] = 0 then null end if;\n    to s\n\n"
         "component C is\nvar a: array 3 of 0..9 := [0, 0, 0]\npar\n    P (&a)\nend par\n\nC\n");
}

TEST_CASE("an `end par` may stand in a composition within another") {
  isRead("process P is\nstates s\nfrom s\n    to s\n\n"
         "component C is\npar * in\n    par\n        P\n    ||  P\n    end par\n||  P\nend "
         "par\n\nC\n");
}

TEST_CASE("what carries nothing may say in which direction") {
  isRead("process P [a: in none, b: out none, c: in out sync, d: in sync] is\nstates s\n"
         "from s\n    select\n        a;\n        to s\n    []  b;\n        to s\n    []  c;\n"
         "        to s\n    []  d;\n        to s\n    end\n\nP\n");
}

TEST_CASE("a channel is the type of a port, whichever way its values go") {
  isRead("channel two is nat # bool\nchannel nothing is none\n\n"
         "process A [p: out two, q: in nothing] is\nstates s\nfrom s\n    select\n        p!1, "
         "true;\n        to s\n    []  q;\n        to s\n    end\n\n"
         "process B [p: in two, q: nothing] is\nstates s\nvar n: nat, b: bool\nfrom s\n"
         "    select\n        p?n, b;\n        to s\n    []  q;\n        to s\n    end\n\n"
         "component C is\nport p: two in [0,1], q: nothing\npar * in\n    A [p, q]\n||  B [p, "
         "q]\nend\n\nC\n");
}

TEST_CASE("constructors of a union may share the type of their value") {
  const auto parsed = fiacre::parse("type u is union a, b of 0..3 | c, d end\n");
  REQUIRE(parsed.problems.empty());
  const auto& members = parsed.program.types[0].type.members;
  REQUIRE(members.size() == 4);
  CHECK(members[0].name == "a");
  CHECK(members[0].type == members[1].type);
  CHECK(members[1].type.size() == 1);
  CHECK(members[2].type.empty());
  CHECK(members[3].name == "d");
}

TEST_CASE("a `+` may stand before a number") {
  isRead("const k: int is -(+3)\n\nprocess P is\nstates s\nvar i: int := +k\nfrom s\n    i := i - "
         "+1;\n    to s\n\nP\n");
}

TEST_CASE("a function of one line needs no `begin`, and no parameters") {
  isRead("function next(x: nat): nat is return x + 1\n\n"
         "function two(): nat is return 2\n\n"
         "process P (&x: nat) is\nstates s\nfrom s\n    x := next(two());\n    to s\n");
}

TEST_CASE("words of H-Fiacre are names where nothing of it stands") {
  isRead("process P [event: none] (&task: nat) is\nstates start, extern\n"
         "from start\n    task := 1;\n    to extern\n\nfrom extern\n    event;\n    to start\n\n"
         "component C is\nvar x: nat\nport e: none\npar * in\n    P [e] (&x)\nend\n\nC\n\n"
         "property p is absent C/1/state start\nassert p\n");
}

TEST_CASE("a task is started, and its name may be `start`'s neighbour") {
  isRead("task look (): nat is c_look\n\n"
         "process P is\nstates start, wait_\nvar n: nat\n"
         "from start\n    start look();\n    to wait_\n\nfrom wait_\n    sync look n;\n    to "
         "start\n");
}

TEST_CASE("the layout of what dialects write is that of its like") {
  CHECK(fiacre::format("function next(x: nat): nat is return x + 1 "
                       "process P (&task: array 3 of nat) is states start "
                       "from start while task[0] > 1 do task[0] := 0 end while; to start "
                       "component C is var a: array 3 of nat := [0,0,0] par P (&a) end par C") ==
        R"(function next (x: nat): nat is
    return x + 1

process P (&task: array 3 of nat) is
states start

from start
    while task[0] > 1 do task[0] := 0 end while;
    to start

component C is
var a: array 3 of nat := [0, 0, 0]
par
    P (&a)
end par

C
)");
}

TEST_CASE("a text may begin with a byte order mark, and keeps it") {
  const std::string text = "\xEF\xBB\xBFprocess P is\nstates s\n\nfrom s\n    to s\n\nP\n";
  isRead(text);
  CHECK(fiacre::format(text) == text);
}

TEST_CASE("`release` is the dual of `until`") {
  const auto pattern = [](const std::string& formula) {
    const auto parsed = fiacre::parse("process P is\nstates s, t\nfrom s to t from t to s\nP\n"
                                      "property p is ltl " +
                                      formula + "\nassert p\n");
    REQUIRE(parsed.problems.empty());
    return fiacre::printPattern(parsed.program.properties[0].pattern, "P");
  };
  CHECK(pattern("P/state s release P/state t") ==
        pattern("not ((not P/state s) until (not P/state t))"));
}

TEST_CASE("of two `from` of one state the second is told, with what to do") {
  const std::string text = "process P is\nstates s, t\n\nfrom s\n    to t\n\nfrom t\n    to s\n\n"
                           "from s\n    to s\n\nP\n";
  const auto parsed = fiacre::parse(text);
  const auto problems = fiacre::check(parsed.program);
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].message == "the state `s` has two `from`: join them with `select`");
  const auto& place = parsed.provenance.origins.at(problems[0].origin);
  CHECK(text.substr(place.begin, place.end - place.begin) == "from s\n    to s");
  CHECK(place.begin > text.find("from t"));
}

TEST_CASE(
    "a pattern may stand on the left of `:=` and behind `?`, with `any` for what is ignored") {
  isRead("type opt is union none_ | some of 0..3 end\n\n"
         "process P [p: in 0..3 # 0..3, q: out 0..3 # 0..3] (b: bool, o: opt) is\nstates s\n"
         "var x: 0..3\nfrom s\n    select\n        true := b;\n        to s\n"
         "    []  some(x) := o;\n        to s\n    []  p?any, x;\n        to s\n"
         "    []  q!1, 2;\n        to s\n"
         "    []  case o of\n            some(any) ->\n            to s\n"
         "        |   any ->\n            to s\n        end\n    end\n");
  CHECK_FALSE(problemsOf("process P (b: bool) is states s from s 2 := b; to s").empty());
}

TEST_CASE("parameters of a task may have names") {
  isRead("task mv (x: nat): nat is c_mv\ntask two (x, y: nat, bool): nat is c_two\n"
         "process P is\nstates s, t\nvar n: nat\nfrom s\n    start mv (1);\n    to t\nfrom t\n"
         "    sync mv n;\n    to s\n\nP\n");
}
