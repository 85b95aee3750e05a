#pragma once

#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/model/nodes.h"
#include "verify/slice/instant_waits.h"

#include <map>
#include <vector>

namespace proskill::verify {

/// The part of a system that some questions are about. Each run of the whole is a run of the slice,
/// without the steps that are not in it: what never happens in the slice never happens. A slice may
/// have more runs, so what happens in it need not happen in the whole.
struct Slice {
  System system; ///< cells, instances, nodes and events are numbered as in the whole
  std::vector<TransitionId> original; ///< by transition: which it is of the whole
  Bits late;                          ///< transitions that are urgent in the whole only
};

/// Cuts a system into slices. Weiser, "Program slicing", TSE 1984; docs/verification.md says why no
/// run of the whole is lost.
class Slicer {
public:
  using Goals = std::vector<const Goal*>;

  /// \param system without a state layout, and without priorities \throw LimitMet
  Slicer(const System& system, LimitWatch& limits);

  /// Whether a slice can answer it: it asks for states or steps that are reached.
  [[nodiscard]] static bool canDecide(const Goal& goal);
  /// The instances with several locations that have an influence on whether one of the goals is
  /// reached. \throw LimitMet
  [[nodiscard]] Bits cone(const Goals& goals);
  /// All instances with several locations.
  [[nodiscard]] const Bits& moving() const { return movingOnes; }
  /// \throw LimitMet
  [[nodiscard]] Slice slice(const Goals& goals);

private:
  /// What a slice looks at.
  struct Cone {
    Bits instances;
    Bits cells;  ///< whose values matter; locations only where other instances read them
    Bits shared; ///< those of them that several instances read, or a goal
    std::map<CellId, InstanceId> reader; ///< of the others
    Bits observed;                       ///< paths that have to be in the slice
    Bits relevant;                       ///< paths that may lead to what matters
    Bits ending;                         ///< other paths that start where a relevant one does
    Bits instant; ///< conditions that are false for an instant only, of which a part may do
    friend bool operator==(const Cone&, const Cone&) = default;
  };

  void readGuards();
  void split(NodeId node, bool negated, bool alsoOr, std::vector<NodeId>& all);
  [[nodiscard]] const std::vector<NodeId>& partsOf(NodeId conjunct);
  [[nodiscard]] bool isInstant(NodeId conjunct);
  [[nodiscard]] Cone coneOf(const Goals& goals);
  void begin(const Goals& goals, Cone& cone) const;
  void observe(TransitionId id, Cone& cone) const;
  void grow(Cone& cone);
  void sortPaths(InstanceId instance, Cone& cone) const;
  void needGuard(TransitionId id, Cone& cone);
  void needCode(const Path& path, Cone& cone) const;
  void needInstants(Cone& cone);
  [[nodiscard]] bool changesNothing(PathId path) const;
  static void need(const Bits& cells, InstanceId reader, Cone& cone);
  void findReadLater();
  [[nodiscard]] bool writesWhatMatters(const Path& path, const Cone& cone) const;
  [[nodiscard]] Bits ownLocations(const Transition& transition) const;
  [[nodiscard]] Bits readBy(NodeId node) const;
  [[nodiscard]] NodeId guardWithin(const std::vector<NodeId>& conjuncts, const Bits& known,
                                   Nodes& nodes);

  System base;
  Nodes nodes; ///< of base
  LimitWatch& limits;
  std::vector<std::vector<NodeId>> ofPath;       ///< conjuncts of guards
  std::vector<std::vector<NodeId>> ofTransition; ///< conjuncts of guards
  std::map<NodeId, std::vector<NodeId>> parts;   ///< of conjuncts that deny a disjunction
  std::vector<std::vector<PathId>> pathsOf;      ///< by instance
  std::vector<std::vector<TransitionId>> having; ///< by path
  std::vector<Bits> writers;                     ///< by cell: instances
  std::vector<std::vector<Bits>> readLater; ///< by instance and location: cells that it may read
  Bits movingOnes;
  System laidOut;
  InstantWaits waits; ///< of laidOut
};

} // namespace proskill::verify
