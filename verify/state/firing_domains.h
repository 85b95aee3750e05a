#pragma once

#include "verify/model/system.h"
#include "verify/state/store.h"

namespace proskill::verify {

/// When the clocked transitions of a state class may fire, counted from now: bounds on their delays
/// and on the differences of these. Transitions that share a clock and an interval share a delay,
/// since nothing but the order in which they were written tells them apart. Berthomieu and Diaz,
/// "Modeling and verification of time dependent systems using time Petri nets", TSE 1991.
class FiringDomains {
public:
  explicit FiringDomains(const System& system);

  /// What a discrete state says about time, as a number. \param enabled clocked transitions,
  /// ascending
  [[nodiscard]] std::uint32_t signature(bool urgent, const std::vector<TransitionId>& enabled);
  [[nodiscard]] ZoneId initial(std::uint32_t signature);
  /// The domain after firing; kNone where the transition cannot fire first.
  [[nodiscard]] ZoneId after(ZoneId domain, std::uint32_t before, TransitionId transition,
                             std::uint32_t after) {
    return memo.get({domain, before, transition, after},
                    [&] { return calculate(domain, before, transition, after); });
  }
  [[nodiscard]] std::uint64_t bytes() const { return store.bytes() + memo.bytes(); }

private:
  using Delay = std::uint32_t;
  struct Signature {
    bool urgent = false;
    std::vector<Delay> delays; ///< ascending: the matrix has them in this order
  };

  ZoneId calculate(ZoneId domain, std::uint32_t before, TransitionId transition,
                   std::uint32_t after);
  /// Makes the moment at which the transition fires the new zero. False where it cannot.
  bool fire(Dbm& domain, const Signature& signature, TransitionId transition);
  ZoneId enter(const Dbm& from, const std::vector<std::uint32_t>& kept, const Signature& signature);

  const System& system;
  std::vector<Delay> delayOf;       ///< by transition
  std::vector<TransitionId> delays; ///< one transition of each
  std::vector<Signature> signatures;
  NumberTable table;
  ZoneStore store;
  Memo memo;
};

} // namespace proskill::verify
