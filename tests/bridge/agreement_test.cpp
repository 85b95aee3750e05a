#include "bridge/bt/import.h"
#include "bridge/bt/read/read.h"
#include "bridge/bt/tree/expand.h"
#include "tests/bridge/random_tree.h"
#include "tests/bridge/ticker.h"
#include "tests/bridge/verdicts.h"
#include "tests/support/memory_files.h"
#include "tests/support/random/seeds.h"

#include <catch2/catch.hpp>

#include <fmt/format.h>

using namespace proskill;
using namespace proskill::test;

namespace {

constexpr std::size_t kLimit = 3000;

void actionsOf(const bridge::bt::Node& node, std::set<std::string>& names) {
  if (node.kind == bridge::bt::Kind::Action) names.insert(node.name);
  for (const auto& child : node.children) actionsOf(child, names);
}

struct Counts {
  std::size_t exact = 0;
  std::size_t approximate = 0;
  std::size_t refused = 0;
  std::size_t tooLarge = 0;
};

void compare(std::uint64_t seed, const bridge::Leaves& leaves, Counts& counts) {
  const auto xml = randomTree(seed);
  const MemoryFiles files({{"tree.xml", xml}});
  const auto imported = bridge::bt::importTree(files, "tree.xml", leaves, {});
  if (!imported) return static_cast<void>(++counts.refused);
  const auto tree = bridge::bt::expand(*bridge::bt::read(files, "tree.xml"));
  const auto expected = observe(*tree, leaves, kLimit);
  std::set<std::string> actions;
  actionsOf(*tree, actions);
  std::erase_if(actions, [&](const auto& name) {
    return imported->text.find("(defskill " + name + "\n") == std::string::npos;
  });
  const auto main = imported->text.substr(imported->text.find("(defskill Main\n"));
  const bool maySkip = main.contains("(failure skipped)");
  Copies copies;
  for (const auto& name : actions) copies[name] = {name};
  const auto found =
      expected ? verified(imported->text + questions(copies, maySkip)) : std::nullopt;
  if (!found) return static_cast<void>(++counts.tooLarge);
  ++(imported->exact ? counts.exact : counts.approximate);
  INFO("seed " << seed << "\n" << xml << "\n" << imported->text);
  INFO("ticked:   " << inWords(*expected) << "\nverified: " << inWords(*found));
  if (imported->exact) REQUIRE(*found == *expected);
  REQUIRE(covers(*found, *expected));
}

} // namespace

TEST_CASE("the verdicts on random trees are those of an interpreter of ticks") {
  const auto leaves = bridge::Leaves::read(kRandomLeaves);
  REQUIRE(leaves);
  Counts counts;
  const auto seeds = seedsOr(1, 1200);
  for (auto seed = seeds.first; seed < seeds.end; ++seed) compare(seed, *leaves, counts);
  INFO(counts.exact << " exact, " << counts.approximate << " approximate, " << counts.refused
                    << " refused, " << counts.tooLarge << " too large");
  const auto compared = counts.exact + counts.approximate;
  CHECK(compared * 10 >= (seeds.end - seeds.first) * 7);
  CHECK(counts.exact > counts.approximate);
}
