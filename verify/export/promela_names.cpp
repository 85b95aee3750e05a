#include "verify/export/promela_names.h"

#include "verify/model/value_bounds.h"
#include "verify/unsupported.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace proskill::verify {

namespace {

bool fitsInt(std::int64_t low, std::int64_t high) { return INT32_MIN < low && high <= INT32_MAX; }

std::string_view operatorOf(NodeOp op) {
  switch (op) {
  case NodeOp::And: return "&&";
  case NodeOp::Or: return "||";
  case NodeOp::Equal: return "==";
  case NodeOp::Less: return "<";
  case NodeOp::LessEqual: return "<=";
  case NodeOp::Add: return "+";
  case NodeOp::Subtract: return "-";
  case NodeOp::Multiply: return "*";
  case NodeOp::Divide: return "/";
  case NodeOp::Modulo: return "%";
  case NodeOp::Number:
  case NodeOp::Cell:
  case NodeOp::Test:
  case NodeOp::Not:
  case NodeOp::Negate:
  case NodeOp::Conditional:
  case NodeOp::Happens:
  case NodeOp::Entered:
  case NodeOp::Left:
  case NodeOp::Received:
  case NodeOp::Require:
  case NodeOp::Fails: break;
  }
  std::unreachable();
}

} // namespace

std::string promelaType(std::int64_t low, std::int64_t high) {
  if (!fitsInt(low, high)) unsupported("Promela has no numbers beyond 2^31");
  if (0 <= low && high <= 1) return "bool";
  if (0 <= low && high <= UINT8_MAX) return "byte";
  return INT16_MIN <= low && high <= INT16_MAX ? "short" : "int";
}

PromelaNames::PromelaNames(const System& of) : system(of) {
  std::vector<bool> isLocation(system.cells.size());
  for (const auto& instance : system.instances) isLocation[instance.location] = true;
  for (CellId i = 0; i < system.cells.size(); ++i)
    cells.push_back(taken.make(isLocation[i] ? "at_" : "v_", system.cells[i].name));
}

std::string PromelaNames::text(NodeId node) const {
  return write(node, {[this](CellId cell) { return cells[cell]; }});
}

std::string PromelaNames::text(NodeId node, const Bits& old) const {
  return write(node,
               {[&](CellId cell) { return old.contains(cell) ? before(cell) : cells[cell]; }});
}

std::string PromelaNames::overStep(NodeId node) const {
  return write(node, {[this](CellId cell) { return before(cell); }, true});
}

std::string PromelaNames::write(NodeId id, const Leaves& leaves) const {
  const Node& node = system.nodes[id];
  const auto part = [&](NodeId of) { return write(of, leaves); };
  const auto bounds = valueBounds(system, id);
  if (!fitsInt(bounds.low, bounds.high))
    unsupported("Promela calculates with numbers of 32 bits, and one here may be larger");
  switch (node.op) {
  case NodeOp::Number:
    return node.number < 0 ? fmt::format("({})", node.number) : std::to_string(node.number);
  case NodeOp::Cell: return leaves.cell(node.a);
  case NodeOp::Happens: return leaves.ofStep ? event(node.a) : "0";
  case NodeOp::Not: return fmt::format("(!{})", part(node.a)); // `!!` is a token of its own
  case NodeOp::Negate: return fmt::format("(-{})", part(node.a));
  case NodeOp::Conditional:
    return fmt::format("({} -> {} : {})", part(node.a), part(node.b), part(node.c));
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
    return fmt::format("({} {} {})", part(node.a), operatorOf(node.op), part(node.b));
  case NodeOp::Entered:
  case NodeOp::Left: return leaves.ofStep ? change(node) : "0";
  case NodeOp::Test:
  case NodeOp::Received:
  case NodeOp::Require:
  case NodeOp::Fails: break;
  }
  std::unreachable();
}

std::string PromelaNames::change(const Node& node) const {
  const auto was = write(node.a, {[this](CellId cell) { return before(cell); }});
  const auto is = text(node.a);
  return node.op == NodeOp::Entered ? fmt::format("(!{} && {})", was, is)
                                    : fmt::format("({} && !{})", was, is);
}

} // namespace proskill::verify
