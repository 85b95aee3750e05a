#include "verify/model/system_bytes.h"

namespace proskill::verify {

namespace {

/// What `malloc` adds to an allocation, with rounding.
constexpr std::uint64_t kOverhead = 16;

template <class... Element> std::uint64_t bytesIn(const std::vector<Element>&... all) {
  return ((all.empty() ? 0 : all.size() * sizeof(Element) + kOverhead) + ... + 0);
}

std::uint64_t bytesOfPath(const Path& path) {
  return sizeof(Path) + path.guardReads.bytes() + path.reads.bytes() + path.writes.bytes() +
         bytesIn(path.sent, path.code, path.assignments, path.stores, path.risks);
}

std::uint64_t bytesOfTransition(const Transition& transition) {
  return sizeof(Transition) + transition.consumed.bytes() + transition.guardReads.bytes() +
         transition.reads.bytes() + transition.writes.bytes() +
         bytesIn(transition.parts, transition.events, transition.seen, transition.tests,
                 transition.rest, transition.blockers, transition.laterBlockers);
}

} // namespace

std::uint64_t bytesOf(const System& system) {
  std::uint64_t all = bytesIn(system.cells, system.nodes, system.clocks);
  for (const auto& path : system.paths) all += bytesOfPath(path);
  for (const auto& transition : system.transitions) all += bytesOfTransition(transition);
  return all;
}

} // namespace proskill::verify
