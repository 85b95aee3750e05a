#pragma once

#include "verify/graph/number_sets.h"
#include "verify/graph/recent_results.h"
#include "verify/state/firing_domains.h"

namespace proskill::verify {

/// Fires transitions from sets of firing domains.
class DomainImages {
public:
  /// A transition between two markings, of which the signatures are known.
  struct Firing {
    std::uint32_t before = 0;
    TransitionId transition = 0;
    std::uint32_t after = 0;
  };
  struct Image {
    SetId domains = NumberSets::kEmpty;
    std::uint32_t fired = 0; ///< number of the domains from which the transition can fire
  };

  /// \pre the arguments outlive this
  DomainImages(FiringDomains& domains, NumberSets& sets) : firing(domains), all(sets) {}

  [[nodiscard]] Image of(SetId set, const Firing& by);
  /// Forgets what is known of sets, after their ids have changed.
  void forget() { recent.clear(); }
  [[nodiscard]] std::uint64_t bytes() const { return recent.bytes(); }
  [[nodiscard]] std::uint64_t growth() const { return recent.growth(all.end()); }

private:
  [[nodiscard]] Image compute(SetId set, const Firing& by);

  FiringDomains& firing;
  NumberSets& all;
  RecentResults<Image> recent;
};

} // namespace proskill::verify
