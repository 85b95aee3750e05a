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

/// A conjunct of a guard.
struct Conjunct {
  Condition whole;
  /// The conditions it is the conjunction of, if the negation of a disjunction counts as one.
  std::vector<Condition> parts;
};
using ConjunctId = std::uint32_t;

/// A test of a path's code that decides about nothing but events.
struct EventTest {
  Bits cells;
  Bits events;
};

/// Facts that determine whether a path belongs to a slice.
struct PathFacts {
  std::vector<ConjunctId> guard;
  std::vector<std::uint32_t> targets;    ///< locations
  std::vector<TransitionId> transitions; ///< those that contain the path
  Bits tested;                           ///< cells on which branches and failures of its code
                                         ///< depend
  Bits decisive; ///< those of them on which more depends than which events happen
  std::vector<EventTest> eventTests;
  std::vector<Bits> assigned;  ///< by assignment: the cells that its value reads
  Bits readLater;              ///< cells that its instance may read after it
  bool changesNothing = false; ///< it changes neither the location nor the clocks of its
                               ///< instance
};

struct TransitionFacts {
  std::vector<ConjunctId> guard;
  Bits ownLocations; ///< the cells with the locations of its instances
};

/// Facts about a system that are independent of the questions.
struct SliceFacts {
  /// \param system without a state layout; receives the nodes of conjuncts \throw LimitMet
  SliceFacts(System& system, LimitWatch& limits);

  std::vector<Conjunct> conjuncts;
  std::vector<PathFacts> paths;
  std::vector<TransitionFacts> transitions;
  std::vector<std::vector<PathId>> pathsOf; ///< by instance
  std::vector<Bits> writers;                ///< by cell: instances
  Bits moving;                              ///< instances with several locations
  Bits timed;                               ///< instances with clocks, or with urgent steps
};

} // namespace proskill::verify
