#include "verify/space/root_table.h"

#include <catch2/catch.hpp>
#include <map>
#include <random>
#include <utility>

namespace proskill::verify::root_table_test {

namespace {

constexpr StateId kStored = RootTable::kStored;

/// How many roots are tried, and how great their numbers get. The more of all pairs are roots, the
/// sooner a matrix is smaller than a table.
struct Shape {
  std::uint32_t roots = 0;
  std::uint32_t left = 0;
  std::uint32_t right = 0;
};

constexpr Shape kDense{60'000, 250, 250};
constexpr Shape kSparse{20'000, 1'000'000, 1'000'000};
constexpr Shape kLong{50'000, 2, 40'000};

/// A table beside a map that says what it must hold.
class Pair {
public:
  explicit Pair(const Shape& size, std::uint64_t seed) : shape(size), random(seed) {}

  /// Numbers get greater with time, as those of states that are found.
  SoughtRoot next() {
    const auto upTo = [this](std::uint32_t most) {
      const std::uint64_t reached = 1 + std::uint64_t{most} * ++tried / shape.roots / 4;
      return static_cast<std::uint32_t>(random() % std::min<std::uint64_t>(most, reached));
    };
    const std::uint32_t left = upTo(shape.left);
    return SoughtRoot({left, upTo(shape.right)});
  }

  /// Adds a root in one of the ways that searches have.
  void add(const SoughtRoot& root) {
    const auto known = numbers.find({root.root.left, root.root.right});
    const bool isNew = known == numbers.end();
    const auto added = table.add(root);
    REQUIRE(added.isNew == isNew);
    note(root, added.id);
  }

  /// Claims some roots as threads do, settles most of them, and adds others meanwhile.
  void claim() {
    if (table.prepareClaims(64)) {
      table.startGrowth();
      for (std::size_t part = 0; part < 3; ++part) table.refill(part, 3);
    }
    RootTable::Allotment own;
    std::map<std::pair<std::uint32_t, std::uint32_t>, RootTable::ClaimId> claims;
    for (int i = 0; i < 100; ++i) {
      const SoughtRoot root = next();
      const auto key = std::pair(root.root.left, root.root.right);
      const auto found = table.findOrClaim(root, 7, own);
      if (numbers.contains(key)) {
        REQUIRE((found.id == kStored || found.id == numbers[key]));
        continue;
      }
      REQUIRE(found.id == kNone);
      if (found.claim == kNone) continue; // none are left
      REQUIRE(found.isNew == !claims.contains(key));
      if (!found.isNew) {
        REQUIRE(found.claim == claims[key]);
        REQUIRE(found.claimant == 7);
      }
      claims[key] = found.claim;
    }
    for (const auto& [key, claim] : claims) {
      const SoughtRoot root({key.first, key.second});
      if (random() % 8 == 0) continue; // nobody needs its number
      if (random() % 8 == 0)
        add(root);
      else
        note(root, table.settle(claim).id);
      if (random() % 4 == 0) add(next());
    }
  }

  void check(bool areNumbersKnown) const {
    REQUIRE(table.size() == numbers.size());
    for (const auto& [key, number] : numbers) {
      const SoughtRoot root({key.first, key.second});
      const StateId found = table.find(root);
      REQUIRE((found == number || (!areNumbersKnown && found == kStored)));
      REQUIRE(table.at(number) == root.root);
      const SoughtRoot other({key.first, key.second + shape.right});
      REQUIRE(table.find(other) == kNone);
    }
  }

  RootTable table;

private:
  void note(const SoughtRoot& root, StateId id) {
    const auto [known, isNew] = numbers.try_emplace({root.root.left, root.root.right}, id);
    REQUIRE((id == known->second || id == kStored));
    if (isNew) REQUIRE(id == numbers.size() - 1);
  }

  Shape shape;
  std::mt19937_64 random;
  std::uint32_t tried = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, StateId> numbers;
};

/// Adds as many roots as the shape says, one by one and by claims.
void fill(Pair& pair, const Shape& shape) {
  for (std::uint32_t i = 0; i < shape.roots; i += 200) {
    for (int k = 0; k < 100; ++k) pair.add(pair.next());
    pair.claim();
  }
}

} // namespace

TEST_CASE(
    "a table of roots has the numbers that were given, and without them knows what it stores") {
  for (const Shape& shape : {kDense, kSparse, kLong}) {
    Pair with(shape, 1);
    fill(with, shape);
    with.check(true);

    Pair without(shape, 1);
    without.table.forgetNumbers();
    fill(without, shape);
    without.check(false);
    without.table.learnNumbers();
    without.check(true);
    fill(without, shape);
    without.check(true);
  }
}

TEST_CASE("where many pairs of numbers are roots, a table without numbers takes half the memory") {
  RootTable with;
  RootTable without;
  without.forgetNumbers();
  for (std::uint32_t sum = 0; sum < 1000; ++sum)
    for (std::uint32_t left = sum < 500 ? 0 : sum - 499; left <= std::min(sum, 499U); ++left) {
      const SoughtRoot root({left, sum - left});
      const auto expected = without.bytes() + without.growth();
      REQUIRE(with.add(root).isNew);
      REQUIRE(without.add(root).isNew);
      REQUIRE(without.bytes() <= expected + 4096);
    }
  CHECK(without.size() == 500 * 500);
  CHECK(without.bytes() * 2 < with.bytes());
}

} // namespace proskill::verify::root_table_test
