#include "verify/refine/alike_cells.h"

#include <map>
#include <string>
#include <string_view>

namespace proskill::verify {

namespace {

/// The name of a cell without the indices of elements: `skill[].caller`.
std::string withoutIndices(std::string_view name) {
  std::string without;
  bool isIndex = false;
  for (const char c : name) {
    if (c == ']') isIndex = false;
    if (!isIndex) without += c;
    if (c == '[') isIndex = true;
  }
  return without;
}

} // namespace

AlikeCells::AlikeCells(const Slicer& slicer) : read(slicer.withLayout().instances.size()) {
  const System& system = slicer.withLayout();
  std::map<std::string, std::uint32_t> fields;
  for (const auto& cell : system.cells) {
    const auto next = static_cast<std::uint32_t>(fields.size());
    const bool isElement = cell.name.contains('[');
    field.push_back(isElement ? fields.try_emplace(withoutIndices(cell.name), next).first->second
                              : kNone);
  }
  const SliceFacts& facts = slicer.known();
  for (TransitionId id = 0; id < system.transitions.size(); ++id)
    for (const auto part : system.transitions[id].parts)
      for (const auto conjunct : facts.transitions[id].guard)
        read[system.paths[part].instance] |= facts.conjuncts[conjunct].whole.cells;
}

Bits AlikeCells::with(const Bits& cells) const {
  Bits all = cells;
  for (const auto& ofInstance : read) {
    if (!ofInstance.meets(cells)) continue;
    Bits known = cells;
    known &= ofInstance;
    const Bits fields = fieldsOf(known);
    ofInstance.each([&](CellId cell) {
      if (field[cell] != kNone && fields.contains(field[cell])) all.insert(cell);
    });
  }
  return all;
}

Bits AlikeCells::fieldsOf(const Bits& cells) const {
  Bits fields;
  cells.each([&](CellId cell) {
    if (field[cell] != kNone) fields.insert(field[cell]);
  });
  return fields;
}

} // namespace proskill::verify
