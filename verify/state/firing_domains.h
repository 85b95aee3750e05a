#pragma once

#include "verify/model/release.h"
#include "verify/model/system.h"
#include "verify/state/store.h"

namespace proskill::verify {

/// Firing domains of state classes: bounds on the delays after which clocked transitions may fire,
/// counted from now, and on the differences of these delays. Transitions with a common clock and
/// the same interval share a delay, because only their order in the model distinguishes them.
/// Berthomieu and Diaz, "Modeling and verification of time dependent systems using time Petri
/// nets", TSE 1991.
class FiringDomains {
public:
  explicit FiringDomains(const System& system);

  /// A number for everything in a discrete state that affects time.
  /// \param enabled clocked transitions, ascending
  [[nodiscard]] std::uint32_t signature(bool urgent, const std::vector<TransitionId>& enabled);
  /// The number of the same signature here.
  [[nodiscard]] std::uint32_t adopt(const FiringDomains& other, std::uint32_t signature) {
    return signatureNumber(other.signatures[signature]);
  }
  [[nodiscard]] ZoneId initial(std::uint32_t signature);
  /// The domain after `transition` fires; kNone if it cannot fire first.
  [[nodiscard]] ZoneId after(ZoneId domain, std::uint32_t before, TransitionId transition,
                             std::uint32_t after) {
    return memo.get({domain, before, transition, after},
                    [&] { return calculate(domain, before, transition, after); });
  }
  [[nodiscard]] const ZoneStore& zones() const { return store; }
  /// Removes all domains and signatures. \pre nobody needs their numbers
  void forget() {
    release(signatures);
    table = {};
    store = {};
    memo = {};
  }
  /// Bytes of the signatures, which bytes() does not count.
  [[nodiscard]] std::uint64_t signatureBytes() const;
  [[nodiscard]] ZoneId adopt(const Dbm& domain) { return store.add(domain); }
  /// The dimension of the domains of a signature.
  [[nodiscard]] std::size_t dimensionOf(std::uint32_t signature) const {
    return signatures[signature].delays.size() + 1;
  }
  [[nodiscard]] std::uint64_t bytes() const { return store.bytes() + memo.bytes(); }
  [[nodiscard]] std::uint64_t growth() const { return store.growth() + memo.growth(); }

private:
  using Delay = std::uint32_t;
  struct Signature {
    bool urgent = false;
    std::vector<Delay> delays; ///< ascending; this is the order of the matrix
    friend bool operator==(const Signature&, const Signature&) = default;
  };

  [[nodiscard]] std::uint32_t signatureNumber(Signature of);
  ZoneId calculate(ZoneId domain, std::uint32_t before, TransitionId transition,
                   std::uint32_t after);
  /// Makes the moment at which the transition fires the new 0. Returns false if it cannot fire.
  bool fire(Dbm& domain, const Signature& signature, TransitionId transition);
  ZoneId enter(const Dbm& from, const std::vector<std::uint32_t>& kept, const Signature& signature);

  const System& system;
  std::vector<Delay> delayOf;       ///< by transition
  std::vector<TransitionId> delays; ///< a transition of each delay
  std::vector<Signature> signatures;
  NumberTable table;
  ZoneStore store;
  Memo memo;
};

} // namespace proskill::verify
