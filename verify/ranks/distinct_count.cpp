#include "verify/ranks/distinct_count.h"

#include <array>
#include <functional>

namespace proskill::verify {

namespace {

constexpr std::size_t kLongestItem = std::size_t{1} << 30; // bytes

} // namespace

DistinctCount::DistinctCount(Ranks& over)
    : ranks(over), exchange(over, [this](unsigned, CheckpointReader& records) {
        while (records.flag()) items.insert(records.text(kLongestItem));
      }) {}

void DistinctCount::add(std::string_view item) {
  const auto owner = static_cast<unsigned>(std::hash<std::string_view>()(item) % ranks.count());
  if (owner == ranks.self())
    items.emplace(item);
  else
    exchange.add(owner, [&](CheckpointWriter& to) { to.text(item); });
  exchange.receive();
}

std::uint64_t DistinctCount::total() {
  exchange.finishRound();
  std::array<std::uint64_t, 1> count{items.size()};
  ranks.sum(count);
  return count[0];
}

} // namespace proskill::verify
