#include "analysis/flow/inspect.h"
#include "analysis/program/program.h"
#include "syntax/diagnostics/codes.h"
#include "tests/bridge/import/trees.h"
#include "tests/bridge/random_tree.h"
#include "tests/support/random/seeds.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace proskill;
using namespace proskill::test;

namespace warnings_of_imports {

using test::trees::contains;
using test::trees::textOf;
using test::trees::treeOf;

TEST_CASE("nothing is reported about the counters of parallel nodes") {
  const auto text =
      textOf(treeOf("<Repeat num_cycles=\"3\"><ParallelAll max_failures=\"2\">"
                    "<Parallel success_count=\"2\" failure_count=\"2\"><A/><B/><C/></Parallel>"
                    "<Fallback><Sequence><D/><E/></Sequence><F/></Fallback>"
                    "<ParallelAll max_failures=\"2\"><G/><H/><I/></ParallelAll>"
                    "<Parallel success_count=\"2\" failure_count=\"1\"><J/><K/>"
                    "<ForceFailure><L/></ForceFailure></Parallel>"
                    "</ParallelAll></Repeat>"));
  const auto program = analysis::load(MemoryFiles({{"p", text}}), "p");
  REQUIRE(analysis::check(program).empty());
  for (const auto& found : analysis::flow::inspect(program)) {
    CAPTURE(found.message);
    CHECK(found.severity == syntax::Severity::Hint);
    CHECK(syntax::info(found.code).id != "PS0902");
  }
}

TEST_CASE("there are no warnings about the turns of reactive nodes") {
  const auto text = textOf(
      treeOf("<ReactiveSequence><M/><Repeat num_cycles=\"-1\"><N/></Repeat></ReactiveSequence>"));
  const auto program = analysis::load(MemoryFiles({{"p", text}}), "p");
  for (const auto& found : analysis::flow::inspect(program)) {
    CAPTURE(found.message);
    CHECK(found.severity == syntax::Severity::Hint);
  }
}

TEST_CASE("a node that starts once remembers nothing") {
  const auto* once =
      "<Sequence><SequenceWithMemory><A/><B/></SequenceWithMemory><RunOnce><C/></RunOnce>"
      "<RunOnce then_skip=\"false\"><D/></RunOnce></Sequence>";
  const auto text = textOf(treeOf("<Fallback><E/>" + std::string(once) + "</Fallback>"));
  CHECK_FALSE(contains(text, "SequenceWithMemory_at"));
  CHECK_FALSE(contains(text, "RunOnce_ended"));
  const auto program = analysis::load(MemoryFiles({{"p", text}}), "p");
  for (const auto& found : analysis::flow::inspect(program)) {
    CAPTURE(found.message);
    CHECK(found.severity == syntax::Severity::Hint);
  }
  const auto* twice =
      "<Repeat num_cycles=\"2\"><SequenceWithMemory><A/><ForceSuccess><RunOnce "
      "then_skip=\"false\"><B/></RunOnce></ForceSuccess></SequenceWithMemory></Repeat>";
  CHECK(contains(textOf(treeOf(twice)), "SequenceWithMemory_at"));
  CHECK(contains(textOf(treeOf(twice)), "RunOnce_ended"));
}

TEST_CASE("a loop whose child ends it in the first round is its child") {
  for (const auto* loop :
       {"<Repeat num_cycles=\"-1\">%</Repeat>", "<Repeat num_cycles=\"3\">%</Repeat>",
        "<Repeat num_cycles=\"{n}\">%</Repeat>",
        "<KeepRunningUntilFailure>%</KeepRunningUntilFailure>"}) {
    std::string node = loop;
    node.replace(node.find('%'), 1, "<Sequence><A/><AlwaysFailure/></Sequence>");
    CAPTURE(node);
    const auto program = analysis::load(MemoryFiles({{"p", textOf(treeOf(node))}}), "p");
    CHECK(analysis::check(program).empty());
    for (const auto& found : analysis::flow::inspect(program)) {
      CAPTURE(found.message);
      CHECK(found.severity == syntax::Severity::Hint);
    }
  }
}

void checkNoWarnings(const std::string& text) {
  const auto program = analysis::load(MemoryFiles({{"p", text}}), "p");
  for (const auto& found : analysis::flow::inspect(program)) {
    INFO(text);
    CAPTURE(found.message);
    REQUIRE(found.severity == syntax::Severity::Hint);
  }
}

TEST_CASE("random trees become programs without warnings") {
  const auto leaves = bridge::Leaves::read(kRandomLeaves);
  REQUIRE(leaves);
  std::size_t imported = 0;
  const auto seeds = seedsOr(1, 400);
  for (auto seed = seeds.first; seed < seeds.end; ++seed) {
    CAPTURE(seed);
    const MemoryFiles files({{"tree.xml", randomTree(seed)}});
    const auto tree = bridge::bt::importTree(files, "tree.xml", *leaves, {});
    if (!tree) continue;
    ++imported;
    checkNoWarnings(tree->text);
  }
  CHECK(imported * 10 >= (seeds.end - seeds.first) * 8);
}

TEST_CASE("what a tree never ticks is named, and stays as a skill that nothing calls") {
  const MemoryFiles files({{"main.xml", treeOf("<Fallback><AlwaysSuccess/>\n<A/>\n"
                                               "<ReactiveSequence><AlwaysFailure/>\n<B/>"
                                               "</ReactiveSequence></Fallback>")}});
  const auto tree = bridge::bt::importTree(files, "main.xml", bridge::Leaves(), {});
  REQUIRE(tree);
  CHECK(std::ranges::count(tree->summary, "main.xml:4:1: `A` is never ticked") == 1);
  CHECK(std::ranges::count(tree->summary, "main.xml:6:1: `B` is never ticked") == 1);
  CHECK(contains(tree->text, "(defskill A\n"));
  CHECK(contains(tree->text, "(defskill Main\n  :success done\n  :body\n"));
  CHECK_FALSE(contains(tree->text, "ReactiveSequence"));
  checkNoWarnings(tree->text);
}

} // namespace warnings_of_imports
