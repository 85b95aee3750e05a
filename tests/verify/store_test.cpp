#include "verify/model/release.h"
#include "verify/state/store.h"

#include <catch2/catch.hpp>

#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

using namespace proskill::verify;

TEST_CASE("A store of states gives each state one number, for ever") {
  std::mt19937 random(1);
  std::uniform_int_distribution<Word> word(0, 40);
  StateStore store(2);
  std::map<std::pair<Word, Word>, StateId> expected;
  for (int i = 0; i < 20'000; ++i) {
    const Word state[2] = {word(random) << 50, word(random)};
    auto [known, isNew] = expected.try_emplace({state[0], state[1]}, store.size());
    auto added = store.add(state);
    REQUIRE(added.isNew == isNew);
    REQUIRE(added.id == known->second);
  }
  CHECK(store.size() == expected.size());
  for (const auto& [state, id] : expected) {
    CHECK(store.at(id)[0] == state.first);
    CHECK(store.at(id)[1] == state.second);
  }
  CHECK(store.bytes() >= expected.size() * 2 * sizeof(Word));
}

TEST_CASE("A store of zones tells zones of different dimension apart") {
  ZoneStore store;
  const ZoneId none = store.add(Dbm(0));
  const ZoneId one = store.add(Dbm(1));
  CHECK(none != one);
  CHECK(store.add(Dbm(1)) == one);
  Dbm later(1);
  later.up();
  const ZoneId moved = store.add(later);
  CHECK(moved != one);
  CHECK(store.at(moved, 1, 0) == kInfinite);
  CHECK(store.zone(moved).dimension() == 2);
  CHECK(store.size() == 3);
  CHECK(store.find(later.matrix()) == moved);
  CHECK(store.find(Dbm(0).matrix()) == none);
  CHECK(store.find(Dbm(2).matrix()) == kNone);
}

TEST_CASE("A memo calls its function once for each key") {
  Memo memo;
  int calls = 0;
  const auto ask = [&](std::uint32_t a, std::uint32_t d) {
    return memo.get({a, 2, 3, d}, [&] {
      ++calls;
      return a + d;
    });
  };
  for (int round = 0; round < 2; ++round)
    for (std::uint32_t a = 0; a < 100; ++a) CHECK(ask(a, 100 - a) == 100);
  CHECK(calls == 100);
}

TEST_CASE("Nothing is kept of a computation that ends early") {
  Memo memo;
  const Memo::Key key{1, 2, 3, 4};
  CHECK_THROWS_AS(memo.get(key, []() -> std::uint32_t { throw std::runtime_error("early"); }),
                  std::runtime_error);
  CHECK(memo.get(key, [] { return 5U; }) == 5);
  CHECK(memo.get(key, [] { return 6U; }) == 5);
}

TEST_CASE("Large zones announce before the next one how much memory is added") {
  constexpr std::uint64_t kSmall = 100'000; // bytes of the other tables
  ZoneStore store;
  int growths = 0;
  for (Bound i = 1; i <= 40; ++i) {
    Dbm zone(300);
    zone.up();
    zone.constrain(1, 0, 2 * i);
    const auto announced = store.growth();
    const auto before = store.bytes();
    store.add(zone);
    if (i == 1 || store.bytes() - before < kSmall) continue;
    CHECK(announced + kSmall >= store.bytes() - before);
    ++growths;
  }
  CHECK(store.size() == 40);
  CHECK(growths > 3);
}

TEST_CASE("A container that is released has no memory left") {
  std::vector<int> numbers(1000);
  release(numbers);
  CHECK(numbers.capacity() == 0);
  std::string text(1000, 'x');
  release(text);
  CHECK(text.capacity() == std::string().capacity());
}

TEST_CASE("A set of numbers grows as needed") {
  Bits set;
  CHECK(set.empty());
  set.insert(3);
  set.insert(200);
  CHECK(set.contains(200));
  CHECK_FALSE(set.contains(199));
  CHECK(set.count() == 2);
  Bits three;
  three.insert(3);
  CHECK(set.meets(three));
  set.erase(200);
  CHECK(set == three);
  set -= three;
  CHECK(set.empty());
  CHECK_FALSE(set.meets(three));
}
