#include "tests/fiacre/clean_model.h"

#include "fiacre/check/check.h"
#include "fiacre/syntax/parse.h"
#include "fiacre/syntax/words.h"

#include <catch2/catch.hpp>

using namespace proskill::fiacre;
using namespace proskill::fiacre::test;

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
        }) == Found{": the constant `2nd` is not a name"});
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
  CHECK(declared(array(0, nat())) ==
        Found{"type t: an array or a queue must have a size of at least 1"});
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
  CHECK(guard(index(name("n"), number(0))) == Found{kIdle + "`n` is not an array"});
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
        Found{kIdle + "`{lit=false}` must give the field `mode` exactly once"});
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
        Found{kIdle + "`left` is not a variable and cannot be assigned to"});
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
        }) == Found{"process stopper: the state `run` has two `from`: join them with `select`"});
  CHECK(changed([](Program& p) { p.processes.push_back(process("nothing", {}, {})); }) ==
        Found{"process nothing: a process needs a state"});
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
  CHECK(whenIdle({wait(0, 0)}) == Found{kIdle + "a path must end with `to` or `loop`"});
  CHECK(whenIdle({ifThen(truth(true), to("busy"))}) ==
        Found{kIdle + "a path must end with `to` or `loop`"});
  CHECK(whenIdle({to("busy"), tag("never")}) ==
        Found{kIdle + "unreachable statement after `to` or `loop`"});
  CHECK(whenIdle({ifElse(truth(true), to("busy"), to("idle")), to("busy")}) ==
        Found{kIdle + "unreachable statement after `to` or `loop`"});
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
        Found{kIdle + "a loop may only compute", kIdle + "a loop may only compute"});
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
  CHECK(cases({name("Ready"), name("Ready")}) == Found{kIdle + "duplicate pattern `Ready`"});
  CHECK(cases({number(1)}) == Found{kIdle + "`1` is of the type int, not cell_state"});
  CHECK(cases({name("any"), name("Done")}) ==
        Found{kIdle + "no value is left after the pattern `any`"});
}

TEST_CASE("intervals are not empty") {
  CHECK(whenIdle({wait(3, 2), to("busy")}) == Found{kIdle + "empty interval"});
  CHECK(whenIdle({wait(-1, 2), to("busy")}) == Found{kIdle + "a time must not be negative"});
  CHECK(whenIdle(
            {{.kind = StatementKind::Wait, .interval = {.lower = 2, .upper = 2, .lowerOpen = true}},
             to("busy")}) == Found{kIdle + "empty interval"});
  CHECK(changed([](Program& p) {
          p.components[0].ports[0].interval = Interval{.lower = 4, .upper = 1};
        }) == Found{"component main: empty interval"});
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
        Found{"function f: a path ends without `return`"});
  CHECK(function(sequence({wait(0, 0), give(truth(true))})) ==
        Found{"function f: a function may only compute"});
  CHECK(whenIdle({give(truth(true))}) == Found{kIdle + "`return` is only allowed in a function"});
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
