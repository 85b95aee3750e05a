#include "analysis/flow/domain/state.h"

#include <utility>

namespace proskill::analysis::flow {

namespace {

/// Limits: with more slots, boxes take more memory and add less precision.
constexpr std::size_t kMostSlots = 1024; ///< of all boxes of a point together

std::size_t mostFor(std::size_t slots, std::size_t most) {
  return std::clamp<std::size_t>(kMostSlots / std::max<std::size_t>(slots, 1), 1, most);
}

bool isWithin(const State& inner, const State& outer) {
  for (std::size_t i = 0; i < inner.values.size(); ++i)
    if (!inner.values[i].within(outer.values[i])) return false;
  return true;
}

/// The number of different slots, up to `limit`.
std::size_t difference(const State& a, const State& b, std::size_t limit) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.values.size() && count < limit; ++i)
    count += a.values[i] != b.values[i];
  return count;
}

} // namespace

bool Cases::add(State box, std::size_t most) {
  if (!box.reachable) return false;
  for (const State& known : boxes)
    if (isWithin(box, known)) return false;
  absorb(std::move(box), most);
  return true;
}

/// Two boxes that differ in one slot can be joined without loss.
void Cases::absorb(State box, std::size_t most) {
  for (;;) {
    std::erase_if(boxes, [&](const State& known) { return isWithin(known, box); });
    std::size_t least = box.values.size() + 1;
    std::size_t nearest = boxes.size();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      std::size_t distance = difference(boxes[i], box, least);
      if (distance < least) least = distance, nearest = i;
    }
    bool full = boxes.size() >= mostFor(box.values.size(), most);
    if (nearest == boxes.size() || (least > 1 && !full)) break;
    box.join(boxes[nearest]);
    boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(nearest));
  }
  boxes.push_back(std::move(box));
}

State Cases::hull() const {
  State all;
  for (const State& box : boxes) all.join(box);
  return all;
}

} // namespace proskill::analysis::flow
