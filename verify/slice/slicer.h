#pragma once

#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/model/nodes.h"
#include "verify/slice/instant_waits.h"
#include "verify/slice/slice_facts.h"

#include <vector>

namespace proskill::verify {

/// The part of a system that is relevant for some questions. Each run of the whole, without the
/// steps outside of the slice, is a run of the slice: so what never happens in the slice never
/// happens. A slice may have more runs, so what happens in it need not happen in the whole.
struct Slice {
  System system; ///< cells, instances, nodes and events are numbered as in the whole
  std::vector<TransitionId> original; ///< by transition: its index in the whole system
  Bits late;                          ///< transitions that are urgent in the whole only
};

/// Cuts a system into slices. Weiser, "Program slicing", TSE 1984; docs/verification.md explains
/// why no run of the whole is lost.
class Slicer {
public:
  using Goals = std::vector<const Goal*>;

  /// \param system without a state layout, and without priorities \throw LimitMet
  Slicer(const System& system, LimitWatch& limits);

  /// Whether a slice can answer it: the goal asks for reachable states or steps.
  [[nodiscard]] static bool canDecide(const Goal& goal);
  /// The instances with several locations that influence whether one of the goals is reached.
  /// \throw LimitMet
  [[nodiscard]] Bits cone(const Goals& goals);
  /// All instances with several locations.
  [[nodiscard]] const Bits& moving() const { return facts.moving; }
  /// \throw LimitMet
  [[nodiscard]] Slice slice(const Goals& goals);

private:
  /// Dependencies of a slice. All sets only grow.
  struct Cone {
    Bits instances;
    Bits cells;  ///< whose values are relevant; locations only if other instances read them
    Bits shared; ///< those read by several instances, or by a goal
    std::vector<InstanceId> reader; ///< by cell: its only reader, or kNone
    Bits observed;                  ///< paths that must be in the slice
    Bits kept;                      ///< paths of the slice
    Bits relevant; ///< those that may lead to something relevant; the others start where one of
                   ///< these does
    Bits instant;  ///< conjuncts that are false only for an instant, so that the slice omits parts
                   ///< of them

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
