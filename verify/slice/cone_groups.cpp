#include "verify/slice/cone_groups.h"

#include <algorithm>
#include <utility>

namespace proskill::verify {

namespace {

bool isExploredWith(const Bits& cone, const Bits& larger) {
  return cone.isWithin(larger) && (cone.empty() || cone.count() * 2 > larger.count());
}

} // namespace

std::vector<ConeGroup> joined(std::vector<ConeGroup> groups) {
  std::ranges::stable_sort(groups, std::greater{},
                           [](const ConeGroup& it) { return it.cone.count(); });
  std::vector<ConeGroup> made;
  for (auto& one : groups) {
    const auto larger = std::ranges::find_if(
        made, [&](const ConeGroup& group) { return isExploredWith(one.cone, group.cone); });
    if (larger == made.end())
      made.push_back(std::move(one));
    else
      larger->goals.insert(larger->goals.end(), one.goals.begin(), one.goals.end());
  }
  return made;
}

} // namespace proskill::verify
