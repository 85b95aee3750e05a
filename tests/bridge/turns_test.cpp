#include "bridge/bt/import.h"
#include "bridge/bt/read/read.h"
#include "bridge/bt/tree/expand.h"
#include "tests/bridge/errors_text.h"
#include "tests/bridge/ticker.h"
#include "tests/bridge/verdicts.h"
#include "tests/support/memory_files.h"

#include <catch2/catch.hpp>

/// Reactive nodes of which several children can run.
using namespace proskill;
using namespace proskill::test;
using bridge::Leaves;

namespace {

/// A program, and what an interpreter of ticks sees of the tree, whose actions are `a0` and `a1`.
struct Both {
  bridge::Imported imported;
  Observed ticked;
  Observed verified;
};

Both bothOf(const std::string& node, const std::string& leaves = "{}") {
  const MemoryFiles files({{"tree.xml", "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\">" +
                                            node + "</BehaviorTree></root>"}});
  const auto allowed = *Leaves::read(leaves);
  const auto imported = bridge::bt::importTree(files, "tree.xml", allowed, {});
  INFO(errorsText(imported));
  REQUIRE(imported);
  const auto tree = bridge::bt::expand(*bridge::bt::read(files, "tree.xml"));
  const auto text = imported->text + questions({{"a0", {"a0"}}, {"a1", {"a1"}}}, false);
  return {*imported, *observe(*tree, allowed, 1000), *verified(text)};
}

const std::set<std::pair<std::string, std::string>> kTogether{{"a0", "a1"}};

} // namespace

TEST_CASE("a reactive node starts a child before it has halted the sibling that runs") {
  for (const std::string tag : {"ReactiveSequence", "ReactiveFallback"}) {
    const auto both = bothOf("<" + tag + "><A name=\"a0\"/><A name=\"a1\"/></" + tag + ">");
    CHECK(both.imported.exact);
    CHECK(both.verified.together == kTogether);
    CHECK(both.verified == both.ticked);
  }
}

TEST_CASE("two actions never run at once in a sequence that is not reactive") {
  const auto both = bothOf("<Sequence><A name=\"a0\"/><A name=\"a1\"/></Sequence>");
  CHECK(both.verified.together.empty());
}

TEST_CASE("a child after one that takes time is halted at each tick, so that it never ends") {
  const std::string slow =
      R"({"leaves": {"a0": {"duration": [2, 5]}, "a1": {"duration": [1, 3]}}})";
  const std::string actions = "<A name=\"a0\"/><A name=\"a1\"/>";
  const auto reactive = bothOf("<ReactiveSequence>" + actions + "</ReactiveSequence>", slow);
  CHECK_FALSE(reactive.imported.exact); // `a1` may end by itself, which no tick sees
  CHECK_FALSE(reactive.verified.success);
  CHECK(reactive.verified.together == kTogether);
  CHECK(bothOf("<Sequence>" + actions + "</Sequence>", slow).verified.success);
}

TEST_CASE("a child that a condition lets pass does not halt the one that runs") {
  const std::string slow = R"({"leaves": {"a0": {"duration": [2, 5]}, "a1": {"duration": [1, 3]},
                               "Full": {"kind": "condition"}}})";
  const auto both = bothOf("<ReactiveSequence><Fallback><Condition ID=\"Full\"/><A name=\"a0\"/>"
                           "</Fallback><A name=\"a1\"/></ReactiveSequence>",
                           slow);
  CHECK(both.imported.exact); // `Full` may be true, which takes no time
  CHECK(both.verified.success);
  CHECK(both.verified.together == kTogether);
}

TEST_CASE("the summary says which leaf starts again at each tick and may be a condition") {
  const auto both = bothOf("<ReactiveSequence><A name=\"a0\"/><A name=\"a1\"/></ReactiveSequence>");
  CHECK(both.imported.summary[1] == "tree.xml:1:66: `A` starts again at each tick; if it is a "
                                    "condition, a file of `--leaves` may say so");
}
