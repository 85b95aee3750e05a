#include "verify/space/parents.h"

#include <algorithm>
#include <numeric>

namespace proskill::verify {

void Parents::append(bool bit) {
  if (length % 64 == 0) {
    if (bits.size() % kWordsOfBlock == 0) zerosBefore.push_back(zeros);
    bits.push_back(0);
  }
  bits.back() |= std::uint64_t{bit} << length % 64;
  ++length;
}

void Parents::expand(std::uint32_t node) {
  if (order.empty() && node != expansions) {
    order.resize(expansions);
    std::iota(order.begin(), order.end(), 0U);
  }
  if (!order.empty() || node != expansions) order.push_back(node);
  ++expansions;
  append(true);
}

void Parents::addChild() {
  append(false);
  ++zeros;
}

std::uint32_t Parents::of(std::uint32_t child) const {
  // the bit of the child is the 0 with `child` others before it
  const auto block = std::ranges::upper_bound(zerosBefore, std::uint64_t{child}) - 1;
  std::uint64_t left = child - *block;
  auto word = static_cast<std::uint64_t>(block - zerosBefore.begin()) * kWordsOfBlock;
  for (;; ++word) {
    const auto zerosHere = static_cast<std::uint64_t>(std::popcount(~bits[word]));
    if (left < zerosHere) break;
    left -= zerosHere;
  }
  std::uint64_t rest = ~bits[word];
  for (; left > 0; --left) rest &= rest - 1;
  const std::uint64_t at = word * 64 + static_cast<std::uint64_t>(std::countr_zero(rest));
  const std::uint64_t expanded = at - child; // the number of 1s before it
  if (expanded == 0) return UINT32_MAX;
  return order.empty() ? static_cast<std::uint32_t>(expanded - 1) : order[expanded - 1];
}

} // namespace proskill::verify
