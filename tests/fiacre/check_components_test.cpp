#include "tests/fiacre/clean_model.h"

#include "fiacre/check/check.h"
#include "fiacre/syntax/parse.h"

#include <catch2/catch.hpp>

using namespace proskill::fiacre;
using namespace proskill::fiacre::test;

TEST_CASE("ports are declared and carry what they are declared to") {
  CHECK(whenIdle({port("go"), to("busy")}) == Found{kIdle + "the port `go` is not declared"});
  CHECK(whenIdle({{.kind = StatementKind::Send, .name = "stop", .values = {number(1)}},
                  to("busy")}) == Found{kIdle + "the port `stop` carries 0 values, not 1"});
  CHECK(whenIdle({{.kind = StatementKind::Receive, .name = "stop", .targets = {name("n")}},
                  to("busy")}) == Found{kIdle + "the port `stop` carries 0 values, not 1"});
}

TEST_CASE("instances get the ports and the arguments of their process") {
  const auto instance = [](auto change) {
    return changed([&](Program& p) { change(p.components[0].instances[0]); });
  };
  CHECK(changed([](Program& p) { p.components[0].instances[1].process = "nobody"; }) ==
        Found{"component main: there is no process or component `nobody`"});
  CHECK(instance([](Instance& i) { i.ports = {}; }) ==
        Found{"component main: worker takes 1 ports, not 0"});
  CHECK(instance([](Instance& i) { i.ports = {"go"}; }) ==
        Found{"component main: the port `go` is not declared"});
  CHECK(instance([](Instance& i) { i.arguments.pop_back(); }) ==
        Found{"component main: worker takes 2 arguments, not 1"});
  CHECK(instance([](Instance& i) { i.arguments[1] = truth(true); }) ==
        Found{"component main: `true` is of the type bool, not nat"});
  CHECK(instance([](Instance& i) {
          i.references = {false, false};
        }) == Found{"component main: `cells` of worker must be passed by reference, not by value"});
  CHECK(changed([](Program& p) {
          p.components[0].variables[0] = {.name = "cells", .type = nat(), .init = number(0)};
        }) == Found{"component main: `cells` of worker refers to a variable of another type"});
  CHECK(changed([](Program& p) { p.components[0].ports[0].values = {nat()}; }) ==
        Found{"component main: the port `stop` carries other values than `stop` of worker",
              "component main: the port `stop` carries other values than `stop` of stopper"});
}

TEST_CASE("the components hang together") {
  CHECK(changed([](Program& p) {
          p.main.clear();
          p.properties = {};
        }) == Found{"model: its name is missing: the model must end with the name of a component"});
  CHECK(changed([](Program& p) {
          p.main = "nobody";
          p.properties = {};
        }) == Found{"model: there is no main component `nobody`"});
  CHECK(changed([](Program& p) {
          p.main = "worker";
          p.properties = {};
        }) == Found{"model: the main component `worker` needs ports or arguments"});
  CHECK(changed([](Program& p) { p.components[0].instances.push_back({.process = "main"}); }) ==
        Found{"component main: the component contains itself"});
  CHECK(changed([](Program& p) {
          p.components[0].priorities = {{{"stop"}, {"go"}}};
        }) == Found{"component main: the port `go` is not declared"});
  CHECK(changed([](Program& p) { p.components.push_back({.name = "idle_one"}); }) ==
        Found{"component idle_one: a component needs an instance"});
}

TEST_CASE("observers stand beside the model, and probes look at it") {
  const auto problem = [](const std::string& probe, const std::string& attached) {
    const auto parsed = parse("process P is states s, t from s #gone; to t "
                              "component main is port a: sync par par P end || P end "
                              "process W [p: sync] is states u, v from u p; to v "
                              "component watch is port p: " +
                              probe + " par W[p] end main " + attached);
    REQUIRE(parsed.problems.empty());
    std::string all;
    for (const auto& each : check(parsed.program)) all += each.place + ": " + each.message + "\n";
    return all;
  };
  const std::string component = "component watch: ";
  CHECK(problem("sync in [0,0] is main/1/1/state s", "watch > main") == "");
  CHECK(problem("sync is main/2/tag gone", "watch > main") == "");
  CHECK(problem("sync in [0,0] is main/1/state s", "watch > main") ==
        component + "`state s` does not belong to a process\n");
  CHECK(problem("sync is main/1/1/state u", "watch > main") ==
        component + "process P has no state `u`\n");
  CHECK(problem("sync is main/1/2/state s", "watch > main") ==
        component + "the path main/1/2 leads nowhere\n");
  CHECK(problem("sync in [1,1] is main/2/tag gone", "watch > main") ==
        component + "the probe of `p` observes steps: it is passed with them and cannot have an "
                    "interval of its own\n");
  CHECK(problem("sync in [0,0] is watch/1/state u", "watch > main") ==
        component + "the probe of `p` refers to an observer: a probe can only observe the model\n");
  CHECK(problem("sync", "watch > watch") ==
        "observer watch: `watch` is observed, but the model is `main`\n");
  CHECK(problem("sync", "watch > main watch > main") ==
        "observer watch: `watch` is already declared as an observer\n");
  CHECK(problem("sync", "W > main") == "observer W: the component `W` needs ports or arguments\n");
  CHECK(problem("sync", "nobody > main") == "observer nobody: there is no component `nobody`\n");
}

TEST_CASE("what properties look at exists") {
  const auto absent = [](Observable o) { return onProperty(PatternKind::Absent, {std::move(o)}); };
  CHECK(absent({.kind = ObservableKind::State, .path = {1}, .name = "busy"}) == Found{});
  CHECK(absent({.kind = ObservableKind::Event, .name = "stop"}) == Found{});
  CHECK(absent({.kind = ObservableKind::Value,
                .path = {1},
                .value = binary(Op::Equal, name("n"), number(3))}) == Found{});
  CHECK(absent({.kind = ObservableKind::State, .path = {1}, .name = "run"}) ==
        Found{"property p: process worker has no state `run`"});
  CHECK(absent({.kind = ObservableKind::State, .path = {3}, .name = "run"}) ==
        Found{"property p: the path main/3 leads nowhere"});
  CHECK(absent({.kind = ObservableKind::State, .path = {1, 1}, .name = "run"}) ==
        Found{"property p: the path main/1/1 leads nowhere"});
  CHECK(absent({.kind = ObservableKind::Tag, .path = {2}, .name = "begun"}) ==
        Found{"property p: process stopper has no tag `begun`"});
  CHECK(absent({.kind = ObservableKind::Event, .path = {1}, .name = "stop"}) ==
        Found{"property p: the path to the event `stop` names no component that declares it"});
  CHECK(absent({.kind = ObservableKind::Value, .path = {1}, .value = name("n")}) ==
        Found{"property p: `n` is of the type 0..5, not bool"});
  CHECK(onProperty(PatternKind::LeadsTo, {}) ==
        Found{"property p: the pattern has 0 operands, not 2"});
  CHECK(onProperty(PatternKind::Progress, {}) == Found{});
}

TEST_CASE("tasks and event ports are used as they are declared") {
  auto program = clean();
  program.tasks = {{"report", {nat()}, nat(), "c_report"}};
  program.eventPorts = {{{.name = "click"}, "c_click"}};
  const auto idle = [&](std::vector<Statement> statements) {
    statements.insert(statements.begin(), tag("begun"));
    program.processes[0].transitions[0] = from("idle", std::move(statements));
    return problems(program);
  };
  const auto start = [](std::string task, std::vector<Expr> values) {
    return Statement{
        .kind = StatementKind::Start, .name = std::move(task), .values = std::move(values)};
  };
  const auto sync = [](std::string task, Expr target) {
    return Statement{
        .kind = StatementKind::Sync, .name = std::move(task), .targets = {std::move(target)}};
  };
  CHECK(idle({start("report", {number(1)}), to("busy")}) == Found{});
  CHECK(idle({sync("report", name("n")), to("busy")}) == Found{});
  CHECK(idle({port("click"), to("busy")}) == Found{});
  CHECK(idle({start("nothing", {}), to("busy")}) ==
        Found{kIdle + "the task `nothing` is not declared"});
  CHECK(idle({start("report", {}), to("busy")}) ==
        Found{kIdle + "the task `report` takes 1 values, not 0"});
  CHECK(idle({sync("report", field(index(name("cells"), number(0)), "lit")), to("busy")}) ==
        Found{kIdle + "`cells[0].lit` is of the type bool, not nat"});
  program.processes[0].ports[0].name = "click";
  CHECK(idle({to("busy")}) == Found{"process worker: the port `click` hides an event port",
                                    "process worker, state busy: the port `stop` is not declared"});
}
