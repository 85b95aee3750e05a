#include "verify/graph/domain_images.h"

namespace proskill::verify {

DomainImages::Image DomainImages::of(SetId set, const Firing& by) {
  if (set == NumberSets::kEmpty) return {};
  const Memo::Key key{set, by.before, by.transition, by.after};
  if (const Image* known = recent.find(key)) return *known;
  const Image made = compute(set, by);
  recent.fit(all.end());
  recent.put(key, made);
  return made;
}

DomainImages::Image DomainImages::compute(SetId set, const Firing& by) {
  Image made;
  if (!all.isLeaf(set)) {
    const auto [left, right] = all.partsOf(set);
    const Image one = of(left, by);
    const Image other = of(right, by);
    return {all.unite(one.domains, other.domains), one.fired + other.fired};
  }
  all.eachIn(set, [&](ZoneId domain) {
    const ZoneId after = firing.after(domain, by.before, by.transition, by.after);
    if (after == kNone) return;
    made.domains = all.unite(made.domains, all.single(after));
    ++made.fired;
  });
  return made;
}

} // namespace proskill::verify
