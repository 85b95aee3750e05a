#include "verify/model/value_bounds.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace proskill::verify {

namespace {

__extension__ using Wide = __int128;

std::int64_t clampWide(Wide value) {
  return static_cast<std::int64_t>(std::clamp<Wide>(value, -kLargestNumber, kLargestNumber));
}

template <class Combine> ValueBounds corners(ValueBounds a, ValueBounds b, Combine combine) {
  const Wide values[] = {combine(a.low, b.low), combine(a.low, b.high), combine(a.high, b.low),
                         combine(a.high, b.high)};
  return {clampWide(*std::ranges::min_element(values)),
          clampWide(*std::ranges::max_element(values))};
}

ValueBounds moduloBounds(ValueBounds a, ValueBounds b) {
  std::int64_t most = std::max(b.high, -b.low) - 1;
  return {a.low < 0 ? -most : 0, a.high > 0 ? most : 0};
}

ValueBounds quotientBounds(ValueBounds a) {
  std::int64_t most = std::max(a.high, -a.low);
  return {-most, most};
}

/// Computes bounds. Within the sides of a conditional, cells are known to be in narrower ranges.
class Bounding {
public:
  explicit Bounding(const System& of) : system(of) {}

  [[nodiscard]] ValueBounds of(NodeId id) const {
    const Node& node = system.nodes[id];
    switch (node.op) {
    case NodeOp::Number: return {node.number, node.number};
    case NodeOp::Cell: return ofCell(node.a);
    case NodeOp::Negate: {
      const auto a = of(node.a);
      return {-a.high, -a.low};
    }
    case NodeOp::Add: {
      const auto [a, b] = std::pair{of(node.a), of(node.b)};
      return {clampWide(static_cast<Wide>(a.low) + b.low),
              clampWide(static_cast<Wide>(a.high) + b.high)};
    }
    case NodeOp::Subtract: {
      const auto [a, b] = std::pair{of(node.a), of(node.b)};
      return {clampWide(static_cast<Wide>(a.low) - b.high),
              clampWide(static_cast<Wide>(a.high) - b.low)};
    }
    case NodeOp::Multiply:
      return corners(of(node.a), of(node.b), [](Wide a, Wide b) { return a * b; });
    case NodeOp::Divide: return quotientBounds(of(node.a));
    case NodeOp::Modulo: return moduloBounds(of(node.a), of(node.b));
    case NodeOp::Conditional: return ofConditional(node);
    case NodeOp::Require: {
      const auto value = of(node.b);
      if (node.number == 0) return value;
      return {std::clamp(value.low, node.low, node.high),
              std::clamp(value.high, node.low, node.high)};
    }
    case NodeOp::Test:
    case NodeOp::Not:
    case NodeOp::And:
    case NodeOp::Or:
    case NodeOp::Equal:
    case NodeOp::Less:
    case NodeOp::LessEqual:
    case NodeOp::Happens:
    case NodeOp::Entered:
    case NodeOp::Left:
    case NodeOp::Received:
    case NodeOp::Fails: return {0, 1};
    }
    std::unreachable();
  }

  /// \return nullopt if what is known contradicts itself
  [[nodiscard]] std::optional<ValueBounds> ofKnown(NodeId node,
                                                   const std::vector<KnownTruth>& known) const {
    Bounding within = *this;
    for (const auto& [condition, truth] : known) within.assume(condition, truth);
    return within.isPossible ? std::optional(within.of(node)) : std::nullopt;
  }

private:
  [[nodiscard]] ValueBounds ofCell(CellId cell) const {
    const auto known = narrowed.find(cell);
    if (known != narrowed.end()) return known->second;
    return {system.cells[cell].low, system.cells[cell].high};
  }

  [[nodiscard]] ValueBounds ofConditional(const Node& node) const {
    const auto then = ofSide(node.a, true, node.b);
    const auto otherwise = ofSide(node.a, false, node.c);
    if (!then) return otherwise.value_or(of(node.c));
    if (!otherwise) return *then;
    return {std::min(then->low, otherwise->low), std::max(then->high, otherwise->high)};
  }

  [[nodiscard]] std::optional<ValueBounds> ofSide(NodeId condition, bool truth, NodeId side) const {
    return ofKnown(side, {{condition, truth}});
  }

  void assume(NodeId id, bool truth) {
    const Node& node = system.nodes[id];
    if (node.op == NodeOp::Not) return assume(node.a, !truth);
    if (node.op == (truth ? NodeOp::And : NodeOp::Or)) {
      assume(node.a, truth);
      assume(node.b, truth);
    } else if (node.op == NodeOp::Less) {
      truth ? assumeLess(node.a, node.b, 1) : assumeLess(node.b, node.a, 0);
    } else if (node.op == NodeOp::LessEqual) {
      truth ? assumeLess(node.a, node.b, 0) : assumeLess(node.b, node.a, 1);
    } else if (node.op == NodeOp::Equal && truth) {
      assumeLess(node.a, node.b, 0);
      assumeLess(node.b, node.a, 0);
    } else if (node.op == NodeOp::Equal) {
      assumeOther(node.a, of(node.b));
      assumeOther(node.b, of(node.a));
    }
  }

  /// `less` is at most `more` minus `least`.
  void assumeLess(NodeId less, NodeId more, std::int64_t least) {
    const auto [a, b] = std::pair{of(less), of(more)};
    narrow(less, {a.low, std::min(a.high, clampWide(static_cast<Wide>(b.high) - least))});
    narrow(more, {std::max(b.low, clampWide(static_cast<Wide>(a.low) + least)), b.high});
  }

  /// The node does not have the value, if it is one.
  void assumeOther(NodeId id, ValueBounds value) {
    auto bounds = of(id);
    if (value.low != value.high) return;
    if (bounds.low == value.low) ++bounds.low;
    if (bounds.high == value.low) --bounds.high;
    narrow(id, bounds);
  }

  void narrow(NodeId id, ValueBounds bounds) {
    if (bounds.low > bounds.high) isPossible = false;
    if (isPossible && system.nodes[id].op == NodeOp::Cell) narrowed[system.nodes[id].a] = bounds;
  }

  const System& system;
  std::map<CellId, ValueBounds> narrowed;
  bool isPossible = true;
};

} // namespace

ValueBounds valueBounds(const System& system, NodeId node) { return Bounding(system).of(node); }

std::optional<ValueBounds> valueBounds(const System& system, NodeId node,
                                       const std::vector<KnownTruth>& known) {
  return Bounding(system).ofKnown(node, known);
}

bool mayFail(const System& system, NodeId id) {
  const Node& node = system.nodes[id];
  const auto inside = [&](auto... parts) { return (mayFail(system, parts) || ...); };
  switch (node.op) {
  case NodeOp::Require: return true;
  case NodeOp::Number:
  case NodeOp::Cell:
  case NodeOp::Test:
  case NodeOp::Received:
  case NodeOp::Happens:
  case NodeOp::Fails: return false;
  case NodeOp::Not:
  case NodeOp::Negate:
  case NodeOp::Entered:
  case NodeOp::Left: return inside(node.a);
  case NodeOp::Conditional: return inside(node.a, node.b, node.c);
  case NodeOp::Divide:
  case NodeOp::Modulo: {
    const auto divisor = valueBounds(system, node.b);
    return (divisor.low <= 0 && 0 <= divisor.high) || inside(node.a, node.b);
  }
  case NodeOp::Add:
  case NodeOp::Subtract:
  case NodeOp::Multiply: {
    const auto bounds = valueBounds(system, id);
    return bounds.low <= -kLargestNumber || bounds.high >= kLargestNumber || inside(node.a, node.b);
  }
  case NodeOp::And:
  case NodeOp::Or:
  case NodeOp::Equal:
  case NodeOp::Less:
  case NodeOp::LessEqual: return inside(node.a, node.b);
  }
  std::unreachable();
}

} // namespace proskill::verify
