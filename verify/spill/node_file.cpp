#include "verify/spill/node_file.h"

#include <algorithm>
#include <cstring>

namespace proskill::verify {

NodeFile::NodeFile(SpillSpace& space, const SpillFormat& of)
    : format(of), file(space), before(of.words), added(of.words) {}

/// The state comes first, as it is: what is added is its difference from the one before.
std::string_view NodeFile::textOf(const StateGroup& group, std::size_t zone) {
  const std::size_t bytes = std::size_t{format.words} * sizeof(Word);
  text.bytes.resize(bytes);
  std::memcpy(text.bytes.data(), group.state.data(), bytes);
  if (format.hasZones) {
    text.number(group.dimension);
    writeZone(text, group.dimension, group.zone(zone));
  }
  const Discovery& how = group.discoveries[zone];
  text.number(how.parent);
  text.number(how.step + std::uint64_t{1});
  return text.bytes;
}

void NodeFile::add(std::string_view of) {
  const std::size_t bytes = std::size_t{format.words} * sizeof(Word);
  std::memcpy(added.data(), of.data(), bytes);
  if (count % kNodesOfBlock == 0) {
    offsets.push_back(file.size());
    std::ranges::fill(before, 0);
  }
  writeState(file, before, added.data());
  file.add(of.substr(bytes));
  ++count;
}

SpilledNode NodeFile::at(std::uint64_t node) const {
  SpilledNode found;
  Reader(*this, node).next(found);
  return found;
}

NodeFile::Reader::Reader(const NodeFile& of, std::uint64_t first)
    : nodes(of), number(first), state(of.format.words) {
  if (first >= of.count) return;
  number = first / kNodesOfBlock * kNodesOfBlock;
  reader = PageReader(of.file, of.offsets[number / kNodesOfBlock], UINT64_MAX);
  SpilledNode passed;
  while (number < first) next(passed);
}

void NodeFile::Reader::next(SpilledNode& to) {
  if (number % kNodesOfBlock == 0) std::ranges::fill(state, 0);
  readState(reader, state);
  to.state = state;
  std::uint32_t dimension = 1;
  bounds.clear();
  if (nodes.format.hasZones) dimension = static_cast<std::uint32_t>(reader.number());
  if (nodes.format.hasZones)
    readZone(reader, dimension, bounds);
  else
    bounds.push_back(kZero);
  to.zone = Dbm(dimension, bounds);
  to.parent = reader.number();
  to.step = static_cast<TransitionId>(reader.number() - 1);
  ++number;
}

} // namespace proskill::verify
