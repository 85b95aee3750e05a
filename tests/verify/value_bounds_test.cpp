#include "verify/model/nodes.h"
#include "verify/model/value_bounds.h"

#include <catch2/catch.hpp>

namespace proskill::test::value_bounds_test {

namespace {

using namespace verify;

/// Two variables from 0 to 9.
struct Expressions {
  Expressions() {
    for (int i = 0; i < 2; ++i) {
      Cell cell;
      cell.low = 0;
      cell.high = 9;
      system.cells.push_back(cell);
    }
  }

  [[nodiscard]] std::pair<std::int64_t, std::int64_t> bounds(NodeId node) const {
    const auto found = valueBounds(system, node);
    return {found.low, found.high};
  }

  System system;
  Nodes nodes{system};
  NodeId x = nodes.cell(0);
  NodeId y = nodes.cell(1);
  NodeId next = nodes.binary(NodeOp::Add, x, nodes.number(1));
};

using Pair = std::pair<std::int64_t, std::int64_t>;

} // namespace

TEST_CASE("each side of a conditional is bounded under its condition") {
  Expressions of;
  auto& nodes = of.nodes;
  const auto less = [&](NodeId a, NodeId b) { return nodes.binary(NodeOp::Less, a, b); };
  const auto either = [&](NodeId condition) {
    return of.bounds(nodes.conditional(condition, of.next, nodes.number(4)));
  };
  CHECK(of.bounds(of.next) == Pair{1, 10});
  CHECK(either(less(of.x, nodes.number(9))) == Pair{1, 9});
  CHECK(either(nodes.negation(less(nodes.number(6), of.x))) == Pair{1, 7});
  CHECK(either(nodes.binary(NodeOp::LessEqual, nodes.number(5), of.x)) == Pair{4, 10});
  CHECK(either(nodes.equal(of.x, nodes.number(6))) == Pair{4, 7});
  CHECK(either(nodes.negation(nodes.equal(of.x, nodes.number(9)))) == Pair{1, 9});
  CHECK(either(nodes.both(less(nodes.number(3), of.x), less(of.x, of.y))) == Pair{4, 9});
  CHECK(either(less(of.y, nodes.number(3))) == Pair{1, 10});
}

TEST_CASE("nothing is concluded from a condition of which only one part is true") {
  Expressions of;
  auto& nodes = of.nodes;
  const auto small = nodes.binary(NodeOp::Less, of.x, nodes.number(3));
  const auto any = nodes.binary(NodeOp::Or, small, nodes.equal(of.y, nodes.number(1)));
  CHECK(of.bounds(nodes.conditional(any, of.next, nodes.number(4))) == Pair{1, 10});
  CHECK(of.bounds(nodes.conditional(any, nodes.number(4), of.next)) == Pair{4, 10});
}

TEST_CASE("a side that is never taken does not count") {
  Expressions of;
  auto& nodes = of.nodes;
  const auto never = nodes.binary(NodeOp::Less, nodes.number(9), of.x);
  CHECK(of.bounds(nodes.conditional(never, nodes.number(50), of.x)) == Pair{0, 9});
  CHECK(of.bounds(nodes.conditional(nodes.negation(never), of.x, nodes.number(50))) == Pair{0, 9});
}

} // namespace proskill::test::value_bounds_test
