#include "verify/guide/novelty.h"
#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

#include <catch2/catch.hpp>

#include <tuple>

namespace proskill::test::novelty_test {

namespace {

using verify::Novelty;

/// The layout of a system that may write each of its cells.
verify::System laidOut(verify::System system) {
  auto& path = system.paths.emplace_back();
  for (verify::CellId i = 0; i < system.cells.size(); ++i) path.writes.insert(i);
  if (system.instances.empty()) system.instances.emplace_back();
  return verify::withStateLayout(std::move(system));
}

/// A system of two cells with the values 0 to 3.
verify::System twoCells() {
  verify::System system;
  for (const auto* name : {"x", "y"}) system.cells.push_back({.name = name, .high = 3});
  return laidOut(std::move(system));
}

class Seen {
public:
  Seen() : system(twoCells()), novelty(system) {}

  Novelty::Degree pair(std::int64_t x, std::int64_t y) { return novelty.seePair(state(x, y)); }
  Novelty::Degree value(std::int64_t x, std::int64_t y, std::uint32_t group) {
    return novelty.seeValue(state(x, y), group);
  }
  void expand(std::int64_t x, std::int64_t y) { novelty.expand(state(x, y)); }

private:
  const verify::Word* state(std::int64_t x, std::int64_t y) {
    words.assign(system.words, 0);
    verify::writeCell(system, 0, x, words.data());
    verify::writeCell(system, 1, y, words.data());
    return words.data();
  }

  verify::System system;
  Novelty novelty;
  std::vector<verify::Word> words;
};

} // namespace

TEST_CASE("a state is new by a value or by a pair of values, or its pairs were seen before") {
  Seen seen;
  CHECK(seen.pair(0, 0) == Novelty::Degree::Value);
  seen.expand(0, 0);
  CHECK(seen.pair(1, 0) == Novelty::Degree::Value);
  CHECK(seen.pair(0, 1) == Novelty::Degree::Value);
  seen.expand(1, 0);
  CHECK(seen.pair(1, 1) == Novelty::Degree::Pair);
  CHECK(seen.pair(1, 1) == Novelty::Degree::Pair + 1);
}

TEST_CASE("a pair that was seen rarely is newer than one that was seen often") {
  Seen seen;
  for (int i = 0; i < 100; ++i) std::ignore = seen.pair(0, 0);
  for (int i = 0; i < 10; ++i) std::ignore = seen.pair(1, 1);
  seen.expand(0, 1);
  const auto often = seen.pair(0, 0);
  const auto rarely = seen.pair(1, 1);
  CHECK(rarely > Novelty::Degree::Pair);
  CHECK(rarely < often);
  CHECK(often < Novelty::Degree::None);
  CHECK(seen.pair(0, 1) == Novelty::Degree::None); // the same as before
}

TEST_CASE("the location of a long mission counts, a wide number does not") {
  constexpr std::int64_t kLast = 9'999;
  verify::System system;
  for (const auto* name : {"location", "number", "flag"})
    system.cells.push_back({.name = name, .high = kLast});
  system.cells[2].high = 1;
  system.instances.push_back({.name = "mission", .location = 0});
  system = laidOut(std::move(system));
  Novelty novelty(system);
  const auto degreeOf = [&](std::int64_t location, std::int64_t number, std::int64_t flag) {
    std::vector<verify::Word> words(system.words);
    verify::writeCell(system, 0, location, words.data());
    verify::writeCell(system, 1, number, words.data());
    verify::writeCell(system, 2, flag, words.data());
    return novelty.seePair(words.data());
  };
  CHECK(degreeOf(0, 0, 0) == Novelty::Degree::Value);
  CHECK(degreeOf(kLast, 0, 0) == Novelty::Degree::Value);
  CHECK(degreeOf(0, 0, 1) == Novelty::Degree::Value);
  CHECK(degreeOf(kLast, 0, 1) == Novelty::Degree::Pair);
  CHECK(degreeOf(kLast, kLast, 1) == Novelty::Degree::Pair + 1);
}

TEST_CASE("values are new in each group of states") {
  Seen seen;
  CHECK(seen.value(1, 2, 0) == Novelty::Degree::Value);
  CHECK(seen.value(2, 1, 0) == Novelty::Degree::Value);
  CHECK(seen.value(1, 1, 0) == Novelty::Degree::None);
  CHECK(seen.value(1, 1, 1) == Novelty::Degree::Value);
}

} // namespace proskill::test::novelty_test
