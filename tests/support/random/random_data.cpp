#include "tests/support/random/random_data.h"

#include "tests/fiacre/build.h"

namespace proskill::test {

using namespace fiacre;
using namespace fiacre::test;

namespace {

Type letterType() {
  Type type = unionOf({"nothing", "some", "other"});
  type.members[1].type = {range(0, 2)};
  type.members[2].type = {boolean()};
  return type;
}

} // namespace

Expr negation(Expr operand) { return unary(Op::Not, std::move(operand)); }

void addRandomData(Program& program, Component& component) {
  program.types.push_back({"letter_type", letterType(), {}});
  program.types.push_back({"line_type", queue(2, range(0, 2)), {}});
  program.types.push_back({"cells_type", array(3, range(0, 2)), {}});
  program.types.push_back({"box_type", queue(2, named("letter_type")), {}});
  component.variables.push_back({"letter", named("letter_type"), name("nothing"), {}});
  component.variables.push_back({"line", named("line_type"), Expr{.kind = ExprKind::Queue}, {}});
  component.variables.push_back(
      {"cells",
       named("cells_type"),
       Expr{.kind = ExprKind::Array, .operands = {number(0), number(1), number(2)}},
       {}});
}

Expr randomDataTest(RandomSource& random) {
  const Expr line = name("line");
  switch (random.below(5)) {
  case 0: return unary(Op::Empty, line);
  case 1: return unary(Op::Full, line);
  case 2:
    return binary(Op::And, negation(unary(Op::Empty, line)),
                  binary(Op::Equal, unary(Op::First, line), name("level")));
  case 3: return binary(Op::Equal, name("letter"), call("some", {number(random.between(0, 2))}));
  default:
    return binary(Op::Equal, index(name("cells"), name("level")), number(random.between(0, 2)));
  }
}

Statement randomDataChange(RandomSource& random) {
  const Expr line = name("line");
  const Expr level = name("level");
  switch (random.below(7)) {
  case 5:
    return {.kind = StatementKind::Assign,
            .targets = {index(name("cells"), level), index(name("cells"), number(1))},
            .values = {index(name("cells"), number(1)), index(name("cells"), level)}};
  case 0:
    return ifThen(negation(unary(Op::Full, line)),
                  assign(line, binary(random.chance(50) ? Op::Enqueue : Op::Append, line, level)));
  case 1:
    return ifThen(negation(unary(Op::Empty, line)),
                  Statement{.kind = StatementKind::Assign,
                            .targets = {level, line},
                            .values = {unary(Op::First, line), unary(Op::Dequeue, line)}});
  case 2:
    return {.kind = StatementKind::Case,
            .values = {name("letter"), name("nothing"), call("some", {level}),
                       call("other", {truth(true)}), name("any")},
            .children = {assign(name("letter"), call("some", {level})),
                         assign(name("letter"), call("other", {name("flag")})),
                         assign(name("flag"), truth(false)),
                         assign(name("letter"), name("nothing"))}};
  case 3: return assign(index(name("cells"), level), index(name("cells"), number(0)));
  case 4:
    return {.kind = StatementKind::While,
            .values = {binary(Op::Less, level, number(2))},
            .children = {sequence({assign(index(name("cells"), level), number(0)),
                                   assign(level, binary(Op::Add, level, number(1)))})}};
  default:
    return {.kind = StatementKind::Any,
            .targets = {level},
            .values = {binary(Op::LessEqual, level, number(1))}};
  }
}

} // namespace proskill::test
