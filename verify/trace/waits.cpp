#include "verify/trace/waits.h"

#include "verify/state/evaluate.h"

#include <algorithm>
#include <optional>

namespace proskill::verify {

namespace {

using fiacre::Ground;
using fiacre::OriginId;

/// Nothing is known of a model without provenance.
bool has(const fiacre::Provenance& provenance, OriginId origin, Ground::Kind kind) {
  if (origin >= provenance.origins.size()) return false;
  const auto& grounds = provenance.origins[origin].grounds;
  return !provenance.origins[origin].description.empty() &&
         std::ranges::any_of(grounds, [&](const Ground& it) {
           return it.kind == kind && it.expected && !it.afterwards;
         });
}

/// The first origin on a path that waits for something of this kind.
std::optional<OriginId> waitOn(const fiacre::Provenance& provenance, const Path& path,
                               Ground::Kind kind) {
  if (has(provenance, path.origin, kind)) return path.origin;
  for (const auto& instruction : path.code)
    if (instruction.kind == InstructionKind::Origin && has(provenance, instruction.first, kind))
      return instruction.first;
  return std::nullopt;
}

/// The origins on a path, in its order.
std::vector<OriginId> originsOn(const Path& path) {
  std::vector<OriginId> all{path.origin};
  for (const auto& instruction : path.code)
    if (instruction.kind == InstructionKind::Origin) all.push_back(instruction.first);
  return all;
}

class Waits {
public:
  Waits(const System& of, const fiacre::Provenance& origins, const std::vector<Word>& at)
      : system(of), provenance(origins), state(at), known(of.instances.size()) {}

  std::vector<Wait> find() {
    eachPath(true, [&](const Path& path) { return startOn(path); });
    for (const auto kind : {Ground::Kind::Condition, Ground::Kind::Cause})
      eachPath(false, [&](const Path& path) -> std::optional<Wait> {
        const auto origin = waitOn(provenance, path, kind);
        return origin ? std::optional(Wait{*origin}) : std::nullopt;
      });
    return std::move(all);
  }

private:
  /// Visits the paths from where the instances are. Notes one wait of each.
  /// \param initially whether to visit instances where they began, or the others
  template <class Find> void eachPath(bool initially, Find find) {
    for (const auto& path : system.paths) {
      const CellId location = system.instances[path.instance].location;
      const std::int64_t now = readCell(system, location, state.data());
      const bool isInitial = now == system.cells[location].initial;
      if (known[path.instance] || now != path.location || isInitial != initially) continue;
      auto wait = find(path);
      if (!wait) continue;
      known[path.instance] = true;
      all.push_back(std::move(*wait));
    }
  }

  /// The wait of a skill that is called and cannot start.
  [[nodiscard]] std::optional<Wait> startOn(const Path& path) const {
    for (const auto origin : originsOn(path)) {
      if (origin >= provenance.origins.size()) continue;
      Wait wait{origin};
      bool isCalled = false;
      const auto [first, last] =
          std::ranges::equal_range(system.grounds, origin, {}, &GroundNode::origin);
      for (const auto& node : std::ranges::subrange(first, last)) {
        const auto kind = provenance.origins[origin].grounds[node.index].kind;
        isCalled = isCalled || (kind == Ground::Kind::Cause && isTrue(node));
        if ((kind == Ground::Kind::Need && !isTrue(node)) ||
            (kind == Ground::Kind::Holder && isTrue(node)))
          wait.grounds.push_back(node.index);
      }
      const bool lacks = std::ranges::any_of(wait.grounds, [&](std::size_t index) {
        return provenance.origins[origin].grounds[index].kind == Ground::Kind::Need;
      });
      if (isCalled && lacks) return wait;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool isTrue(const GroundNode& ground) const {
    FaultId fault = kNoFault;
    return evaluate(system, ground.node, state.data(), fault) != 0 && fault == kNoFault;
  }

  const System& system;
  const fiacre::Provenance& provenance;
  const std::vector<Word>& state;
  std::vector<bool> known; ///< instances whose waits are noted
  std::vector<Wait> all;
};

} // namespace

std::vector<Wait> waitsIn(const System& system, const fiacre::Provenance& provenance,
                          const std::vector<Word>& state) {
  return Waits(system, provenance, state).find();
}

} // namespace proskill::verify
