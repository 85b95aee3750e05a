#include "verify/place.h"

#include "verify/evaluate.h"

#include <bit>

namespace proskill::verify {

namespace {

/// Hands out bit fields; none crosses the border of a word.
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

/// Comparisons of a cell with a constant become one test of bits.
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

} // namespace

System placed(System system, const Bits& kept) {
  Packer packer;
  for (CellId i = 0; i < system.cells.size(); ++i)
    if (kept.contains(i)) packer.place(system.cells[i]);
  system.storedWords = packer.words();
  packer.nextWord();
  for (CellId i = 0; i < system.cells.size(); ++i)
    if (!kept.contains(i)) packer.place(system.cells[i]);
  system.words = packer.words();
  for (auto& node : system.nodes) makeTest(system, node);
  return system;
}

System placed(System system) {
  Bits all;
  for (CellId i = 0; i < system.cells.size(); ++i) all.insert(i);
  return placed(std::move(system), all);
}

std::vector<Word> initialState(const System& system) {
  std::vector<Word> state(system.words);
  for (CellId i = 0; i < system.cells.size(); ++i)
    writeCell(system, i, system.cells[i].initial, state.data());
  return state;
}

} // namespace proskill::verify
