#include "verify/state/partial_evaluation.h"

#include "verify/model/value_bounds.h"
#include "verify/state/evaluate.h"

#include <optional>

namespace proskill::verify {

namespace {

using KnownValue = std::optional<std::int64_t>;

/// Evaluates nodes that do not depend on unknown bits.
class Reading {
public:
  Reading(const System& of, const PartialState& where, BitField& open)
      : system(of), at(where), undecided(open) {}

  KnownValue value(NodeId id) {
    const Node& node = system.nodes[id];
    switch (node.op) {
    case NodeOp::Number: return node.number;
    case NodeOp::Cell: return cell(system.cells[node.a], node.a);
    case NodeOp::Test: return test(node.a, node.mask, node.value);
    case NodeOp::Not: return map(value(node.a), [](auto a) { return a == 0; });
    case NodeOp::Negate: return map(value(node.a), [](auto a) { return -a; });
    case NodeOp::And: return connective(node, false);
    case NodeOp::Or: return connective(node, true);
    case NodeOp::Conditional: return conditional(node);
    case NodeOp::Equal:
    case NodeOp::Less:
    case NodeOp::LessEqual:
    case NodeOp::Add:
    case NodeOp::Subtract:
    case NodeOp::Multiply:
    case NodeOp::Divide:
    case NodeOp::Modulo: return whole(id, {node.a, node.b});
    case NodeOp::Happens:
    case NodeOp::Entered:
    case NodeOp::Left:
    case NodeOp::Received: return 0; // does not occur in guards
    case NodeOp::Require: return whole(id, {node.a, node.b});
    case NodeOp::Fails: return whole(id, {node.a});
    }
    return std::nullopt;
  }

  KnownValue test(std::uint32_t word, Word mask, Word wanted) {
    const Word known = mask & ~at.unknown[word];
    if ((at.state[word] & known) != (wanted & known)) return 0;
    if (known == mask) return 1;
    undecided = {word, mask & at.unknown[word]};
    return std::nullopt;
  }

  /// The value of a node whose parts are all known. They are evaluated together, since a part may
  /// fail.
  KnownValue whole(NodeId id, std::initializer_list<NodeId> parts) {
    for (auto part : parts)
      if (!isKnown(part)) return std::nullopt;
    FaultId fault = kNoFault;
    const std::int64_t result = evaluate(system, id, at.state, fault);
    return fault == kNoFault ? result : 0;
  }

  /// The value of a guard; false if it fails.
  KnownValue asGuard(NodeId id) {
    return isKnown(id) ? KnownValue(holds(system, id, at.state)) : std::nullopt;
  }

  /// Whether the node reads no unknown cell.
  bool isKnown(NodeId id) {
    const Node& node = system.nodes[id];
    switch (node.op) {
    case NodeOp::Cell: return isKnown(system.cells[node.a].word, system.cells[node.a].mask);
    case NodeOp::Test: return isKnown(node.a, node.mask);
    case NodeOp::Number:
    case NodeOp::Received:
    case NodeOp::Happens: return true;
    case NodeOp::Not:
    case NodeOp::Negate:
    case NodeOp::Fails:
    case NodeOp::Entered:
    case NodeOp::Left: return isKnown(node.a);
    case NodeOp::Conditional: return isKnown(node.a) && isKnown(node.b) && isKnown(node.c);
    case NodeOp::And:
    case NodeOp::Or:
    case NodeOp::Equal:
    case NodeOp::Less:
    case NodeOp::LessEqual:
    case NodeOp::Add:
    case NodeOp::Subtract:
    case NodeOp::Multiply:
    case NodeOp::Divide:
    case NodeOp::Modulo:
    case NodeOp::Require: return isKnown(node.a) && isKnown(node.b);
    }
    return false;
  }

private:
  template <class Function> static KnownValue map(KnownValue value, Function function) {
    return value ? KnownValue(function(*value)) : std::nullopt;
  }

  bool isKnown(std::uint32_t word, Word mask) {
    if ((mask & at.unknown[word]) == 0) return true;
    undecided = {word, mask & at.unknown[word]};
    return false;
  }

  KnownValue cell(const Cell& place, CellId id) {
    if (!isKnown(place.word, place.mask)) return std::nullopt;
    return readCell(system, id, at.state);
  }

  /// `deciding` is the value of one part that determines the result.
  KnownValue connective(const Node& node, bool deciding) {
    const KnownValue a = value(node.a);
    if (a && (*a != 0) == deciding) return deciding;
    const KnownValue b = value(node.b);
    if (b && (*b != 0) == deciding) return deciding;
    return a && b ? KnownValue(!deciding) : std::nullopt;
  }

  KnownValue conditional(const Node& node) {
    if (const KnownValue a = value(node.a)) return value(*a != 0 ? node.b : node.c);
    return std::nullopt;
  }

  const System& system;
  const PartialState& at;
  BitField& undecided;
};

/// Whether a failure within the node may determine its value.
bool isOpaque(const System& system, NodeId id) {
  const Node& node = system.nodes[id];
  const auto any = [&](auto... parts) { return (isOpaque(system, parts) || ...); };
  switch (node.op) {
  case NodeOp::Number:
  case NodeOp::Cell:
  case NodeOp::Test:
  case NodeOp::Received:
  case NodeOp::Happens: return false;
  case NodeOp::Not:
  case NodeOp::Negate:
  case NodeOp::Entered:
  case NodeOp::Left: return any(node.a);
  case NodeOp::Conditional: return any(node.a, node.b, node.c);
  case NodeOp::And:
  case NodeOp::Or: return any(node.a, node.b);
  case NodeOp::Equal:
  case NodeOp::Less:
  case NodeOp::LessEqual:
  case NodeOp::Add:
  case NodeOp::Subtract:
  case NodeOp::Multiply:
  case NodeOp::Divide:
  case NodeOp::Modulo: return mayFail(system, id);
  case NodeOp::Require: return true;
  case NodeOp::Fails: return false; // evaluated as a whole, and never fails itself
  }
  return true;
}

} // namespace

PartialEvaluation::PartialEvaluation(const System& system) : opaque(system.nodes.size()) {
  for (const auto& transition : system.transitions)
    for (auto node : transition.rest) opaque[node] = isOpaque(system, node);
}

PartialTruth PartialEvaluation::tests(const System& system, const Transition& transition,
                                      const PartialState& at, BitField& undecided) const {
  Reading reading(system, at, undecided);
  auto result = PartialTruth::True;
  for (const auto& test : transition.tests) {
    const auto met = reading.test(test.word, test.mask, test.value);
    if (met && (*met != 0) != test.equal) return PartialTruth::False;
    if (!met) result = PartialTruth::Unknown;
  }
  return result;
}

PartialTruth PartialEvaluation::condition(const System& system, NodeId node, const PartialState& at,
                                          BitField& undecided) const {
  Reading reading(system, at, undecided);
  const auto met = opaque[node] ? reading.asGuard(node) : reading.value(node);
  if (!met) return PartialTruth::Unknown;
  return *met != 0 ? PartialTruth::True : PartialTruth::False;
}

PartialTruth PartialEvaluation::guard(const System& system, const Transition& transition,
                                      const PartialState& at, BitField& undecided) const {
  auto result = tests(system, transition, at, undecided);
  for (auto node : transition.rest) {
    if (result == PartialTruth::False) break;
    const auto met = condition(system, node, at, undecided);
    if (met != PartialTruth::True) result = met;
  }
  return result;
}

} // namespace proskill::verify
