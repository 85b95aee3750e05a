#pragma once

#include "verify/limits.h"
#include "verify/model/system.h"

#include <vector>

namespace proskill::verify {

/// A condition and the cells that it reads.
struct Condition {
  NodeId node = 0;
  Bits cells;
};

/// One of the conditions that a guard is the conjunction of.
struct Conjunct {
  Condition whole;
  /// The conditions that it is the conjunction of, if the negation of a disjunction counts as one.
  std::vector<Condition> parts;
};
using ConjunctId = std::uint32_t;

/// What decides whether a path belongs to a slice.
struct PathFacts {
  std::vector<ConjunctId> guard;
  std::vector<std::uint32_t> targets;    ///< locations
  std::vector<TransitionId> transitions; ///< those that the path is a part of
  Bits tested;                           ///< cells that its code reads to choose a way, or to fail
  std::vector<Bits> assigned;            ///< by assignment: the cells that its value reads
  Bits readLater;                        ///< cells that its instance may read after it
  bool changesNothing = false;           ///< neither the location nor the clocks of its instance
};

struct TransitionFacts {
  std::vector<ConjunctId> guard;
  Bits ownLocations; ///< the cells with the locations of its instances
};

/// Facts about a system that do not depend on what a slice is about.
struct SliceFacts {
  /// \param system without a state layout; gets the nodes of conjuncts \throw LimitMet
  SliceFacts(System& system, LimitWatch& limits);

  std::vector<Conjunct> conjuncts;
  std::vector<PathFacts> paths;
  std::vector<TransitionFacts> transitions;
  std::vector<std::vector<PathId>> pathsOf; ///< by instance
  std::vector<Bits> writers;                ///< by cell: instances
  Bits moving;                              ///< instances with several locations
};

} // namespace proskill::verify
