#pragma once

#include "verify/model/system.h"

#include <map>
#include <optional>
#include <vector>

namespace proskill::verify {

/// The targets of a path; the location itself if it loops.
[[nodiscard]] std::vector<std::uint32_t> targetsOf(const Path& path);

/// Computes a fact about the values of cells at each end of a path, along all ways through its
/// code. \param start the fact before the path \param assign changes a fact by an assignment:
/// `void(Fact&, const Assignment&)` \param join adds a fact of another way: `bool(Fact&, const
/// Fact&)`; whether that changed the fact \return by the location in which the path ends; `loop`
/// ends in its own location
template <class Fact, class Assign, class Join>
[[nodiscard]] std::map<std::uint32_t, Fact> alongPath(const Path& path, const Fact& start,
                                                      Assign assign, Join join) {
  std::vector<std::optional<Fact>> before(path.code.size()); // nullopt: not reached
  std::map<std::uint32_t, Fact> atEnd;
  if (before.empty()) return atEnd;
  before[0] = start;
  bool grew = true;
  const auto reach = [&](std::size_t at, const Fact& fact) {
    if (at >= before.size()) return;
    const bool isNew = !before[at];
    if (isNew) before[at] = fact;
    grew = isNew || join(*before[at], fact) || grew;
  };
  const auto end = [&](std::uint32_t location, const Fact& fact) {
    if (const auto [entry, isNew] = atEnd.try_emplace(location, fact); !isNew)
      join(entry->second, fact);
  };
  while (grew) { // code may jump backwards
    grew = false;
    for (std::size_t i = 0; i < path.code.size(); ++i) {
      if (!before[i]) continue;
      const auto& instruction = path.code[i];
      Fact fact = *before[i];
      switch (instruction.kind) {
      case InstructionKind::Assign:
      case InstructionKind::Store:
        for (auto at = instruction.first; at < instruction.last; ++at)
          assign(fact, path.assignments[at]);
        break;
      case InstructionKind::JumpUnless: reach(instruction.last, fact); break;
      case InstructionKind::Jump: reach(instruction.last, fact); continue;
      case InstructionKind::To: end(instruction.last, fact); continue;
      case InstructionKind::Loop: end(path.location, fact); continue;
      case InstructionKind::On:
      case InstructionKind::Tag:
      case InstructionKind::Origin:
      case InstructionKind::Fail: break;
      }
      reach(i + 1, fact);
    }
  }
  return atEnd;
}

/// The cells that every way through a path's code surely writes, by the location in which it ends.
[[nodiscard]] std::map<std::uint32_t, Bits> surelyWritten(const Path& path);

/// Whether the transition may be an error of the model.
[[nodiscard]] bool mayBeAnError(const System& system, TransitionId id);

/// Whether the transition may cause one of the events.
[[nodiscard]] bool mayPass(const System& system, const Transition& transition, const Bits& events);

/// Whether the path may make a condition on cells true. If the path only writes constants to the
/// condition's single cell, the condition is evaluated with these constants. \pre the system has a
/// state layout
[[nodiscard]] bool mayMakeTrue(const System& system, const Path& path, NodeId condition);

/// Whether the condition is false after the path, wherever it ends: the path surely writes the
/// condition's single cell, only constants, and none of them satisfies the condition.
/// \param sure cells that the path surely writes
[[nodiscard]] bool makesFalse(const System& system, const Path& path, const Bits& sure,
                              NodeId condition);

} // namespace proskill::verify
