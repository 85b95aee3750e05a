#include "tests/fiacre/build.h"
#include "tests/support/oracle/judge.h"

#include <catch2/catch.hpp>

using namespace proskill;
using namespace proskill::fiacre;
using namespace proskill::fiacre::test;

namespace {

/// The processes in parallel, all with the same variables and ports.
Program system(std::vector<Process> processes, std::vector<Variable> variables = {},
               std::vector<Port> ports = {}) {
  Component main{.name = "Main", .variables = std::move(variables), .ports = std::move(ports)};
  for (auto& each : processes) {
    Instance instance{.process = each.name};
    for (const auto& variable : main.variables) {
      each.parameters.push_back({variable.name, variable.type, true});
      instance.arguments.push_back(name(variable.name));
      instance.references.push_back(true);
    }
    for (const auto& formal : each.ports) instance.ports.push_back(formal.name);
    main.instances.push_back(std::move(instance));
  }
  return {.processes = std::move(processes), .components = {main}, .main = "Main"};
}

Statement waitIn(Interval interval) { return {.kind = StatementKind::Wait, .interval = interval}; }

bool reaches(const Program& program, std::uint32_t instance, std::string state) {
  oracle::Interpreter model(program);
  oracle::RegionGraph graph(model, 10'000);
  REQUIRE(graph.complete());
  Observable there{.path = {instance}, .name = std::move(state)};
  return !*oracle::isTrue(model, graph, {.kind = PatternKind::Absent, .operands = {there}});
}

bool isTrue(const Program& program, PatternKind kind) {
  oracle::Interpreter model(program);
  oracle::RegionGraph graph(model, 10'000);
  return *oracle::isTrue(model, graph, {.kind = kind});
}

/// Whether a process that takes `first` can do so when another may stop it in `second`.
bool firstCanWin(Interval first, Interval second) {
  Process runner =
      process("runner", {"run", "won"},
              {from("run", {on(unary(Op::Not, name("late"))), waitIn(first), to("won")})});
  Process rival =
      process("rival", {"run", "done"},
              {from("run", {waitIn(second), assign(name("late"), truth(true)), to("done")})});
  return reaches(system({runner, rival}, {{"late", boolean(), truth(false)}}), 1, "won");
}

} // namespace

TEST_CASE("who is later at the latest can still win a race at the bound itself") {
  CHECK(firstCanWin({.lower = 2, .upper = 2}, {.lower = 1, .upper = 2}));
  CHECK(firstCanWin({.lower = 2, .upper = 3}, {.lower = 2, .upper = 2}));
  CHECK_FALSE(firstCanWin({.lower = 3, .upper = 3}, {.lower = 1, .upper = 2}));
}

TEST_CASE("an open bound is never reached") {
  CHECK_FALSE(firstCanWin({.lower = 2, .upper = 2}, {.lower = 1, .upper = 2, .upperOpen = true}));
  CHECK_FALSE(firstCanWin({.lower = 2, .lowerOpen = true}, {.lower = 2, .upper = 2}));
  CHECK(firstCanWin({.lower = 1, .lowerOpen = true}, {.lower = 2, .upper = 2, .upperOpen = true}));
}

TEST_CASE("three strict windows leave room for one order alone") {
  // b within the first unit, a after it started, c between them: fractions decide, not integer
  // dates
  auto within = [](std::string text, std::string after, std::string sets) {
    return process(
        text, {"run", "done"},
        {from("run", {on(name(after)),
                      waitIn({.lower = 0, .upper = 1, .lowerOpen = true, .upperOpen = true}),
                      assign(name(sets), truth(true)), to("done")})});
  };
  Process a = within("a", "go", "a_done");
  Process b = within("b", "a_done", "b_done");
  Process c = within("c", "b_done", "c_done");
  Process clock = process("clock", {"run", "early", "late"},
                          {from("run", {waitIn({.lower = 1, .upper = 1}),
                                        ifElse(name("c_done"), to("early"), to("late"))})});
  std::vector<Variable> variables;
  for (const char* text : {"go", "a_done", "b_done", "c_done"})
    variables.push_back({text, boolean(), truth(std::string(text) == "go")});
  CHECK(reaches(system({a, b, c, clock}, variables), 4, "early"));
  CHECK(reaches(system({a, b, c, clock}, variables), 4, "late"));
}

TEST_CASE("`loop` lets the other clocks of its process go on, `to` the same state does not") {
  auto beating = [](Statement end) {
    return system({process("p", {"run", "done"},
                           {from("run", {select({sequence({wait(1, 1), std::move(end)}),
                                                 sequence({wait(2, 2), to("done")})})})})});
  };
  CHECK(reaches(beating({.kind = StatementKind::Loop}), 1, "done"));
  CHECK_FALSE(reaches(beating(to("run")), 1, "done"));
}

TEST_CASE("a guard that fails in between makes a clock start again") {
  Process blink =
      process("blink", {"run"},
              {from("run", {wait(1, 1), assign(name("on_air"), unary(Op::Not, name("on_air"))),
                            to("run")})});
  Process listener = process("listener", {"run", "done"},
                             {from("run", {on(name("on_air")), wait(2, 2), to("done")})});
  CHECK_FALSE(reaches(system({blink, listener}, {{"on_air", boolean(), truth(true)}}), 2, "done"));
}

TEST_CASE("a test inside a path does not make its clock start again") {
  Process blink =
      process("blink", {"run"},
              {from("run", {wait(1, 1), assign(name("on_air"), unary(Op::Not, name("on_air"))),
                            to("run")})});
  Process worker =
      process("worker", {"run", "done"},
              {from("run", {wait(3, 3), ifThen(name("on_air"), tag("seen")), to("done")})});
  CHECK(reaches(system({blink, worker}, {{"on_air", boolean(), truth(true)}}), 2, "done"));
}

TEST_CASE("a port needs everyone who is given it, and sees the state before the step") {
  Process giver = process("giver", {"run", "done"},
                          {from("run", {port("p"), assign(name("level"), number(1)), to("done")})});
  Process taker = process(
      "taker", {"run", "done"},
      {from("run", {on(binary(Op::Equal, name("level"), number(0))), port("p"), to("done")})});
  Process third = process("third", {"run", "gone"}, {from("run", {wait(1, 1), to("gone")})});
  for (auto* each : {&giver, &taker}) each->ports = {{.name = "p"}};
  std::vector<Variable> variables{{"level", range(0, 2), number(0)}};
  std::vector<Port> ports{{.name = "p", .interval = Interval{.lower = 2, .upper = 2}}};
  CHECK(reaches(system({giver, taker, third}, variables, ports), 2, "done"));
  third.ports = giver.ports;
  CHECK_FALSE(reaches(system({giver, taker, third}, variables, ports), 2, "done"));
}

TEST_CASE("time stops where urgent steps go round for ever, and nothing moves in a deadlock") {
  Process spin = process("spin", {"run"}, {from("run", {wait(0, 0), to("run")})});
  Process stop = process("stop", {"run", "end_"}, {from("run", {wait(0, 1), to("end_")})});
  CHECK_FALSE(isTrue(system({spin}), PatternKind::Progress));
  CHECK(isTrue(system({spin}), PatternKind::DeadlockFree));
  CHECK(isTrue(system({stop}), PatternKind::Progress));
  CHECK_FALSE(isTrue(system({stop}), PatternKind::DeadlockFree));
}

TEST_CASE("the triple click detector detects, and never stops") {
  Program program = tripleClick();
  CHECK(reaches(program, 3, "received_tc"));
  CHECK(isTrue(program, PatternKind::DeadlockFree));
  CHECK(isTrue(program, PatternKind::Progress));
}
