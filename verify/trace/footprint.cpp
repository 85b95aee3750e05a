#include "verify/trace/footprint.h"

#include "verify/model/nodes.h"
#include "verify/model/value_bounds.h"

#include <algorithm>
#include <utility>

namespace proskill::verify {

namespace {

void joinCells(std::vector<CellId>& to, std::vector<CellId> from) {
  if (from.size() > to.size()) std::swap(to, from);
  to.insert(to.end(), from.begin(), from.end());
}

} // namespace

void Needs::add(Needs other) {
  joinCells(before, std::move(other.before));
  joinCells(after, std::move(other.after));
  event = event || other.event;
}

Footprints::Footprints(const System& of, const std::vector<std::size_t>& by)
    : system(of), writers(by), faults(of.nodes.size()) {}

bool Footprints::mayFault(NodeId node) const {
  auto& known = faults[node];
  if (known == Fault::Unknown) known = mayFail(system, node) ? Fault::Possible : Fault::Never;
  return known == Fault::Possible;
}

Needs Footprints::of(NodeId node, const Moment& moment) const { return walk(node, moment).needs; }

Needs Footprints::ofAssigned(NodeId id, const Word* state, CellId target) const {
  const Node& node = system.nodes[id];
  if (node.op == NodeOp::Cell && node.a == target) return {};
  if (node.op != NodeOp::Conditional) return of(id, state);
  auto chosen = walk(node.a, {state, nullptr, nullptr});
  chosen.needs.add(ofAssigned(chosen.value != 0 ? node.b : node.c, state, target));
  return std::move(chosen.needs);
}

Footprints::Found Footprints::walk(NodeId id, const Moment& moment) const {
  const Node& node = system.nodes[id];
  switch (node.op) {
  case NodeOp::Number: return {node.number, {}};
  case NodeOp::Cell: return {readCell(system, node.a, moment.before), {{node.a}, {}, false}};
  case NodeOp::Test:
    return {(moment.before[node.a] & node.mask) == node.value, {{node.b}, {}, false}};
  case NodeOp::Not: {
    auto found = walk(node.a, moment);
    found.value = found.value == 0;
    return found;
  }
  case NodeOp::And: return either(node, moment, false);
  case NodeOp::Or: return either(node, moment, true);
  case NodeOp::Conditional:
  case NodeOp::Require: {
    auto condition = walk(node.a, moment);
    if (node.op == NodeOp::Require && condition.value == 0) return condition;
    auto chosen = walk(condition.value != 0 ? node.b : node.c, moment);
    chosen.needs.add(std::move(condition.needs));
    return chosen;
  }
  case NodeOp::Happens: {
    const bool happens = moment.events && moment.events->contains(node.a);
    return {happens, {{}, {}, happens}};
  }
  case NodeOp::Entered:
  case NodeOp::Left: {
    if (!moment.after) return {};
    return {holdsAt(system, id, moment), {readsOf(system, node.a), readsOf(system, node.a), false}};
  }
  case NodeOp::Negate:
  case NodeOp::Equal:
  case NodeOp::Less:
  case NodeOp::LessEqual:
  case NodeOp::Add:
  case NodeOp::Subtract:
  case NodeOp::Multiply:
  case NodeOp::Divide:
  case NodeOp::Modulo:
  case NodeOp::Received:
  case NodeOp::Fails: return strict(id, moment);
  }
  std::unreachable();
}

Footprints::Found Footprints::either(const Node& node, const Moment& moment, bool decisive) const {
  auto first = walk(node.a, moment);
  const bool decided = (first.value != 0) == decisive;
  if (decided && (mayFault(node.a) || mayFault(node.b) || cost(first.needs) == 0)) return first;
  auto second = walk(node.b, moment);
  const bool decides = (second.value != 0) == decisive;
  if (decided) return decides && cost(second.needs) < cost(first.needs) ? second : first;
  if (!decides || mayFault(node.a)) second.needs.add(std::move(first.needs));
  return second;
}

/// Everything that it reads: both operands, and what determines whether it fails.
Footprints::Found Footprints::strict(NodeId id, const Moment& moment) const {
  FaultId fault = kNoFault;
  return {evaluate(system, id, moment.before, fault), {readsOf(system, id), {}, false}};
}

std::size_t Footprints::cost(const Needs& needs) const {
  const auto changed = [&](CellId cell) { return writers[cell] != 0; };
  return static_cast<std::size_t>(std::ranges::count_if(needs.before, changed) +
                                  std::ranges::count_if(needs.after, changed)) +
         (needs.event ? 1 : 0);
}

} // namespace proskill::verify
