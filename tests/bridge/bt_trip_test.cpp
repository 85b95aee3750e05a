#include "analysis/program/program.h"
#include "bridge/bt/emit/emit.h"
#include "bridge/bt/import.h"
#include "tests/bridge/errors_text.h"
#include "tests/bridge/random_tree.h"
#include "tests/bridge/verdicts.h"
#include "tests/support/memory_files.h"
#include "tests/support/random/seeds.h"

#include <catch2/catch.hpp>

/// Trees that are imported, written back and imported again.
namespace proskill::test::trips {
namespace {

struct Trips {
  std::size_t exact = 0;
  std::size_t approximate = 0;
  std::size_t refused = 0;
  std::size_t tooLarge = 0;
  std::size_t counted = 0; ///< with a loop that counts, of those that were written
};

/// The skills of a program that stand for the actions a0, a1, …: a0_2 stands for a0.
Copies copiesIn(const std::string& text) {
  Copies copies;
  for (auto at = text.find("(defskill a"); at != std::string::npos;
       at = text.find("(defskill a", at + 1)) {
    const auto begin = at + std::string_view("(defskill ").size();
    const auto name = text.substr(begin, text.find_first_of(" \n", begin) - begin);
    copies[name.substr(0, 2)].push_back(name);
  }
  return copies;
}

std::expected<bridge::bt::EmittedTree, bridge::Errors> written(const std::string& program) {
  const MemoryFiles files({{"p", program}});
  return bridge::bt::emitTree(analysis::load(files, "p"), "Main");
}

void roundTrip(const std::string& xml, const bridge::Leaves& leaves, Trips& counts) {
  const MemoryFiles files({{"t.xml", xml}});
  const auto first = bridge::bt::importTree(files, "t.xml", leaves, {});
  if (!first) return;
  const auto tree = written(first->text);
  if (!tree) return static_cast<void>(++counts.refused);
  INFO(xml << "\n" << first->text << "\n" << tree->tree.text);
  const auto& text = tree->tree.text;
  if (text.contains("num_cycles=\"3\"") || text.contains("num_attempts=\"3\"") ||
      text.contains("RecoveryNode"))
    ++counts.counted;
  const MemoryFiles back({{"t.xml", text}});
  const auto second =
      bridge::bt::importTree(back, "t.xml", *bridge::Leaves::read(tree->leaves), {});
  INFO(errorsText(second));
  REQUIRE(second);
  INFO(second->text);
  const auto copies = copiesIn(second->text);
  Copies originals;
  for (const auto& [name, all] : copies) originals[name] = {name};
  const auto before = verified(first->text + questions(originals, false));
  const auto after = verified(second->text + questions(copies, false));
  if (!before || !after) return static_cast<void>(++counts.tooLarge);
  ++(second->exact ? counts.exact : counts.approximate);
  INFO("before: " << inWords(*before) << "\nafter:  " << inWords(*after));
  if (second->exact) REQUIRE(*after == *before);
  REQUIRE(covers(*after, *before));
}

} // namespace

TEST_CASE("a tree that is imported, written and imported again keeps its verdicts") {
  const auto leaves = bridge::Leaves::read(kRandomLeaves);
  REQUIRE(leaves);
  Trips counts;
  const auto seeds = seedsOr(1, 600);
  for (auto seed = seeds.first; seed < seeds.end; ++seed) {
    INFO("seed " << seed);
    roundTrip(randomTree(seed), *leaves, counts);
  }
  CAPTURE(counts.exact, counts.approximate, counts.refused, counts.tooLarge, counts.counted);
  const auto all = seeds.end - seeds.first;
  CHECK((counts.exact + counts.approximate) * 2 >= all);
  CHECK(counts.exact * 5 >= all * 2);
  CHECK(counts.counted * 100 >= all);
}

TEST_CASE("a script that is tested goes round as a condition with another name") {
  Trips counts;
  roundTrip("<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\"><Sequence><ScriptCondition "
            "code=\"x == 1\"/><Action ID=\"Any\" name=\"a0\"/></Sequence></BehaviorTree></root>",
            *bridge::Leaves::read(kRandomLeaves), counts);
  CHECK(counts.exact == 1);
}

TEST_CASE("loops that count go round as they are") {
  const std::string a = "<Action ID=\"Any\" name=\"a0\"/>";
  const std::string b = "<Action ID=\"Any\" name=\"a1\"/>";
  const std::string c = "<Condition ID=\"c\"/>";
  const std::string fallback = "<Fallback>" + c + a + "</Fallback>";
  const auto repeat = [](const std::string& child) {
    return "<Repeat num_cycles=\"3\">" + child + "</Repeat>";
  };
  const auto retry = [](const std::string& child) {
    return "<RetryUntilSuccessful num_attempts=\"3\">" + child + "</RetryUntilSuccessful>";
  };
  const auto recovery = [](const std::string& first, const std::string& second) {
    return "<RecoveryNode number_of_retries=\"2\">" + first + second + "</RecoveryNode>";
  };
  const auto sequence = [](const std::string& first, const std::string& second) {
    return "<Sequence>" + first + second + "</Sequence>";
  };
  const auto leaves = bridge::Leaves::read(kRandomLeaves);
  for (const auto& node :
       {repeat(a), retry(a), repeat(c), retry(c), repeat(retry(a)), retry(repeat(fallback)),
        sequence(retry(fallback), b), "<Inverter>" + repeat(a) + "</Inverter>",
        "<ForceSuccess>" + retry(sequence(c, a)) + "</ForceSuccess>", recovery(a, b),
        recovery(c, a), recovery(retry(a), sequence(c, b)), sequence(recovery(a, c), b),
        "<Fallback>" + recovery(a, c) + b + "</Fallback>",
        "<ForceFailure>" + recovery(a, b) + "</ForceFailure>", recovery(recovery(a, c), b)}) {
    INFO(node);
    Trips counts;
    roundTrip("<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\">" + node +
                  "</BehaviorTree></root>",
              *leaves, counts);
    CHECK(counts.exact == 1);
    CHECK(counts.counted == 1);
  }
}

} // namespace proskill::test::trips
