#pragma once

#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/model/nodes.h"
#include "verify/slice/instant_waits.h"
#include "verify/slice/slice_facts.h"

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
  [[nodiscard]] const Bits& moving() const { return facts.moving; }
  /// \throw LimitMet
  [[nodiscard]] Slice slice(const Goals& goals);

private:
  /// What a slice depends on. All of it only grows.
  struct Cone {
    Bits instances;
    Bits cells;  ///< whose values matter; locations only where other instances read them
    Bits shared; ///< those of them that several instances read, or a goal
    std::vector<InstanceId> reader; ///< by cell: the only one that reads it, or kNone
    Bits observed;                  ///< paths that have to be in the slice
    Bits kept;                      ///< paths of the slice
    Bits relevant; ///< those that may lead to what matters; the others start where one of them does
    Bits instant;  ///< conjuncts that are false for an instant only, so that the slice omits parts

    [[nodiscard]] std::size_t size() const;
  };

  [[nodiscard]] Cone coneOf(const Goals& goals);
  void begin(const Goals& goals, Cone& cone) const;
  void observe(TransitionId id, Cone& cone) const;
  void grow(Cone& cone);
  void sortPaths(InstanceId instance, Cone& cone) const;
  void needGuard(TransitionId id, Cone& cone);
  void needCode(PathId id, Cone& cone) const;
  void needInstants(Cone& cone) const;
  static void need(const Bits& cells, InstanceId reader, Cone& cone);
  [[nodiscard]] bool isInstant(ConjunctId conjunct);
  [[nodiscard]] bool writesWhatMatters(PathId id, const Cone& cone) const;
  [[nodiscard]] NodeId guardWithin(const std::vector<ConjunctId>& guard, const Bits& known,
                                   Nodes& nodes) const;

  System base;
  LimitWatch& limits;
  SliceFacts facts; ///< of base
  System laidOut;
  InstantWaits waits; ///< of laidOut
};

} // namespace proskill::verify
