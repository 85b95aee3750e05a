#include "tests/fiacre/build.h"

#include "fiacre/check/check.h"
#include "fiacre/syntax/parse.h"
#include "fiacre/syntax/words.h"

#include <catch2/catch.hpp>

using namespace proskill::fiacre;
using namespace proskill::fiacre::test;

namespace {

using Found = std::vector<std::string>;

/// Each problem as "place: message".
Found problems(const Program& program) {
  Found found;
  for (const auto& problem : check(program))
    found.push_back(problem.place + ": " + problem.message);
  return found;
}

/// A model with a bit of everything, in which nothing is wrong: two cells, a worker that it calls.
Program clean() {
  auto worker = process(
      "worker", {"idle", "busy"},
      {from("idle", {wait(0, 0), on(field(index(name("cells"), name("left")), "lit")), tag("begun"),
                     to("busy")}),
       from("busy", {select({sequence({wait(1, 3),
                                       assign(name("n"), binary(Op::Add, name("n"), number(1)))}),
                             port("stop")}),
                     assign(field(index(name("cells"), name("left")), "mode"), name("Done")),
                     to("idle")})});
  worker.ports = {{.name = "stop"}};
  worker.parameters = {{"cells", named("cell_array"), true}, {"begin_at", nat(), false}};
  worker.variables = {{.name = "n", .type = range(0, 5), .init = number(0)}};

  auto stopper = process("stopper", {"run"}, {from("run", {port("stop"), to("run")})});
  stopper.ports = {{.name = "stop"}};

  const Expr cell{.kind = ExprKind::Record,
                  .fields = {"lit", "mode"},
                  .operands = {truth(true), name("Ready")}};
  Component main{.name = "main",
                 .variables = {{.name = "cells",
                                .type = named("cell_array"),
                                .init = Expr{.kind = ExprKind::Array, .operands = {cell, cell}}}},
                 .ports = {{.name = "stop", .interval = Interval{.lower = 0, .upper = 2}}},
                 .instances = {{.process = "worker",
                                .ports = {"stop"},
                                .arguments = {name("cells"), number(1)},
                                .references = {true, false}},
                               {.process = "stopper", .ports = {"stop"}}}};
  Observable begun{.kind = ObservableKind::Tag, .path = {1}, .name = "begun"};
  return {
      .constants = {{"left", nat(), number(0)}},
      .types = {{"cell_state", unionOf({"Ready", "Done"}), {}},
                {"cell", record({{"lit", boolean()}, {"mode", named("cell_state")}}), {}},
                {"cell_array", array(2, named("cell")), {}}},
      .processes = {worker, stopper},
      .components = {main},
      .main = "main",
      .properties = {{.name = "p", .pattern = {.kind = PatternKind::Absent, .operands = {begun}}}}};
}

/// The problems of the clean model with these statements as all that the worker does when it is
/// idle.
Found whenIdle(std::vector<Statement> statements) {
  auto program = clean();
  program.processes[0].transitions[0] =
      from("idle", {ifThen(truth(false), sequence({tag("begun"), to("busy")})),
                    sequence(std::move(statements))});
  return problems(program);
}

/// The same for an expression where a truth value is expected.
Found guard(Expr expr) { return whenIdle({on(std::move(expr)), to("busy")}); }

const std::string kIdle = "process worker, state idle: ";

/// The problems of the clean model with one change.
template <class Change> Found changed(Change change) {
  auto program = clean();
  change(program);
  return problems(program);
}

Found onProperty(PatternKind kind, std::vector<Observable> operands) {
  return changed(
      [&](Program& p) { p.properties[0].pattern = {.kind = kind, .operands = operands}; });
}

} // namespace

TEST_CASE("nothing is wrong with a clean model") {
  CHECK(problems(clean()) == Found{});
  CHECK(problems(tripleClick()) == Found{});
  CHECK(whenIdle({to("busy")}) == Found{});
}

TEST_CASE("words of Fiacre, of H-Fiacre and of patterns are reserved, others are not") {
  for (const auto* word : {"from", "select", "start", "task", "event", "leadsto", "value", "union"})
    CHECK(isReserved(word));
  for (const auto* word : {"from", "sync", "union"}) CHECK(isKeyword(word));
  for (const auto* word : {"leadsto", "start", "event", "write", "obs"})
    CHECK_FALSE(isKeyword(word));
  for (const auto* word : {"start_", "battery", "From", ""}) CHECK_FALSE(isReserved(word));
  CHECK(isIdentifier("sv_battery2"));
  for (const auto* word : {"", "2nd", "a-b", "a'", "é"}) CHECK_FALSE(isIdentifier(word));
}

TEST_CASE("names are declared once, are identifiers, and are not reserved") {
  CHECK(changed([](Program& p) {
          p.types.push_back({"side", unionOf({"left"}), {}});
        }) == Found{": the constructor `left` is declared twice, first as the constant"});
  CHECK(changed([](Program& p) {
          p.types.push_back({"cell", nat(), {}});
        }) == Found{": the type `cell` is declared twice, first as the type"});
  CHECK(changed([](Program& p) {
          p.types.push_back({"record", nat(), {}});
        }) == Found{": the type `record` is a reserved word"});
  CHECK(changed([](Program& p) {
          p.constants.push_back({"2nd", nat(), number(1)});
        }) == Found{": the constant `2nd` is no name"});
  CHECK(changed([](Program& p) { p.processes.push_back(p.processes[1]); }) ==
        Found{": the process `stopper` is declared twice, first as the process"});
  CHECK(changed([](Program& p) { p.processes[0].states.push_back({"idle"}); }) ==
        Found{"process worker: the state `idle` is declared twice, first as the state"});
  CHECK(changed([](Program& p) {
          p.constants.push_back({"right", nat(), number(1)});
          p.processes[0].variables.push_back({.name = "right"});
        }) == Found{"process worker: the variable `right` hides a constant or a constructor"});
  CHECK(changed([](Program& p) { p.processes[0].variables.push_back({.name = "begin_at"}); }) ==
        Found{"process worker: the variable `begin_at` is declared twice, first as the parameter"});
  CHECK(changed([](Program& p) { p.properties.push_back(p.properties[0]); }) ==
        Found{": the property `p` is declared twice, first as the property"});
  CHECK(whenIdle({tag("sync"), to("busy")}) == Found{kIdle + "the tag `sync` is a reserved word"});
}

TEST_CASE("types are declared, are not empty, and do not contain themselves") {
  const auto declared = [](Type type) {
    return changed([&](Program& p) { p.types.push_back({"t", type, {}}); });
  };
  CHECK(declared(named("nowhere")) == Found{"type t: the type `nowhere` is not declared"});
  CHECK(declared(range(3, 2)) == Found{"type t: the range 3..2 is empty"});
  CHECK(declared(array(0, nat())) == Found{"type t: an array or a queue has room for nothing"});
  CHECK(declared(unionOf({})) == Found{"type t: a record or a union has no members"});
  CHECK(declared(record({{"a", nat()}, {"a", nat()}})) ==
        Found{"type t: the field `a` is declared twice, first as the field"});
  CHECK(declared(queue(2, record({{"next", named("t")}}))) ==
        Found{"type t: the type contains itself"});
}

TEST_CASE("constructors are unique in the program") {
  CHECK(changed([](Program& p) {
          p.types.push_back({"other", unionOf({"Done", "Else"}), {}});
        }) == Found{": the constructor `Done` is declared twice, first as the constructor"});
}

TEST_CASE("every name in an expression is declared") {
  CHECK(guard(name("nowhere")) == Found{kIdle + "`nowhere` is not declared"});
  CHECK(guard(call("nowhere", {})) ==
        Found{kIdle + "`nowhere` is neither a function nor a constructor"});
  CHECK(guard(field(index(name("cells"), number(0)), "off")) ==
        Found{kIdle + "`cells[0]` has no field `off`"});
  CHECK(guard(index(name("n"), number(0))) == Found{kIdle + "`n` is no array"});
}

TEST_CASE("every expression has the type that its place wants") {
  CHECK(guard(number(1)) == Found{kIdle + "`1` is of the type int, not bool"});
  CHECK(guard(unary(Op::Not, name("n"))) == Found{kIdle + "`n` is of the type 0..5, not bool"});
  CHECK(guard(binary(Op::Less, name("Ready"), number(1))) ==
        Found{kIdle + "`Ready` is of the type cell_state, not a number"});
  CHECK(guard(binary(Op::Equal, field(index(name("cells"), number(1)), "mode"), truth(true))) ==
        Found{kIdle + "`true` is of the type bool, not cell_state"});
  CHECK(guard(binary(Op::Equal, name("n"), number(7))) == Found{});
  CHECK(guard(unary(Op::Empty, name("n"))) ==
        Found{kIdle + "`n` is of the type 0..5, not a queue"});
  CHECK(whenIdle({assign(name("n"), truth(true)), to("busy")}) ==
        Found{kIdle + "`true` is of the type bool, not 0..5"});
  CHECK(whenIdle({ifElse(name("n"), to("busy"), to("idle"))}) ==
        Found{kIdle + "`n` is of the type 0..5, not bool"});
  CHECK(guard({.kind = ExprKind::Conditional, .operands = {truth(true), truth(true), number(1)}}) ==
        Found{kIdle + "`1` is of the type int, not bool"});
}

TEST_CASE("records and arrays have all their parts, once") {
  const auto cell = index(name("cells"), number(0));
  const auto become = [&](std::vector<std::string> fields, std::vector<Expr> values) {
    return whenIdle({assign(cell, {.kind = ExprKind::Record, .fields = fields, .operands = values}),
                     to("busy")});
  };
  CHECK(become({"mode", "lit"}, {name("Done"), truth(false)}) == Found{});
  CHECK(become({"lit"}, {truth(false)}) ==
        Found{kIdle + "`{lit=false}` gives the field `mode` not once"});
  CHECK(become({"lit", "mode", "x"}, {truth(false), name("Done"), number(1)}) ==
        Found{kIdle + "cell has no field `x`"});
  CHECK(changed([](Program& p) { p.components[0].variables[0].init->operands.pop_back(); }) ==
        Found{"component main: 1 elements where array 2 of cell is expected: "
              "`[{lit=true, mode=Ready}]`"});
}

TEST_CASE("a constant fits into the range that it goes to") {
  CHECK(whenIdle({assign(name("n"), number(6)), to("busy")}) ==
        Found{kIdle + "6 is outside of 0..5: `6`"});
  CHECK(whenIdle({assign(name("n"), binary(Op::Add, number(2), number(4))), to("busy")}) ==
        Found{kIdle + "6 is outside of 0..5: `2 + 4`"});
  CHECK(whenIdle({assign(name("n"), binary(Op::Add, name("n"), number(4))), to("busy")}) ==
        Found{});
  CHECK(guard(field(index(name("cells"), number(2)), "lit")) ==
        Found{kIdle + "2 is outside of 0..1: `2`"});
  CHECK(guard(binary(Op::Less, binary(Op::Divide, name("n"), number(0)), number(1))) ==
        Found{kIdle + "`n / 0` divides by 0"});
  CHECK(changed([](Program& p) { p.constants[0].value = number(-1); }) ==
        Found{"const left: -1 is outside of nat: `-1`",
              "process worker, state idle: -1 is outside of 0..1: `left`",
              "process worker, state busy: -1 is outside of 0..1: `left`"});
}

TEST_CASE("queues hold what they are for") {
  auto program = clean();
  program.processes[0].variables.push_back(
      {.name = "q", .type = queue(2, nat()), .init = Expr{.kind = ExprKind::Queue}});
  const auto idle = [&](Expr expr) {
    program.processes[0].transitions[0] =
        from("idle", {tag("begun"), assign(name("q"), std::move(expr)), to("busy")});
    return problems(program);
  };
  CHECK(idle(binary(Op::Enqueue, name("q"), name("n"))) == Found{});
  CHECK(idle(unary(Op::Dequeue, name("q"))) == Found{});
  CHECK(idle(binary(Op::Append, name("q"), truth(true))) ==
        Found{kIdle + "`true` is of the type bool, not nat"});
  CHECK(idle(unary(Op::First, name("q"))) ==
        Found{kIdle + "`first q` is of the type nat, not queue 2 of nat"});
  CHECK(idle({.kind = ExprKind::Queue, .operands = {number(1), number(2), number(3)}}) ==
        Found{kIdle + "3 elements where queue 2 of nat is expected: `{|1, 2, 3|}`"});
}

TEST_CASE("functions and constructors get what they take") {
  auto program = clean();
  program.types.push_back(
      {"box", {.kind = TypeKind::Union, .members = {{"Full", {nat()}, {}}}}, {}});
  program.functions.push_back({.name = "even",
                               .parameters = {{"k", nat()}},
                               .result = boolean(),
                               .body = {.kind = StatementKind::Return, .values = {truth(true)}}});
  program.externs.push_back({"stop_it", {}, boolean(), "c_stop"});
  const auto idle = [&](Expr expr) {
    program.processes[0].transitions[0] =
        from("idle", {tag("begun"), on(std::move(expr)), to("busy")});
    return problems(program);
  };
  CHECK(idle(call("even", {name("n")})) == Found{});
  CHECK(idle(call("stop_it", {})) == Found{});
  CHECK(idle(binary(Op::Equal, call("Full", {number(1)}), call("Full", {number(2)}))) == Found{});
  CHECK(idle(call("even", {})) == Found{kIdle + "`even` takes 1 values, not 0"});
  CHECK(idle(call("even", {truth(true)})) == Found{kIdle + "`true` is of the type bool, not nat"});
  CHECK(idle(binary(Op::Equal, call("Full", {number(1)}), name("Full"))) ==
        Found{kIdle + "the constructor `Full` needs a value"});
}

TEST_CASE("only variables and references are assigned to") {
  CHECK(whenIdle({assign(name("begin_at"), number(1)), to("busy")}) ==
        Found{kIdle + "`begin_at` is a parameter by value, and cannot be assigned to"});
  CHECK(whenIdle({assign(name("left"), number(1)), to("busy")}) ==
        Found{kIdle + "`left` is no variable, and cannot be assigned to"});
  CHECK(whenIdle({{.kind = StatementKind::Assign, .targets = {name("n")}, .values = {}},
                  to("busy")}) == Found{kIdle + "1 variables get 0 values"});
  CHECK(whenIdle({{.kind = StatementKind::Any, .targets = {name("n")}}, to("busy")}) == Found{});
}

TEST_CASE("states are declared, and each has one from") {
  CHECK(whenIdle({to("nowhere")}) == Found{kIdle + "the state `nowhere` is not declared"});
  CHECK(changed([](Program& p) { p.processes[1].transitions[0].state = "nowhere"; }) ==
        Found{"process stopper: the state `nowhere` is not declared"});
  CHECK(changed([](Program& p) {
          p.processes[1].transitions.push_back(p.processes[1].transitions[0]);
        }) ==
        Found{"process stopper: the state `run` has two `from`: make one of them, with `select`"});
  CHECK(changed([](Program& p) { p.processes.push_back(process("nothing", {}, {})); }) ==
        Found{"process nothing: there is no state"});
}

TEST_CASE("a path waits once, communicates once, and never does both") {
  CHECK(whenIdle({wait(0, 0), wait(1, 1), to("busy")}) == Found{kIdle + "a path waits twice"});
  CHECK(whenIdle({port("stop"), port("stop"), to("busy")}) ==
        Found{kIdle + "a path communicates twice"});
  CHECK(whenIdle({wait(0, 0), port("stop"), to("busy")}) ==
        Found{kIdle + "a path waits and communicates"});
  CHECK(whenIdle({port("stop"), wait(0, 0), to("busy")}) ==
        Found{kIdle + "a path waits and communicates"});
  CHECK(whenIdle({select({wait(0, 0), port("stop")}), to("busy")}) == Found{});
  CHECK(whenIdle({ifThen(truth(true), wait(1, 1)), wait(2, 2), to("busy")}) ==
        Found{kIdle + "a path waits twice"});
}

TEST_CASE("a path ends in one to or loop, and nothing stands behind it") {
  CHECK(whenIdle({wait(0, 0)}) == Found{kIdle + "a path ends in no `to` and no `loop`"});
  CHECK(whenIdle({ifThen(truth(true), to("busy"))}) ==
        Found{kIdle + "a path ends in no `to` and no `loop`"});
  CHECK(whenIdle({to("busy"), tag("never")}) ==
        Found{kIdle + "nothing reaches what stands behind `to` or `loop`"});
  CHECK(whenIdle({ifElse(truth(true), to("busy"), to("idle")), to("busy")}) ==
        Found{kIdle + "nothing reaches what stands behind `to` or `loop`"});
  CHECK(whenIdle({{.kind = StatementKind::Loop}, comment("still here"), null()}) == Found{});
  CHECK(whenIdle({ifThen(truth(true), to("busy")), to("idle")}) == Found{});
}

TEST_CASE("selects with unless are silent") {
  auto choice = select({sequence({port("stop"), to("busy")}), to("idle")});
  choice.priorityGroups = {1};
  CHECK(whenIdle({choice}) == Found{kIdle + "a select with `unless` communicates"});
}

TEST_CASE("loops only compute") {
  const Statement loop{.kind = StatementKind::While,
                       .values = {truth(true)},
                       .children = {sequence({wait(0, 0), to("busy")})}};
  CHECK(whenIdle({loop, to("busy")}) ==
        Found{kIdle + "a loop does more than compute", kIdle + "a loop does more than compute"});
  const Statement each{.kind = StatementKind::Foreach, .name = "n", .children = {null()}};
  CHECK(whenIdle({each, to("busy")}) == Found{});
}

TEST_CASE("patterns of a case fit, and none is there twice") {
  const auto cases = [](std::vector<Expr> patterns) {
    Statement choice{.kind = StatementKind::Case,
                     .values = {field(index(name("cells"), number(0)), "mode")}};
    for (auto& pattern : patterns) {
      choice.values.push_back(pattern);
      choice.children.push_back(to("busy"));
    }
    return whenIdle({choice});
  };
  CHECK(cases({name("Ready"), name("any")}) == Found{});
  CHECK(cases({name("Ready"), name("Ready")}) ==
        Found{kIdle + "the pattern `Ready` is there twice"});
  CHECK(cases({number(1)}) == Found{kIdle + "`1` is of the type int, not cell_state"});
  CHECK(cases({name("any"), name("Done")}) ==
        Found{kIdle + "nothing is left behind the pattern `any`"});
}

TEST_CASE("intervals are not empty") {
  CHECK(whenIdle({wait(3, 2), to("busy")}) == Found{kIdle + "an interval is empty"});
  CHECK(whenIdle({wait(-1, 2), to("busy")}) == Found{kIdle + "a time is negative"});
  CHECK(whenIdle(
            {{.kind = StatementKind::Wait, .interval = {.lower = 2, .upper = 2, .lowerOpen = true}},
             to("busy")}) == Found{kIdle + "an interval is empty"});
  CHECK(changed([](Program& p) {
          p.components[0].ports[0].interval = Interval{.lower = 4, .upper = 1};
        }) == Found{"component main: an interval is empty"});
}

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
        }) == Found{"component main: `cells` of worker is passed by reference, not by value"});
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
        }) == Found{"model: its name is missing: that of a component stands at the end"});
  CHECK(changed([](Program& p) {
          p.main = "nobody";
          p.properties = {};
        }) == Found{"model: there is no main component `nobody`"});
  CHECK(changed([](Program& p) {
          p.main = "worker";
          p.properties = {};
        }) == Found{"model: the main component `worker` wants ports or arguments"});
  CHECK(changed([](Program& p) { p.components[0].instances.push_back({.process = "main"}); }) ==
        Found{"component main: the component contains itself"});
  CHECK(changed([](Program& p) {
          p.components[0].priorities = {{{"stop"}, {"go"}}};
        }) == Found{"component main: the port `go` is not declared"});
  CHECK(changed([](Program& p) { p.components.push_back({.name = "idle_one"}); }) ==
        Found{"component idle_one: there is no instance"});
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
        component + "`state s` is of no process\n");
  CHECK(problem("sync is main/1/1/state u", "watch > main") ==
        component + "process P has no state `u`\n");
  CHECK(problem("sync is main/1/2/state s", "watch > main") ==
        component + "the path main/1/2 leads nowhere\n");
  CHECK(problem("sync in [1,1] is main/2/tag gone", "watch > main") ==
        component + "the probe of `p` is of steps: it is passed with them, and has no time of its "
                    "own\n");
  CHECK(problem("sync in [0,0] is watch/1/state u", "watch > main") ==
        component + "the probe of `p` looks at an observer: it can look at the model alone\n");
  CHECK(problem("sync", "watch > watch") ==
        "observer watch: `watch` is observed, and the model is `main`\n");
  CHECK(problem("sync", "watch > main watch > main") ==
        "observer watch: `watch` is there already\n");
  CHECK(problem("sync", "W > main") == "observer W: the component `W` wants ports or arguments\n");
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

TEST_CASE("functions only compute, and always return what they say") {
  const auto function = [](Statement body) {
    return changed([&](Program& p) {
      p.functions.push_back({.name = "f",
                             .parameters = {{"k", nat()}},
                             .result = boolean(),
                             .body = std::move(body)});
    });
  };
  const auto give = [](Expr value) {
    return Statement{.kind = StatementKind::Return, .values = {std::move(value)}};
  };
  CHECK(function(give(truth(true))) == Found{});
  CHECK(function(give(name("k"))) == Found{"function f: `k` is of the type nat, not bool"});
  CHECK(function(ifThen(truth(true), give(truth(true)))) ==
        Found{"function f: a path returns nothing"});
  CHECK(function(sequence({wait(0, 0), give(truth(true))})) ==
        Found{"function f: a function does more than compute"});
  CHECK(whenIdle({give(truth(true))}) == Found{kIdle + "`return` stands outside of a function"});
}

TEST_CASE("a problem knows where it comes from") {
  auto program = clean();
  auto bad = assign(name("n"), number(9));
  bad.origin = 12;
  program.processes[0].transitions[0] = from("idle", {tag("begun"), bad, to("busy")});
  const auto found = check(program);
  REQUIRE(found.size() == 1);
  CHECK(found[0].origin == 12);
}
