#pragma once

#include "verify/model/dbm.h"
#include "verify/model/system.h"
#include "verify/state/store.h"
#include "verify/state/transition_set.h"

namespace proskill::verify {

using SignatureId = std::uint32_t;

/// All that time needs to know of a discrete state: whether it may pass, and which clocked
/// transitions are enabled.
struct Signature {
  bool urgent = false;
  std::vector<TransitionId> enabled; ///< clocked ones, ascending
  std::vector<ClockId> clocks;       ///< theirs, ascending: the matrix has them in this order
  std::vector<Bound> invariants;     ///< by clock: how far time may go
  std::vector<std::int32_t> lower;   ///< by index in the matrix: for Dbm::extrapolate
  std::vector<std::int32_t> upper;
};

enum class Extrapolation : std::uint8_t {
  LowerUpper, ///< Extra+LU
  Maximum,    ///< the same, with the greater of both constants for both: exact up to bisimulation
  Least,      ///< only what an unbounded clock needs for the graph to be finite
};

/// Zones of a system: where they start, and what a transition makes of them. Zones are those after
/// time has passed.
class Timing {
public:
  Timing(const System& of, Extrapolation how) : system(of), extrapolation(how) {}

  /// \param clocked which transitions have clocks: of `enabled`, those count
  [[nodiscard]] SignatureId signature(bool urgent, const TransitionSet& enabled,
                                      const TransitionSet& clocked);
  [[nodiscard]] const Signature& at(SignatureId id) const { return signatures[id]; }
  /// Every clock 0, then time.
  [[nodiscard]] ZoneId initial(SignatureId signature);
  /// From a zone of `before` by `transition` to the zone of `after`; kNone where time forbids the
  /// transition.
  [[nodiscard]] ZoneId after(ZoneId zone, SignatureId before, TransitionId transition,
                             SignatureId after);
  /// Whether the transition can fire from some point of the zone. \pre it is enabled in the
  /// discrete state
  [[nodiscard]] bool isFirable(ZoneId zone, SignatureId signature, TransitionId transition) const;
  /// Limits a zone to where the transition can fire: its own bounds, and nothing that has priority
  /// being ready. False where nothing is left.
  [[nodiscard]] bool allow(Dbm& zone, SignatureId signature, TransitionId transition) const;
  /// For Dbm::over: which clocks of `before` go on as clocks of `after`.
  [[nodiscard]] std::vector<std::uint32_t> kept(SignatureId before, TransitionId transition,
                                                SignatureId after) const;
  [[nodiscard]] const ZoneStore& zones() const { return store; }
  [[nodiscard]] std::uint64_t bytes() const { return store.bytes() + memo.bytes(); }
  [[nodiscard]] std::uint64_t growth() const { return store.growth() + memo.growth(); }

private:
  ZoneId calculate(ZoneId zone, SignatureId before, TransitionId transition, SignatureId after);
  ZoneId settle(Dbm zone, const Signature& signature);

  const System& system;
  Extrapolation extrapolation;
  std::vector<Signature> signatures;
  std::vector<TransitionSet> sets; ///< by signature
  NumberTable table;
  ZoneStore store;
  Memo memo;
};

/// Whether firing `transition` starts the clock anew where it goes on to be needed.
[[nodiscard]] bool resets(const System& system, TransitionId transition, ClockId clock);

/// The bounds of a transition's clock when it fires: `lower` limits 0 - x, `upper` limits x - 0.
[[nodiscard]] Bound lowerBound(const fiacre::Interval& interval);
[[nodiscard]] Bound upperBound(const fiacre::Interval& interval);
/// The upper bound of a clock as long as its transition cannot fire yet.
[[nodiscard]] Bound notYet(const fiacre::Interval& interval);

} // namespace proskill::verify
