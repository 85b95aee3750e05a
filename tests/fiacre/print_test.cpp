#include "tests/fiacre/printed.h"

#include "fiacre/print/print.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <sstream>

using namespace proskill::fiacre;
using namespace proskill::fiacre::test;

namespace {

std::string line(const std::string& text, std::size_t number) {
  std::istringstream lines(text);
  std::string found;
  for (std::size_t i = 0; i <= number; ++i) std::getline(lines, found);
  return found;
}

std::size_t longestLine(const std::string& text) {
  std::istringstream lines(text);
  std::size_t longest = 0;
  for (std::string each; std::getline(lines, each);) longest = std::max(longest, each.size());
  return longest;
}

} // namespace

TEST_CASE("the triple click detector prints as a person would write it") {
  CHECK(print(tripleClick()) == R"(// A triple click detector. The unit of time is 0.1 s.

// Makes clicks at any time.
process clicker [click: sync] is
states wait_click, make_click

from wait_click
    wait [0,...[; // any time from zero to infinity
    to make_click

from make_click
    click; // issue a click
    to wait_click

process detect_triple_click [click: sync, triple_click: sync] is
states wait_first, wait_second, wait_third, detected

from wait_first
    click; // first click
    to wait_second

from wait_second
    select
        wait [2,2];
        to wait_first // too late
    []
        click;
        to wait_third
    end

from wait_third
    select
        wait [2,2];
        to wait_first // too late
    []
        click;
        to detected
    end

from detected
    triple_click;
    to wait_first

process triple_click_receiver [triple_click: sync] is
states waiting_tc, received_tc

from waiting_tc
    triple_click;
    to received_tc

from received_tc
    // do what needs to be done
    to waiting_tc

component comp_tc is
port click: sync in [0,0], triple_click: sync in [0,0]
par * in
    detect_triple_click [click, triple_click]
||  clicker [click]
||  triple_click_receiver [triple_click]
end

comp_tc

property ddlf is deadlockfree
assert ddlf

// violated: a triple click can be received
property cannot_receive_tc is absent comp_tc/3/state received_tc
assert cannot_receive_tc
)");
}

TEST_CASE("properties are proved where newer tools want it") {
  const auto text = print(tripleClick(), {.prove = true});
  CHECK(text.find("prove ddlf\n") != std::string::npos);
  CHECK(text.find("assert") == std::string::npos);
}

TEST_CASE("everything compound in an expression is in parentheses, atoms are not") {
  const auto caller = field(index(name("skill"), name("takeoff")), "caller");
  const auto called = unary(Op::Not, binary(Op::Equal, caller, name("None")));
  CHECK(printExpr(called) == "not (skill[takeoff].caller = None)");
  CHECK(printExpr(binary(Op::And, called, binary(Op::And, name("a"), name("b")))) ==
        "(not (skill[takeoff].caller = None)) and a and b");
  CHECK(printExpr(binary(Op::Or, name("a"), binary(Op::And, name("b"), name("c")))) ==
        "a or (b and c)");
  CHECK(printExpr(binary(Op::Subtract, number(1), binary(Op::Subtract, number(2), number(-3)))) ==
        "1 - (2 - (-3))");
  CHECK(printExpr(unary(Op::Not, unary(Op::Empty, name("q")))) == "not (empty q)");
  CHECK(printExpr(unary(Op::Coerce, binary(Op::Add, name("x"), number(1)))) == "$(x + 1)");
  CHECK(printExpr(binary(Op::Enqueue, name("q"), name("x"))) == "enqueue(q, x)");
  CHECK(printExpr(unary(Op::First, unary(Op::Dequeue, name("q")))) == "first (dequeue q)");
  CHECK(printExpr({.kind = ExprKind::Conditional,
                   .operands = {binary(Op::Less, name("x"), number(2)), number(1), name("x")}}) ==
        "((x < 2) ? 1 : x)");
  CHECK(printExpr({.kind = ExprKind::Array, .operands = {truth(true), truth(false)}}) ==
        "[true, false]");
  CHECK(printExpr({.kind = ExprKind::Record,
                   .fields = {"f", "g"},
                   .operands = {number(1), truth(true)}}) == "{f=1, g=true}");
  CHECK(printExpr({.kind = ExprKind::Queue, .operands = {number(1), number(2)}}) == "{|1, 2|}");
  CHECK(printExpr(call("now", {})) == "now()");
}

TEST_CASE("an lvalue prints as its Fiacre text") {
  CHECK(printLvalue(field(index(name("skill"), name("takeoff")), "status")) ==
        "skill[takeoff].status");
}

TEST_CASE("intervals print with their brackets") {
  CHECK(printInterval({.lower = 0, .upper = 0}) == "[0,0]");
  CHECK(printInterval({.lower = 3, .upper = 5, .lowerOpen = true, .upperOpen = true}) == "]3,5[");
  CHECK(printInterval({.lower = 7}) == "[7,...[");
}

TEST_CASE("tasks, event ports and externs of H-Fiacre") {
  Process receiver = process(
      "r", {"a", "b"},
      {from("a",
            {{.kind = StatementKind::Start, .name = "report", .values = {number(3), name("x")}},
             to("b")}),
       from("b",
            {{.kind = StatementKind::Sync, .name = "report", .targets = {name("x")}}, to("a")})});
  receiver.variables = {{.name = "x", .type = nat()}};
  Program program{.eventPorts = {{{.name = "click"}, "c_click"}},
                  .tasks = {{"report", {nat(), nat()}, nat(), "c_report"}},
                  .externs = {{"stop", {}, boolean(), "c_stop"}},
                  .processes = {receiver},
                  .main = "r"};
  CHECK(print(program) == R"(event click: sync is c_click

task report (nat, nat): nat is c_report

extern stop (): bool is c_stop

process r is
states a, b
var x: nat

from a
    start report(3, x);
    to b

from b
    sync report x;
    to a

r
)");
}

TEST_CASE("types and constants") {
  auto status = unionOf({"no_status", "success"});
  status.members[0].comment = "not yet called";
  Program program{
      .constants = {{"size", nat(), number(3)}},
      .types = {{"level", range(0, 5), "how full"},
                {"battery", unionOf({"Good", "Low"}), {}},
                {"status", status, {}},
                {"cells", array(3, record({{"f", boolean()}, {"g", named("level")}})), {}},
                {"line", queue(2, nat()), {}}}};
  CHECK(print(program) == R"(const size: nat is 3

type level is 0..5 // how full
type battery is union Good | Low end
type status is union
    no_status | // not yet called
    success
end
type cells is array 3 of record f: bool, g: level end
type line is queue 2 of nat
)");
}

TEST_CASE("a function has variables and a body") {
  Program program{.functions = {{.name = "twice",
                                 .comment = "Two times n.",
                                 .parameters = {{"n", nat()}},
                                 .result = nat(),
                                 .variables = {{.name = "r", .type = nat(), .init = number(0)}},
                                 .body = sequence(
                                     {assign(name("r"), binary(Op::Multiply, number(2), name("n"))),
                                      {.kind = StatementKind::Return, .values = {name("r")}}})}}};
  CHECK(print(program) == R"(// Two times n.
function twice (n: nat): nat is
    var r: nat := 0
begin
    r := 2 * n;
    return r
end
)");
}

TEST_CASE("a component has variables, ports, priorities and instances") {
  Component main{.name = "main",
                 .variables = {{.name = "x", .type = nat(), .init = number(0), .comment = "shared"},
                               {.name = "y", .type = boolean()}},
                 .ports = {{.name = "a", .values = {nat(), boolean()}, .in = true, .out = true},
                           {.name = "b", .interval = Interval{.lower = 1, .lowerOpen = true}}},
                 .priorities = {{{"a"}, {"b", "c"}}, {{"b"}, {"d"}}},
                 .init = assign(name("x"), number(1)),
                 .instances = {{.process = "p",
                                .ports = {"a", "b"},
                                .arguments = {name("x"), number(2)},
                                .references = {true, false}}}};
  CHECK(print({.components = {main}, .main = "main"}) == R"(component main is
var x: nat := 0, // shared
    y: bool
port a: in out nat # bool, b: sync in ]1,...[
priority a > b | c, b > d
init
    x := 1
par * in
    p [a, b] (&x, 2)
end

main
)");
}

TEST_CASE("patterns of properties") {
  const Observable state{.kind = ObservableKind::State, .path = {1, 2}, .name = "s"};
  const Observable bears{.kind = ObservableKind::Tag, .path = {3}, .name = "t"};
  const Observable holds{
      .kind = ObservableKind::Value, .path = {}, .value = binary(Op::Equal, name("x"), number(1))};
  const Observable both{.kind = ObservableKind::And, .operands = {state, bears}};
  const Observable negated{.kind = ObservableKind::Not, .operands = {holds}};
  const Observable enters{.kind = ObservableKind::Enter, .operands = {state}};
  const auto text = [](Pattern pattern) { return printPattern(pattern, "m"); };

  CHECK(text({.kind = PatternKind::Absent, .operands = {bears}}) == "absent m/3/tag t");
  CHECK(text({.kind = PatternKind::Always, .operands = {negated}}) ==
        "always (not (m/value (x = 1)))");
  CHECK(
      text({.kind = PatternKind::Absent,
            .operands = {both},
            .after = enters,
            .forInterval = Interval{.lower = 0, .upper = 3, .upperOpen = true}}) ==
      "absent ((m/1/2/state s) and (m/3/tag t)) after (enter (m/1/2/state s)) for interval [0,3[");
  CHECK(text({.kind = PatternKind::Present, .operands = {state}, .before = bears, .lasting = 4}) ==
        "present m/1/2/state s before m/3/tag t lasting 4");
  CHECK(text({.kind = PatternKind::LeadsTo,
              .operands = {state, bears},
              .within = Interval{.lower = 1, .upper = 1}}) ==
        "(m/1/2/state s) leadsto (m/3/tag t) within [1,1]");
  CHECK(text({.kind = PatternKind::Precedes, .operands = {state, bears}}) ==
        "(m/1/2/state s) precedes (m/3/tag t)");
  CHECK(text({.kind = PatternKind::InfinitelyOften, .operands = {state}}) ==
        "infinitelyoften m/1/2/state s");

  const Ltl atom{.atom = state};
  const Ltl eventually{.kind = LtlKind::Finally, .operands = {{.atom = bears}}};
  const Ltl implies{.kind = LtlKind::Implies, .operands = {atom, eventually}};
  CHECK(
      text({.kind = PatternKind::Ltl, .ltl = {.kind = LtlKind::Globally, .operands = {implies}}}) ==
      "ltl [] ((m/1/2/state s) => (<> (m/3/tag t)))");
}

TEST_CASE("what Fiacre has no pattern for is a comment") {
  Program program{.main = "m",
                  .properties = {{.name = "time", .pattern = {.kind = PatternKind::Progress}}}};
  CHECK(print(program) == "m\n\n// property time is time can always progress\n");
}

TEST_CASE("where a model may stop is told in a comment") {
  const Observable end{.kind = ObservableKind::State, .path = {1}, .name = "ended"};
  Program program{
      .main = "m",
      .properties = {
          {.name = "runs", .pattern = {.kind = PatternKind::DeadlockFree, .operands = {end}}}}};
  CHECK(print(program) ==
        "m\n\n// It may stop where m/1/state ended.\nproperty runs is deadlockfree\nassert runs\n");
}

TEST_CASE("long lists of parameters and conditions go on below their parenthesis") {
  auto skill = process("skill_takeoff", {"idle"}, {});
  skill.ports = {{.name = "interrupt_takeoff", .comment = "stops it"}};
  skill.parameters = {{"skill", named("skill_array"), true},
                      {"flight_status", named("sv_flight_status"), true},
                      {"mission_status", named("sv_mission_status"), true},
                      {"motion", named("sv_motion"), true}};
  Expr condition = binary(Op::Equal, name("flight_status"), name("OnGround"));
  for (const auto* each : {"mission_status", "localization_status", "battery_status"})
    condition = binary(Op::And, condition, binary(Op::Equal, name(each), name("SomeValue")));
  skill.transitions = {from("idle", {ifThen(condition, to("idle")), to("idle")})};

  const auto text = print({.processes = {skill}});
  CHECK(text == R"(// interrupt_takeoff: stops it
process skill_takeoff
    [interrupt_takeoff: sync]
    (&skill: skill_array, &flight_status: sv_flight_status, &mission_status: sv_mission_status,
     &motion: sv_motion) is

states idle

from idle
    if ((flight_status = OnGround) and (mission_status = SomeValue) and
        (localization_status = SomeValue) and (battery_status = SomeValue)) then
        to idle
    end;
    to idle
)");
}

TEST_CASE("no comment is lost and none makes a line too long") {
  std::string words;
  for (int i = 0; i < 60; ++i) words += "word" + std::to_string(i) + " ";
  const auto text = printed({with(words, tag("t")), with("first\nsecond", tag("u")), to("s")});
  CHECK(longestLine(text) <= 100);
  for (int i = 0; i < 60; ++i) CHECK(text.find("word" + std::to_string(i)) != std::string::npos);
  CHECK(text.find("    // first\n    // second\n    #u;\n") != std::string::npos);
}

TEST_CASE("the lines of a model know their place in the program") {
  auto inner = assign(name("x"), number(1));
  inner.origin = 7;
  auto branch = select({sequence({inner, to("s")})});
  branch.origin = 6;
  auto made = process("p", {"s"}, {from("s", {branch})});
  made.origin = 4;
  made.states[0].origin = 5;
  const auto result = printWithRanges({.processes = {made}});

  REQUIRE(result.ranges.size() == 4);
  const auto lines = [&](std::size_t i) {
    const auto& range = result.ranges[i];
    return std::pair(line(result.text, range.firstLine), line(result.text, range.lastLine));
  };
  CHECK(result.ranges[0].origin == 4);
  CHECK(lines(0) == std::pair<std::string, std::string>("process p is", "    end"));
  CHECK(result.ranges[1].origin == 5);
  CHECK(lines(1) == std::pair<std::string, std::string>("from s", "    end"));
  CHECK(result.ranges[2].origin == 6);
  CHECK(lines(2) == std::pair<std::string, std::string>("    select", "    end"));
  CHECK(result.ranges[3].origin == 7);
  CHECK(lines(3) == std::pair<std::string, std::string>("        x := 1;", "        x := 1;"));
}
