#include "verify/state/constant_steps.h"

#include <algorithm>
#include <optional>

namespace proskill::verify {

namespace {

/// Adds a write that comes after the others.
void addStore(std::vector<BitStore>& to, const BitStore& more) {
  const auto same = std::ranges::find(to, more.word, &BitStore::word);
  if (same == to.end()) return to.push_back(more);
  same->keep &= more.keep;
  same->bits = (same->bits & more.keep) | more.bits;
}

BitStore storeOf(const Cell& cell, std::int64_t value) {
  return {cell.word, ~cell.mask, static_cast<Word>(value - cell.low) << cell.shift};
}

/// Adds what a path writes. \return whether that is the same in every state, without events
bool addStores(const System& system, const Path& path, std::vector<BitStore>& to) {
  for (const auto& instruction : path.code) {
    if (instruction.event != kNone) return false;
    switch (instruction.kind) {
    case InstructionKind::Store:
      for (auto i = instruction.firstStore; i < instruction.lastStore; ++i)
        addStore(to, path.stores[i]);
      break;
    case InstructionKind::Tag:
    case InstructionKind::Origin: break;
    case InstructionKind::To:
      addStore(to,
               storeOf(system.cells[system.instances[path.instance].location], instruction.last));
      return true;
    case InstructionKind::Loop: return true;
    case InstructionKind::Assign:
    case InstructionKind::On:
    case InstructionKind::JumpUnless:
    case InstructionKind::Jump:
    case InstructionKind::Fail: return false;
    }
  }
  return false;
}

/// What a transition writes; nothing if that depends on the state, or if there are events.
std::optional<std::vector<BitStore>> storesOf(const System& system, const Transition& transition) {
  if (transition.apart || !transition.seen.empty() || !transition.events.empty())
    return std::nullopt;
  std::vector<BitStore> made;
  for (auto part : transition.parts)
    if (!addStores(system, system.paths[part], made)) return std::nullopt;
  return made;
}

} // namespace

ConstantSteps::ConstantSteps(const System& system)
    : constant((system.transitions.size() + 63) / 64), firstOf{0} {
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    if (const auto made = storesOf(system, system.transitions[i])) {
      insert(constant, i);
      stores.insert(stores.end(), made->begin(), made->end());
    }
    firstOf.push_back(static_cast<std::uint32_t>(stores.size()));
  }
}

} // namespace proskill::verify
