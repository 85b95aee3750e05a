#include "verify/model/conjuncts.h"

namespace proskill::verify {

std::vector<NodeId> conjunctsOf(const System& system, NodeId node) {
  const Node& of = system.nodes[node];
  if (of.op == NodeOp::Number && of.number != 0) return {};
  if (of.op != NodeOp::And) return {node};
  auto all = conjunctsOf(system, of.a);
  auto more = conjunctsOf(system, of.b);
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

} // namespace proskill::verify
