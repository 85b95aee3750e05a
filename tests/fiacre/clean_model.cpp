#include "tests/fiacre/clean_model.h"

#include "fiacre/check/check.h"

namespace proskill::fiacre::test {

Found problems(const Program& program) {
  Found found;
  for (const auto& problem : check(program))
    found.push_back(problem.place + ": " + problem.message);
  return found;
}

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

Found whenIdle(std::vector<Statement> statements) {
  auto program = clean();
  program.processes[0].transitions[0] =
      from("idle", {ifThen(truth(false), sequence({tag("begun"), to("busy")})),
                    sequence(std::move(statements))});
  return problems(program);
}

Found onProperty(PatternKind kind, std::vector<Observable> operands) {
  return changed(
      [&](Program& p) { p.properties[0].pattern = {.kind = kind, .operands = operands}; });
}

} // namespace proskill::fiacre::test
