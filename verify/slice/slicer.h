#pragma once

#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/model/nodes.h"
#include "verify/slice/instant_waits.h"
#include "verify/slice/slice_facts.h"

#include <map>
#include <optional>
#include <vector>

namespace proskill::verify {

/// The part of a system that is relevant for some questions. Each run of the whole, without the
/// steps outside of the slice, is a run of the slice: so what never happens in the slice never
/// happens. A slice may have more runs, so what happens in it need not happen in the whole.
struct Slice {
  System system; ///< cells, instances, nodes and events are numbered as in the whole
  std::vector<TransitionId> original; ///< by transition: its index in the whole system
  Bits late; ///< transitions that have to happen by some date in the whole only

  [[nodiscard]] std::vector<TransitionId> inWhole(std::vector<TransitionId> steps) const;
  /// The other transitions, numbered as in the whole.
  [[nodiscard]] Bits punctual() const;
};

/// What a slice is for.
struct SliceSeeds {
  std::vector<const Goal*> goals; ///< that ask for reachable states or steps
  /// Transitions whose order and dates are to be exact, with everything that influences them.
  Bits steps;
  /// Instances whose urgent steps may be taken at any time, whatever other instances do. The slice
  /// then has more runs, and is smaller.
  Bits loose;
  /// If it is set: conditions of steps on other cells are omitted, unless the slice has these cells
  /// anyway. Such steps may be taken at any time, so the slice has more runs, and is smaller.
  std::optional<Bits> cells{};
};

/// Cuts a system into slices. Weiser, "Program slicing", TSE 1984; docs/verification.md explains
/// why no run of the whole is lost.
class Slicer {
public:
  /// \param system without a state layout, and without priorities \throw LimitMet
  Slicer(const System& system, LimitWatch& limits);

  /// Whether a slice can answer it: the goal asks for reachable states or steps.
  [[nodiscard]] static bool canDecide(const Goal& goal);
  /// The instances that influence what the slice is for. \throw LimitMet
  [[nodiscard]] Bits instances(const SliceSeeds& seeds) { return coneOf(seeds).instances; }
  /// Those of them with several locations. \throw LimitMet
  [[nodiscard]] Bits cone(const SliceSeeds& seeds);
  /// The same if these are at most so many. It costs less if they are more. \throw LimitMet
  [[nodiscard]] std::optional<Bits> coneWithin(const SliceSeeds& seeds, std::size_t most);
  /// All instances with several locations.
  [[nodiscard]] const Bits& moving() const { return facts.moving; }
  /// \throw LimitMet
  [[nodiscard]] Slice slice(const SliceSeeds& seeds);

  /// The system that is cut. Nodes may be added to it.
  [[nodiscard]] System& system() { return base; }
  /// It has the nodes of known().
  [[nodiscard]] const System& withLayout() const { return laidOut; }
  [[nodiscard]] const SliceFacts& known() const { return facts; }
  [[nodiscard]] InstantWaits& instantWaits() { return waits; }
  /// Whether no time passes while the conjunct is false. \throw LimitMet
  [[nodiscard]] bool isInstant(ConjunctId conjunct);
  /// The parts of a conjunct during which time may pass while they are false. \throw LimitMet
  [[nodiscard]] std::vector<const Condition*> lasting(ConjunctId conjunct);

private:
  /// Dependencies of a slice. All sets only grow.
  struct Cone {
    Bits loose;
    std::optional<Bits> known; ///< cells of conditions that are not omitted; nullopt: none is
    bool isExact = false;      ///< all steps of an instance with several locations or clocks matter
    Bits instances;
    Bits cells;  ///< whose values are relevant; locations only if other instances read them
    Bits shared; ///< those read by several instances, or by a goal
    std::vector<InstanceId> reader; ///< by cell: its only reader, or kNone
    std::vector<Bits> own; ///< by instance: its location, and the cells that it is the reader of
    Bits events;           ///< that a goal asks for
    Bits observed;         ///< paths that must be in the slice
    Bits kept;             ///< paths of the slice
    Bits relevant; ///< those that may lead to something relevant; the others start where one of
                   ///< these does
    Bits instant;  ///< conjuncts that are false only for an instant, so that the slice omits parts
                   ///< of them

    [[nodiscard]] std::size_t size() const;
  };

  [[nodiscard]] Cone coneOf(const SliceSeeds& seeds);
  [[nodiscard]] bool growsWithin(std::size_t most, Cone& cone);
  [[nodiscard]] Bits movingOf(const Cone& cone) const;
  void begin(const SliceSeeds& seeds, Cone& cone) const;
  void observe(TransitionId id, Cone& cone) const;
  void grow(Cone& cone);
  void sortPaths(InstanceId instance, Cone& cone) const;
  void needGuard(TransitionId id, Cone& cone);
  void needCode(PathId id, Cone& cone) const;
  void needInstants(Cone& cone) const;
  static void need(const Bits& cells, InstanceId reader, Cone& cone);
  [[nodiscard]] bool isLoose(TransitionId id, const Cone& cone) const;
  [[nodiscard]] bool isOmitted(ConjunctId conjunct, TransitionId of, const Cone& cone) const;
  [[nodiscard]] Bits currentFor(const Bits& moving, const Cone& cone) const;
  [[nodiscard]] Bits instancesOf(TransitionId id) const;
  [[nodiscard]] Transition cut(TransitionId id, const Cone& cone, Nodes& nodes, Slice& made);
  [[nodiscard]] Path cutPath(PathId id, const Cone& cone, Nodes& nodes) const;
  [[nodiscard]] bool mayBeLate(TransitionId id, const Bits& current, const Cone& cone);
  [[nodiscard]] bool writesWhatMatters(PathId id, const Cone& cone) const;
  [[nodiscard]] NodeId guardWithin(const std::vector<ConjunctId>& guard, const Bits& known,
                                   Nodes& nodes) const;

  System base;
  LimitWatch& limits;
  SliceFacts facts; ///< of base
  System shell;     ///< base without paths and transitions
  System laidOut;
  InstantWaits waits; ///< of laidOut
  std::map<ConjunctId, bool> instants;
};

} // namespace proskill::verify
