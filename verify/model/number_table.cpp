#include "verify/model/number_table.h"

#include <algorithm>
#include <utility>

namespace proskill::verify {

void NumberTable::grow() {
  const auto old = std::exchange(slots, LargeVector<Slot>(slots.size() * 2));
  for (const auto& slot : old) {
    if (slot.number == kNone) continue;
    std::size_t at = placeOf(slot.tag);
    while (slots[at].number != kNone)
      if (++at == slots.size()) at = 0;
    slots[at] = slot;
  }
}

} // namespace proskill::verify
