#include "verify/model/conjuncts.h"

namespace proskill::verify {

namespace {

void addConjuncts(const System& system, NodeId node, std::vector<NodeId>& all) {
  const Node& of = system.nodes[node];
  if (of.op == NodeOp::Number && of.number != 0) return;
  if (of.op != NodeOp::And) {
    all.push_back(node);
    return;
  }
  addConjuncts(system, of.a, all);
  addConjuncts(system, of.b, all);
}

} // namespace

std::vector<NodeId> conjunctsOf(const System& system, NodeId node) {
  std::vector<NodeId> all;
  addConjuncts(system, node, all);
  return all;
}

} // namespace proskill::verify
