#include "verify/path_facts.h"

namespace proskill::verify {

std::map<std::uint32_t, Bits> surelyWritten(const Path& path, const Bits& allCells) {
  std::vector<Bits> before(path.code.size(), allCells); // not reached: everything
  if (!before.empty()) before[0] = {};
  std::map<std::uint32_t, Bits> atEnd;
  const auto meet = [](Bits& into, const Bits& other) {
    Bits outside = into;
    outside -= other;
    into -= outside;
  };
  for (std::size_t i = 0; i < path.code.size(); ++i) {
    const auto& instruction = path.code[i];
    Bits written = before[i];
    switch (instruction.kind) {
    case InstructionKind::Assign:
    case InstructionKind::Store:
      for (auto at = instruction.first; at < instruction.last; ++at)
        written.insert(path.assignments[at].target);
      break;
    case InstructionKind::JumpUnless: meet(before[instruction.last], written); break;
    case InstructionKind::Jump: meet(before[instruction.last], written); continue;
    case InstructionKind::To:
    case InstructionKind::Loop: {
      bool to = instruction.kind == InstructionKind::To;
      auto [end, first] = atEnd.try_emplace(to ? instruction.last : path.location, written);
      if (!first) meet(end->second, written);
      continue;
    }
    default: break;
    }
    if (i + 1 < path.code.size()) meet(before[i + 1], written);
  }
  return atEnd;
}

} // namespace proskill::verify
