#include "verify/limits.h"
#include "verify/memory/large_vector.h"
#include "verify/space/column.h"
#include "verify/space/parents.h"
#include "verify/space/roots.h"
#include "verify/space/state_tree.h"
#include "verify/space/zone_graph.h"

#include <catch2/catch.hpp>

#include <map>
#include <random>

using namespace proskill::verify;

namespace {

/// States of some words, most of which are similar.
std::vector<std::vector<Word>> randomStates(std::uint32_t words, std::size_t count, Word most) {
  std::mt19937_64 random(words);
  std::vector<std::vector<Word>> states{std::vector<Word>(words)};
  while (states.size() < count) {
    auto state = states[random() % states.size()];
    state[random() % words] = random() % (most + 1);
    states.push_back(state);
  }
  return states;
}

/// A zone of one clock, with a bound that no other number gives.
Dbm zoneOf(std::int32_t number) {
  Dbm zone(1);
  zone.up();
  REQUIRE(zone.constrain(1, 0, bound(number, false)));
  return zone;
}

} // namespace

TEST_CASE("a column keeps numbers of all sizes, and zeros take no memory") {
  std::mt19937 random(1);
  const auto below = [&](std::uint32_t most) {
    return std::uniform_int_distribution<std::uint32_t>(0, most)(random);
  };
  Column column;
  std::vector<std::uint32_t> expected;
  const auto pushMany = [&](std::uint32_t most) {
    for (int i = 0; i < 10'000; ++i) {
      const std::uint32_t number = below(most);
      column.push(number);
      expected.push_back(number);
    }
  };
  pushMany(0);
  CHECK(column.bytes() == 0);
  for (const std::uint32_t most : {1U << 7, 0U, 1U << 16, 1U << 24, UINT32_MAX}) {
    pushMany(most);
    const std::size_t at = below(static_cast<std::uint32_t>(expected.size() - 1));
    expected[at] = most;
    column.set(at, most);
    REQUIRE(column.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) REQUIRE(column.at(i) == expected[i]);
  }
  CHECK(column.bytes() < expected.size() * 5);
}

TEST_CASE("a column takes as many bits for a number as the greatest needs") {
  for (int width = 1; width <= 32; ++width) {
    const std::uint32_t most = static_cast<std::uint32_t>((std::uint64_t{1} << width) - 1);
    Column column;
    for (std::uint32_t i = 0; i < 10'000; ++i) column.push(i % 3 == 0 ? most : most / 2);
    column.set(4095, most); // the last of a piece
    column.set(4096, 0);
    CHECK(column.at(4095) == most);
    CHECK(column.at(4096) == 0);
    for (std::uint32_t i = 0; i < 10'000; ++i)
      if (i < 4095 || i > 4096) REQUIRE(column.at(i) == (i % 3 == 0 ? most : most / 2));
    CHECK(column.bytes() < 3 * (4096 * static_cast<std::uint64_t>(width) / 8 + 32));
  }
}

TEST_CASE("rows of up to 64 bits keep theirs when bits are inserted") {
  std::mt19937_64 random(2);
  const auto numberBelow = [&](std::uint32_t most) {
    return static_cast<std::uint32_t>(random() % most);
  };
  for (std::uint32_t width = 1; width <= 64; ++width) {
    const std::uint32_t below = numberBelow(width);
    const std::uint32_t more = numberBelow(65 - width);
    PackedRows rows;
    rows.widen(0, width);
    std::vector<std::uint64_t> expected;
    for (int i = 0; i < 5'000; ++i) {
      expected.push_back(random() & PackedRows::maskOf(width));
      rows.push(expected.back());
    }
    for (std::size_t i = 0; i < expected.size(); i += 3) rows.set(i, expected[i] = 0);
    for (std::size_t i = 0; i < expected.size(); ++i) REQUIRE(rows.at(i) == expected[i]);
    if (more > 0) rows.widen(below, more);
    REQUIRE(rows.rowWidth() == width + more);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const std::uint64_t lowest = expected[i] & PackedRows::maskOf(below);
      const std::uint64_t above = expected[i] >> below;
      const std::uint64_t row = rows.at(i);
      REQUIRE((row & PackedRows::maskOf(below)) == lowest);
      REQUIRE((row >> below & PackedRows::maskOf(more)) == 0);
      if (below + more < 64) REQUIRE(row >> (below + more) == above);
    }
  }
}

TEST_CASE("roots keep both numbers, however these grow") {
  std::mt19937 random(3);
  const auto numberOf = [&](std::uint32_t bits) {
    return static_cast<std::uint32_t>(random() & PackedRows::maskOf(bits));
  };
  Roots roots;
  std::vector<Root> expected;
  for (std::uint32_t bits = 0; bits <= 32; ++bits)
    for (int i = 0; i < 300; ++i) {
      expected.push_back({numberOf(bits), numberOf(bits < 16 ? bits : 2 * bits - 32)});
      roots.push(expected.back());
    }
  for (std::size_t i = 0; i < expected.size(); ++i) REQUIRE(roots.at(i) == expected[i]);
}

TEST_CASE("a column of millions of numbers grows and widens as a small one") {
  constexpr std::uint32_t kCount = 9'000'000; // more than its small blocks have
  const auto numberAt = [](std::uint32_t i) { return i * 2'654'435'761U >> 15; };
  Column column;
  std::uint64_t foreseen = column.growth();
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const std::uint64_t before = column.bytes();
    column.push(numberAt(i));
    if (i % 4096 != 0 && i > 4096) REQUIRE(column.bytes() == before);
    if (i > 4096) // the lists of pieces grow, too
      REQUIRE(column.bytes() <= before + foreseen + before / 64 + 4096);
    if (i % 4096 == 4095) foreseen = column.growth();
  }
  for (std::uint32_t i = 0; i < kCount; i += 7) REQUIRE(column.at(i) == numberAt(i));
  column.set(kCount - 1, 1U << 24); // all get wider
  for (std::uint32_t i = 0; i + 1 < kCount; i += 7) REQUIRE(column.at(i) == numberAt(i));
  CHECK(column.at(kCount - 1) == 1U << 24);
  CHECK(column.bytes() < std::uint64_t{kCount} * 25 / 8 + 2 * kLargeTable);
}

TEST_CASE("a large vector is in pages of its own, which are given back") {
  LargeVector<std::uint32_t> some(kLargeTable / sizeof(std::uint32_t), 1);
  CHECK(reinterpret_cast<std::uintptr_t>(some.data()) % kLargePage == 0); // NOLINT
  for (std::uint32_t i = 0; i < 10'000'000; ++i) some.push_back(i);
  CHECK(some.at(kLargeTable / sizeof(std::uint32_t)) == 0);
  CHECK(some.back() == 9'999'999);
  const auto with = residentBytes();
  LargeVector<std::uint32_t>().swap(some);
  if (with > 0) CHECK(residentBytes() + 38'000'000 < with);
}

TEST_CASE("what a vector will take soon is the larger vector, or its next large page") {
  constexpr std::size_t kPerPage = kLargePage / sizeof(std::uint32_t);
  LargeVector<std::uint32_t> all;
  all.reserve(4 * kPerPage);
  all.resize(kPerPage - kBetweenGrowthChecks);
  CHECK(growthOf(all) == 0);
  all.push_back(0);
  CHECK(growthOf(all) == kLargePage);
  all.resize(4 * kPerPage - kBetweenGrowthChecks);
  CHECK(growthOf(all) == 4 * kLargePage);
  LargeVector<std::uint32_t> few;
  few.reserve(3 * kBetweenGrowthChecks);
  CHECK(growthOf(few) == 0);
  few.resize(2 * kBetweenGrowthChecks);
  CHECK(growthOf(few) == few.capacity() * sizeof(std::uint32_t));
}

TEST_CASE("parents are found in any order of expansion") {
  for (const bool inOrder : {true, false}) {
    std::mt19937 random(2);
    Parents parents;
    std::vector<std::uint32_t> expected{UINT32_MAX};
    std::vector<std::uint32_t> open{0};
    parents.addChild();
    while (!open.empty() && expected.size() < 20'000) {
      const std::size_t at = inOrder ? 0 : random() % open.size();
      const std::uint32_t node = open[at];
      open.erase(open.begin() + static_cast<std::ptrdiff_t>(at));
      parents.expand(node);
      for (auto children = open.empty() ? 3 : random() % 4; children > 0; --children) {
        parents.addChild();
        open.push_back(static_cast<std::uint32_t>(expected.size()));
        expected.push_back(node);
      }
    }
    for (std::uint32_t i = 0; i < expected.size(); ++i) REQUIRE(parents.of(i) == expected[i]);
    CHECK(parents.bytes() < expected.size() * (inOrder ? 1 : 9));
  }
}

TEST_CASE("a tree of states gives each state one number, and the state back") {
  for (const std::uint32_t words : {1U, 2U, 3U, 5U, 8U, 67U}) {
    const std::uint32_t bits = words == 1 ? 20 : 64;
    const auto states = randomStates(words, 30'000, words == 1 ? (1U << 20) - 1 : 300);
    StateTree tree(words, bits);
    StateTree::Path path;
    std::map<std::vector<Word>, StateId> expected;
    for (const auto& state : states) {
      const auto [known, isNew] = expected.try_emplace(state, tree.size());
      const auto root = tree.findRoot(state.data(), path);
      REQUIRE((root && tree.find(*root) != kNone) == !isNew);
      const auto added = tree.add(state.data());
      REQUIRE(added.isNew == isNew);
      REQUIRE(added.id == known->second);
    }
    CHECK(tree.size() == expected.size());
    std::vector<Word> read(words);
    for (const auto& [state, id] : expected) {
      tree.read(id, read.data());
      REQUIRE(read == state);
    }
  }
}

TEST_CASE("states whose halves repeat take few bytes") {
  StateTree tree(1, 42);
  for (Word high = 0; high < 1000; ++high)
    for (Word low = 0; low < 1000; ++low) {
      const Word state = high * 2097 << 21 | low * 2097;
      tree.add(&state);
    }
  CHECK(tree.size() == 1'000'000);
  CHECK(tree.bytes() < 11'000'000);
}

TEST_CASE("a state has the zones that were added to it, few or many, and no others") {
  const System system;
  ZoneGraph graph(system, {}, Extrapolation::Maximum);
  std::map<StateId, std::int32_t> countOf{{0, 40}, {1, 3}, {2, 17}};
  const auto hasZone = [&](StateId state, std::int32_t number) {
    return graph.covers(state, zoneOf(number).matrix(), false);
  };
  for (std::size_t i = 0; i < countOf.size(); ++i) graph.addState(0);
  for (std::int32_t i = 0; i < 40; ++i)
    for (const auto& [state, count] : countOf)
      if (i < count) graph.addNode(state, graph.timing.adopt(zoneOf(i)), kNone, false);
  for (const auto& [state, count] : countOf)
    for (std::int32_t i = 0; i < 45; ++i) CHECK(hasZone(state, i) == (i < count));
}
