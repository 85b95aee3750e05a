#include "verify/graph/number_sets.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <iterator>
#include <map>
#include <random>
#include <set>

using namespace proskill::verify;

namespace {

using Plain = std::set<std::uint32_t>;

SetId made(NumberSets& sets, const Plain& numbers) {
  SetId all = NumberSets::kEmpty;
  for (auto number : numbers) all = sets.unite(all, sets.single(number));
  return all;
}

Plain plain(const NumberSets& sets, SetId set) {
  std::vector<std::uint32_t> all;
  sets.eachIn(set, [&](std::uint32_t number) { all.push_back(number); });
  REQUIRE(std::ranges::is_sorted(all));
  REQUIRE(all.size() == sets.sizeOf(set));
  return {all.begin(), all.end()};
}

/// Numbers of all sizes, many of them close to each other.
Plain randomNumbers(std::mt19937& random) {
  const auto some = [&] { return static_cast<std::uint32_t>(random()) >> random() % 32; };
  const auto few = [&] { return static_cast<std::uint32_t>(random() % 200); };
  Plain numbers;
  const auto count = random() % 12;
  const std::uint32_t first = some();
  while (numbers.size() < count) numbers.insert(random() % 2 == 0 ? first + few() : some());
  return numbers;
}

} // namespace

TEST_CASE("sets of numbers are united and subtracted as plain sets are") {
  std::mt19937 random(1);
  NumberSets sets;
  for (int i = 0; i < 3'000; ++i) {
    const Plain a = randomNumbers(random);
    Plain b = randomNumbers(random);
    if (i % 3 == 0) std::ranges::copy(a, std::inserter(b, b.end()));
    if (i % 7 == 0) b = a;
    const SetId one = made(sets, a);
    const SetId other = made(sets, b);
    REQUIRE(plain(sets, one) == a);
    REQUIRE((one == other) == (a == b));
    Plain together = a;
    together.insert(b.begin(), b.end());
    REQUIRE(plain(sets, sets.unite(one, other)) == together);
    REQUIRE(sets.unite(other, one) == made(sets, together));
    Plain rest;
    std::ranges::set_difference(a, b, std::inserter(rest, rest.end()));
    REQUIRE(sets.without(one, other) == made(sets, rest));
  }
}

TEST_CASE("sets that are needed keep their numbers when others are removed") {
  std::mt19937 random(2);
  NumberSets sets;
  std::map<SetId, Plain> kept;
  for (int round = 0; round < 4; ++round) {
    while (!sets.isCrowded()) {
      const Plain numbers = randomNumbers(random);
      const SetId set = made(sets, numbers);
      if (kept.size() < 500U * (round + 1)) kept[set] = numbers;
    }
    std::vector<bool> needed(sets.end());
    for (const auto& [set, numbers] : kept) needed[set] = true;
    const auto before = sets.end();
    const auto moved = sets.removeUnused(needed);
    REQUIRE(sets.end() < before / 2);
    std::map<SetId, Plain> now;
    for (const auto& [set, numbers] : kept) {
      REQUIRE(plain(sets, moved[set]) == numbers);
      REQUIRE(made(sets, numbers) == moved[set]);
      now[moved[set]] = numbers;
    }
    REQUIRE(now.size() == kept.size());
    kept = now;
  }
}
