#pragma once

#include "verify/model/dbm.h"
#include "verify/model/system.h"
#include "verify/state/store.h"
#include "verify/state/transition_set.h"

#include <utility>

namespace proskill::verify {

using SignatureId = std::uint32_t;

/// The timing constraints of a discrete state: whether time may pass, and which clocked transitions
/// are enabled.
struct Signature {
  bool urgent = false;
  std::vector<TransitionId> enabled; ///< clocked ones, ascending
  std::vector<ClockId> clocks; ///< of these transitions, ascending; this is the order of the matrix
  std::vector<Bound> invariants;   ///< by clock: upper bound until which time may pass
  std::vector<std::int32_t> lower; ///< by index in the matrix: for Dbm::extrapolate
  std::vector<std::int32_t> upper;
};

enum class Extrapolation : std::uint8_t {
  LowerUpper, ///< Extra+LU
  Maximum, ///< Extra+M: as LowerUpper with the greater of both constants; exact up to bisimulation
  Least,   ///< abstracts only unbounded clocks, as needed for a finite graph
};

/// Computes the zones of a system: the initial one and the successors. Zones include the passing of
/// time.
class Timing {
public:
  Timing(const System& of, Extrapolation how) : system(of), extrapolation(how) {}

  /// From now on, operations on many clocks call this between their parts.
  void callBetween(Between check) { between = std::move(check); }
  /// \param clocked the transitions with clocks; only these are read from `enabled`
  [[nodiscard]] SignatureId signature(bool urgent, const TransitionSet& enabled,
                                      const TransitionSet& clocked);
  [[nodiscard]] const Signature& at(SignatureId id) const { return signatures[id]; }
  /// The initial zone: all clocks are 0, then time passes. May throw as callBetween() says
  [[nodiscard]] ZoneId initial(SignatureId signature);
  /// The successor of a zone of `before` by `transition`, as a zone of `after`; kNone if timing
  /// forbids the transition. May throw as callBetween() says
  [[nodiscard]] ZoneId after(ZoneId zone, SignatureId before, TransitionId transition,
                             SignatureId after);
  /// Whether the transition can fire from some point of the zone. \pre the discrete state enables
  /// it
  [[nodiscard]] bool isFirable(ZoneId zone, SignatureId signature, TransitionId transition) const;
  /// Restricts a zone to the points where the transition can fire: its interval allows it and no
  /// transition with priority is ready. Returns false if the zone becomes empty.
  [[nodiscard]] bool allow(Dbm& zone, SignatureId signature, TransitionId transition) const;
  /// The clocks of `before` that keep running as clocks of `after`, as argument of Dbm::over.
  [[nodiscard]] std::vector<std::uint32_t> kept(SignatureId before, TransitionId transition,
                                                SignatureId after) const;
  /// The number here of a signature or a zone of another Timing of the same system.
  [[nodiscard]] SignatureId adopt(const Timing& from, SignatureId id);
  [[nodiscard]] ZoneId adopt(const ZoneStore& from, ZoneId id) { return store.add(from.zone(id)); }
  [[nodiscard]] ZoneId adopt(const Dbm& zone) { return store.add(zone); }
  /// Removes all zones and signatures. \pre nobody needs their numbers
  void forget();
  /// Bytes of the signatures, which bytes() does not count.
  [[nodiscard]] std::uint64_t signatureBytes() const { return ofSignatures + table.bytes(); }
  [[nodiscard]] std::uint32_t signatureCount() const {
    return static_cast<std::uint32_t>(signatures.size());
  }
  /// The transitions with clocks of a signature, as a set.
  [[nodiscard]] const TransitionSet& enabledSet(SignatureId id) const { return sets[id]; }
  [[nodiscard]] const ZoneStore& zones() const { return store; }
  [[nodiscard]] std::uint64_t bytes() const { return store.bytes() + memo.bytes(); }
  [[nodiscard]] std::uint64_t growth() const { return store.growth() + memo.growth(); }

private:
  void findKept(SignatureId before, TransitionId transition, SignatureId after,
                std::vector<std::uint32_t>& from) const;
  ZoneId calculate(ZoneId zone, SignatureId before, TransitionId transition, SignatureId after);
  ZoneId settle(Dbm zone, const Signature& signature);

  const System& system;
  Extrapolation extrapolation;
  std::vector<Signature> signatures;
  std::vector<TransitionSet> sets; ///< by signature
  std::uint64_t ofSignatures = 0;  ///< bytes of both
  NumberTable table;
  ZoneStore store;
  Memo memo;
  Between between;
  std::vector<std::uint32_t> carried; ///< of a zone that is calculated: see kept()
};

/// Whether firing `transition` resets a clock that is needed afterwards.
[[nodiscard]] bool resets(const System& system, TransitionId transition, ClockId clock);

/// The bounds of a transition's clock when it fires: `lowerBound` limits 0 - x, `upperBound` limits
/// x - 0.
[[nodiscard]] Bound lowerBound(const fiacre::Interval& interval);
[[nodiscard]] Bound upperBound(const fiacre::Interval& interval);
/// The upper bound of a clock while its transition cannot fire yet.
[[nodiscard]] Bound notYet(const fiacre::Interval& interval);

} // namespace proskill::verify
