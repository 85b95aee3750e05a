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

} // namespace

std::vector<OriginId> waitsIn(const System& system, const fiacre::Provenance& provenance,
                              const std::vector<Word>& state) {
  std::vector<OriginId> all;
  std::vector<bool> known(system.instances.size());
  for (const auto kind : {Ground::Kind::Condition, Ground::Kind::Cause})
    for (const auto& path : system.paths) {
      const CellId location = system.instances[path.instance].location;
      const std::int64_t now = readCell(system, location, state.data());
      if (known[path.instance] || now != path.location || now == system.cells[location].initial)
        continue;
      const auto origin = waitOn(provenance, path, kind);
      if (!origin) continue;
      known[path.instance] = true;
      all.push_back(*origin);
    }
  return all;
}

} // namespace proskill::verify
