#include "verify/state/state_layout.h"

#include "verify/model/conjuncts.h"
#include "verify/state/evaluate.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <span>

namespace proskill::verify {

namespace {

/// Allocates bit fields, none of which crosses a word boundary.
class Packer {
public:
  void place(Cell& cell) {
    auto width =
        static_cast<std::uint32_t>(std::bit_width(static_cast<Word>(cell.high - cell.low)));
    if (used + width > 64) nextWord();
    cell.word = word;
    cell.shift = width == 0 ? 0 : used;
    cell.mask = width == 0 ? 0 : (~Word{0} >> (64 - width)) << used;
    used += width;
  }
  void nextWord() {
    ++word;
    used = 0;
  }
  [[nodiscard]] std::uint32_t words() const { return word + 1; }

private:
  std::uint32_t word = 0;
  std::uint32_t used = 0;
};

/// Turns comparisons of a cell with a constant into a bit test.
void makeTest(const System& system, Node& node) {
  if (node.op != NodeOp::Equal) return;
  const Node* cell = &system.nodes[node.a];
  const Node* number = &system.nodes[node.b];
  if (cell->op == NodeOp::Number) std::swap(cell, number);
  if (cell->op != NodeOp::Cell || number->op != NodeOp::Number) return;
  const Cell& place = system.cells[cell->a];
  if (number->number < place.low || number->number > place.high) {
    node = {.op = NodeOp::Number, .number = 0};
    return;
  }
  auto value = static_cast<Word>(number->number - place.low) << place.shift;
  node = {.op = NodeOp::Test, .a = place.word, .b = cell->a, .mask = place.mask, .value = value};
}

/// Combines equalities on one word into one test.
void addTest(std::vector<BitTest>& tests, const Node& node, bool equal) {
  auto same = std::ranges::find_if(
      tests, [&](const BitTest& test) { return test.equal && equal && test.word == node.a; });
  bool agrees = same != tests.end() && ((same->value ^ node.value) & same->mask & node.mask) == 0;
  if (!agrees) {
    tests.push_back({node.a, node.mask, node.value, equal});
    return;
  }
  same->mask |= node.mask;
  same->value |= node.value;
}

/// A condition as a test of bits; nothing if it is not one.
std::optional<Node> testOf(const System& system, const Node& node) {
  if (node.op == NodeOp::Test) return node;
  if (node.op != NodeOp::Cell) return std::nullopt;
  const Cell& cell = system.cells[node.a];
  if (cell.low != 0 || cell.high != 1) return std::nullopt;
  return Node{
      .op = NodeOp::Test, .a = cell.word, .b = node.a, .mask = cell.mask, .value = cell.mask};
}

void lowerGuard(const System& system, Transition& transition) {
  for (auto part : conjunctsOf(system, transition.guard)) {
    const Node& node = system.nodes[part];
    const bool negated = node.op == NodeOp::Not;
    auto test = testOf(system, negated ? system.nodes[node.a] : node);
    const bool isBit = test && std::has_single_bit(test->mask);
    if (!test || (negated && test->mask == 0)) { // a constant has no bits to differ in
      transition.rest.push_back(part);
    } else if (negated && isBit) { // to differ from one of two values is to equal the other one
      test->value ^= test->mask;
      addTest(transition.tests, *test, true);
    } else {
      addTest(transition.tests, *test, !negated);
    }
  }
}

/// Turns assignments of constants into stores.
void lowerCode(const System& system, Path& path) {
  for (auto& instruction : path.code) {
    if (instruction.kind != InstructionKind::Assign) continue;
    std::span all(path.assignments);
    all = all.subspan(instruction.first, instruction.last - instruction.first);
    bool constant = std::ranges::all_of(all, [&](const Assignment& assignment) {
      return !assignment.checked && system.nodes[assignment.value].op == NodeOp::Number;
    });
    if (!constant) continue;
    instruction.kind = InstructionKind::Store;
    instruction.firstStore = static_cast<std::uint32_t>(path.stores.size());
    for (const auto& assignment : all) {
      const Cell& cell = system.cells[assignment.target];
      auto value = static_cast<Word>(system.nodes[assignment.value].number - cell.low);
      path.stores.push_back({cell.word, ~cell.mask, value << cell.shift});
    }
    instruction.lastStore = static_cast<std::uint32_t>(path.stores.size());
  }
}

/// A cell that is never written, and whose initial value is its least, needs no bits.
void narrowConstants(System& system) {
  Bits written;
  for (const auto& path : system.paths) written |= path.writes;
  for (CellId i = 0; i < system.cells.size(); ++i) {
    Cell& cell = system.cells[i];
    if (!written.contains(i) && cell.initial == cell.low) cell.high = cell.low;
  }
}

/// All cells: the location of each instance, followed by what its steps change. So a step changes
/// bits that are close to each other, and few nodes of the tree in which states are stored
/// (verify/space/state_tree.h).
std::vector<CellId> inOrder(const System& system) {
  std::vector<std::vector<PathId>> paths(system.instances.size());
  for (PathId i = 0; i < system.paths.size(); ++i) paths[system.paths[i].instance].push_back(i);
  std::vector<CellId> order;
  Bits ordered;
  const auto add = [&](CellId cell) {
    if (ordered.contains(cell)) return;
    ordered.insert(cell);
    order.push_back(cell);
  };
  for (InstanceId i = 0; i < system.instances.size(); ++i) {
    add(system.instances[i].location);
    for (auto path : paths[i]) system.paths[path].writes.each(add);
  }
  for (CellId i = 0; i < system.cells.size(); ++i) add(i);
  return order;
}

} // namespace

System withStateLayout(System system, const Bits& kept) {
  narrowConstants(system);
  const auto order = inOrder(system);
  Packer packer;
  for (auto cell : order)
    if (kept.contains(cell)) packer.place(system.cells[cell]);
  system.storedWords = packer.words();
  packer.nextWord();
  for (auto cell : order)
    if (!kept.contains(cell)) packer.place(system.cells[cell]);
  system.words = packer.words();
  for (auto& node : system.nodes) makeTest(system, node);
  for (auto& transition : system.transitions) lowerGuard(system, transition);
  for (auto& path : system.paths) lowerCode(system, path);
  return system;
}

System withStateLayout(System system) {
  Bits all;
  for (CellId i = 0; i < system.cells.size(); ++i) all.insert(i);
  return withStateLayout(std::move(system), all);
}

std::vector<Word> initialState(const System& system) {
  std::vector<Word> state(system.words);
  for (CellId i = 0; i < system.cells.size(); ++i)
    writeCell(system, i, system.cells[i].initial, state.data());
  return state;
}

} // namespace proskill::verify
