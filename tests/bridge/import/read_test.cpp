#include "analysis/program/program.h"
#include "bridge/bt/import.h"
#include "bridge/bt/read/script.h"
#include "tests/bridge/import/trees.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <fmt/format.h>

using namespace proskill;
using namespace proskill::test;
using bridge::Leaves;
using bridge::bt::importTree;

namespace read_trees {

using test::trees::contains;
using test::trees::errorsIn;
using test::trees::rooted;
using test::trees::textOf;
using test::trees::treeOf;

TEST_CASE("errors in a tree have places") {
  CHECK(errorsIn(treeOf("<Sequence/>")) ==
        "main.xml:3:1: `Sequence` must have at least 1 child, not 0\n");
  CHECK(errorsIn(treeOf("<Action/>")) == "main.xml:3:1: `Action` needs an attribute `ID`\n");
  CHECK(errorsIn(treeOf("<Sequence>\n  <Inverter/>\n  <Repeat num_cycles=\"x\"><A/></Repeat>\n"
                        "</Sequence>")) == "main.xml:4:3: `Inverter` must have 1 child, not 0\n");
  CHECK(errorsIn(treeOf("<Repeat num_cycles=\"x\"><A/></Repeat>")) ==
        "main.xml:3:1: `Repeat` needs a number of rounds from 1 to 1,000,000, or -1\n");
  CHECK(errorsIn(treeOf("<PathLongerOnApproach><A/></PathLongerOnApproach>")) ==
        "main.xml:3:1: `PathLongerOnApproach` is not supported: it ends without halting its "
        "child\n");
  CHECK(contains(errorsIn(treeOf("<FallbackStar><A/></FallbackStar>")), "a node of version 2"));
  CHECK(errorsIn(treeOf("<Parallel>\n<A _skipIf=\"x\"/></Parallel>")) ==
        "main.xml:4:1: a node that may be skipped is only supported below a sequence, a fallback, "
        "a `TryCatch` or a loop over a queue\n");
  CHECK(errorsIn(treeOf("<SequenceWithMemory><A _skipIf=\"x\"/></SequenceWithMemory>")) ==
        "main.xml:3:1: a `SequenceWithMemory` whose children may all be skipped is not "
        "supported\n");
  CHECK(errorsIn(treeOf("<Sequence><A/><B _skipIf=\"x\"/></Sequence>")) == "none");
  CHECK(
      errorsIn(treeOf("<A _whille=\"x\"/>")) ==
      "main.xml:3:1: `_whille` is not an attribute of BehaviorTree.CPP; did you mean `_while`?\n");
  CHECK(errorsIn(treeOf("<RunOnce then_skip=\"maybe\"><A/></RunOnce>")) ==
        "main.xml:3:1: `then_skip` must be `true` or `false`\n");
  CHECK(errorsIn(treeOf("<Precondition if=\"x\" else=\"no\"><A/></Precondition>")) ==
        "main.xml:3:1: `else` must be SUCCESS, FAILURE, SKIPPED or RUNNING\n");
  CHECK(errorsIn(treeOf("<LoopInt queue=\"1;2\" if_empty=\"RUNNING\"><A/></LoopInt>")) ==
        "main.xml:3:1: `if_empty` must be SUCCESS, FAILURE or SKIPPED\n");
  CHECK(errorsIn(treeOf("<TryCatch catch_on_halt=\"true\"><A/><B/></TryCatch>")) ==
        "main.xml:3:1: `catch_on_halt` is not supported\n");
  CHECK(errorsIn(treeOf("<ReactiveSequence><A _skipIf=\"x\"/><RunOnce><B/></RunOnce>"
                        "</ReactiveSequence>")) ==
        "main.xml:3:1: a reactive node whose children may all be skipped is only supported with "
        "one child that can run\n");
}

TEST_CASE("errors in a file have places") {
  CHECK(errorsIn("<root>\n</root>") == "main.xml:1:1: there is no `BehaviorTree`\n");
  CHECK(errorsIn("<root BTCPP_format=\"5\"><BehaviorTree ID=\"A\"><X/></BehaviorTree></root>") ==
        "main.xml:1:1: `BTCPP_format` must be 3 or 4\n");
  CHECK(errorsIn("<root>\n  <a>\n</root>") ==
        "main.xml:3:3: not well-formed XML: mismatched tag\n");
  CHECK(contains(errorsIn(""), "main.xml:1:1: not well-formed XML"));
  CHECK(contains(errorsIn("\xff\xfe\x00garbage"), "not well-formed XML"));
  CHECK(errorsIn("<!DOCTYPE root [<!ENTITY a \"b\">]>\n<root/>") ==
        "main.xml:1:16: a document type is not allowed here\n");
  CHECK(errorsIn(rooted("<BehaviorTree ID=\"A\"><X/></BehaviorTree>\n"
                        "<BehaviorTree ID=\"A\"><X/></BehaviorTree>\n",
                        " main_tree_to_execute=\"B\"")) ==
        "main.xml:3:1: the tree `A` is defined twice\nmain.xml:1:1: there is no tree `B`\n");
}

TEST_CASE("scripts have their form, and nodes what they cannot do without") {
  CHECK(errorsIn(treeOf("<Sequence><Script/>\n<Script code=\"x := := 3 )\"/>\n"
                        "<ScriptCondition code=\"((\"/>\n<SetBlackboard output_key=\"x\"/>"
                        "</Sequence>")) ==
        "main.xml:3:11: `Script` needs an attribute `code`\n"
        "main.xml:4:1: this is not a script: unexpected `:=`\n"
        "main.xml:5:1: this is not a script: it ends too early\n"
        "main.xml:6:1: `SetBlackboard` needs an attribute `value`\n");
  CHECK(errorsIn(
            treeOf("<Sequence><A _skipIf=\"x =\" _post=\"\"/>\n<A _onHalted=\"= 3\"/>\n"
                   "<Precondition if=\"x +\"><A/></Precondition>\n"
                   "<Precondition if=\"{x}\"><A/></Precondition><Precondition><A/></Precondition>"
                   "\n<UnsetBlackboard/><WasEntryUpdated/>\n"
                   "<SkipUnlessUpdated><A/></SkipUnlessUpdated></Sequence>")) ==
        "main.xml:3:11: this is not a script: it ends too early\n"
        "main.xml:4:1: this is not a script: unexpected `=`\n"
        "main.xml:5:1: this is not a script: it ends too early\n"
        "main.xml:6:43: `Precondition` needs an attribute `if`\n"
        "main.xml:7:1: `UnsetBlackboard` needs an attribute `key`\n"
        "main.xml:7:19: `WasEntryUpdated` needs an attribute `entry`\n"
        "main.xml:8:1: `SkipUnlessUpdated` needs an attribute `entry`\n");
  using bridge::bt::scriptError;
  for (const auto* good : {"x := 3", "a=1; b += -2.5 ;", "val >= 10 && !(msg == 'a;b' || x)",
                           "x := (y > 0) ? 'p' : 'q'", "@root := 0x1F | ~2", "a..b == 'c'",
                           "x := y ? 1 : z ? 2 : 3", "ok", "a == b; c"})
    CHECK(scriptError(good) == std::nullopt);
  for (const auto* bad : {"", " ", "x :=", "3 )", "(a", "a b", "x := 'y", "a ? b", "a : b", "a; )",
                          "1 + := 2", "a # b", "x + y := 3"})
    CHECK(scriptError(bad) != std::nullopt);
}

TEST_CASE("the errors of a file are reported besides those of its includes") {
  CHECK(errorsIn(rooted("<include path=\"no.xml\"/>\n<BehaviorTree ID=\"Main\"><Sequence/>"
                        "</BehaviorTree>\n")) ==
        "main.xml:2:1: cannot read `no.xml`: no such file\n"
        "main.xml:3:25: `Sequence` must have at least 1 child, not 0\n");
}

TEST_CASE("a tree without a name, and one of several that is chosen") {
  CHECK(
      contains(textOf(rooted("<BehaviorTree><A/></BehaviorTree>\n")), "(defskill BehaviorTree_0"));
  const MemoryFiles files({{"main.xml", rooted("<BehaviorTree ID=\"M\"><A/></BehaviorTree>\n"
                                               "<BehaviorTree ID=\"N\"><B/></BehaviorTree>\n")}});
  CHECK(contains(errorsText(importTree(files, "main.xml", Leaves(), {})), "`--main` chooses one"));
  CHECK(contains(importTree(files, "main.xml", Leaves(), {}, "N")->text, "(defskill N"));
  CHECK(contains(errorsText(importTree(files, "main.xml", Leaves(), {}, "O")), "no tree `O`"));
}

TEST_CASE("ports that a model does not declare are named") {
  const auto model = "</BehaviorTree><TreeNodesModel><Action ID=\"A\">"
                     "<input_port name=\"p\"/></Action><Action ID=\"B\"/></TreeNodesModel>\n";
  const auto imported = importTree(
      MemoryFiles({{"main.xml", rooted("<BehaviorTree ID=\"M\"><Sequence><A p=\"1\" q=\"2\"/>"
                                       "<B r=\"3\"/></Sequence>" +
                                       std::string(model))}}),
      "main.xml", Leaves(), {});
  REQUIRE(imported);
  REQUIRE(imported->summary.size() == 2);
  CHECK(contains(imported->summary[0], "`q` is not a port that `TreeNodesModel` declares for `A`"));
}

TEST_CASE("trees and files that contain themselves are errors") {
  CHECK(errorsIn(treeOf("<SubTree ID=\"Main\"/>")) ==
        "main.xml:3:1: the tree `Main` contains itself\n");
  CHECK(errorsIn(treeOf("<SubTree ID=\"Other\"/>")) ==
        "main.xml:3:1: there is no tree `Other`; if it is in another file, `include` that\n");
  CHECK(errorsIn({{"main.xml", rooted("<include path=\"b.xml\"/>\n")},
                  {"b.xml", rooted("<include path=\"main.xml\"/>\n")}}) ==
        "b.xml:2:1: `main.xml` includes itself\n");
  CHECK(errorsIn({{"main.xml", rooted("<include path=\"none.xml\"/>\n")}}) ==
        "main.xml:2:1: cannot read `none.xml`: no such file\n");
  CHECK(contains(errorsIn(rooted("<include path=\"/etc/passwd\"/>\n")), "must be relative"));
}

TEST_CASE("input that is too deep or too large ends in an error") {
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<Inverter>";
  CHECK(contains(errorsIn(deep), "elements are nested too deeply"));
  std::string tests;
  std::string ends;
  for (int i = 0; i < 100; ++i) tests += "<IfThenElse>";
  for (int i = 0; i < 100; ++i) ends += "<Condition ID=\"D\"/></IfThenElse>";
  CHECK(contains(errorsIn(treeOf("<ReactiveSequence>" + tests + "<Condition ID=\"C\"/>" + ends +
                                 "<A/></ReactiveSequence>")),
                 "so many `IfThenElse` in each other"));
  std::string doubled;
  for (int i = 0; i < 40; ++i)
    doubled += fmt::format("<BehaviorTree ID=\"T{0}\"><Sequence><SubTree ID=\"T{1}\"/>"
                           "<SubTree ID=\"T{1}\"/></Sequence></BehaviorTree>\n",
                           i, i + 1);
  doubled += "<BehaviorTree ID=\"T40\"><A/></BehaviorTree>\n";
  CHECK(contains(errorsIn(rooted(doubled, " main_tree_to_execute=\"T0\"")), "is too large"));
}

TEST_CASE("nodes that are nested deeply are imported without trying all ways through them") {
  for (const auto& [open, close] : {std::pair{"<Inverter>", "</Inverter>"},
                                    {"<ForceSuccess>", "</ForceSuccess>"},
                                    {"<Parallel>", "<B/></Parallel>"},
                                    {"<ParallelAll>", "<B/></ParallelAll>"},
                                    {"<RecoveryNode>", "<B/></RecoveryNode>"},
                                    {"<TryCatch>", "<B/></TryCatch>"},
                                    {"<ReactiveSequence>", "<B/></ReactiveSequence>"},
                                    {"<ReactiveFallback><B/>", "</ReactiveFallback>"},
                                    {"<Mine>", "<B/></Mine>"},
                                    {"<PauseResumeController>", "<B/></PauseResumeController>"}}) {
    INFO(open);
    std::string before;
    std::string after;
    for (int i = 0; i < 200; ++i) before += open;
    for (int i = 0; i < 200; ++i) after += close;
    CHECK(errorsIn(treeOf(before + "<A/>" + after)) == "none");
  }
}

TEST_CASE("a file that is included gives its trees, and ports are remapped") {
  const std::map<std::string, std::string> files{
      {"main.xml", rooted("<include path=\"sub/go.xml\"/>\n<BehaviorTree ID=\"Main\"><Sequence>"
                          "<SubTree ID=\"Go\" where=\"{goal}\"/><At place=\"{goal}\"/>"
                          "<SubTree ID=\"Go\" where=\"home\"/></Sequence></BehaviorTree>\n"
                          "<TreeNodesModel><Condition ID=\"At\"/></TreeNodesModel>",
                          " main_tree_to_execute=\"Main\"")},
      {"sub/go.xml", rooted("<BehaviorTree ID=\"Go\">\n<Sequence><At place=\"{where}\"/>"
                            "<Drive to=\"{where}\"/></Sequence></BehaviorTree>")}};
  const auto imported = importTree(MemoryFiles(files), "main.xml", Leaves(), {});
  REQUIRE(imported);
  CHECK(contains(imported->text, "; from sub/go.xml:3:11 At\n(defsv At\n"));
  CHECK(contains(imported->text, "(defsv At_2\n"));
  CHECK_FALSE(contains(imported->text, "(defsv At_3\n")); // {goal} is one entry
  CHECK(contains(imported->text, ":action (Drive \"{goal}\")"));
  CHECK(contains(imported->text, ":action (Drive \"home\")"));
}

TEST_CASE("a node may have any word of the language as its name") {
  for (const std::string word :
       {"defskill", "defsv",   "defevent", "defresource", "defproperty", "defenvironment",
        "defconst", "include", "if",       "while",       "label",       "goto",
        "success",  "failure", "printf",   "true",        "race",        "case",
        "emit",     "set",     "choose",   "break",       "running",     "always"}) {
    CAPTURE(word);
    const auto text =
        textOf(treeOf("<Parallel name=\"" + word + "\"><" + word + "/><A/></Parallel>"));
    const auto program = analysis::load(MemoryFiles({{"p", text}}), "p");
    for (const auto& found : analysis::check(program))
      CHECK(found.severity != syntax::Severity::Error);
  }
}

TEST_CASE("the file of leaves says how long actions take and how they end") {
  const auto leaves =
      R"({"tick": 0.01, "leaves": {"A": {"duration": [0.5, 2], "outcomes": ["success"]},
                          "B": {"kind": "condition", "changes": false}, "Unknown": {}}})";
  const auto text = textOf(treeOf("<KeepRunningUntilFailure><Sequence><A/><B/></Sequence>"
                                  "</KeepRunningUntilFailure>"),
                           leaves);
  CHECK(contains(text, "(defskill A\n  :time_interval [0.5,2]\n  :action (A)\n  :success done)"));
  CHECK(contains(text, ":init (Yes No)"));
  CHECK(contains(text, "(^ ]0,0.01])"));
}

TEST_CASE("the summary names what was approximated") {
  const auto imported =
      importTree(MemoryFiles({{"main.xml", treeOf("<Sequence><ScriptCondition code=\"x\"/>\n"
                                                  "<A _failureIf=\"y\"/></Sequence>")}}),
                 "main.xml", Leaves(), {});
  REQUIRE(imported);
  CHECK_FALSE(imported->exact);
  REQUIRE(imported->summary.size() == 4);
  CHECK(imported->summary[0] == "not declared in `TreeNodesModel`, taken as actions: A");
  CHECK(imported->summary[1] ==
        "main.xml:3:11: approximated: the script may have any result at any time");
  CHECK(imported->summary[2] ==
        "main.xml:4:1: approximated: the script of `_failureIf` may have any result");
  CHECK(contains(imported->summary[3], "over-approximate"));
}

TEST_CASE("a node that may be skipped has a third outcome") {
  const auto text = textOf(treeOf("<Sequence><SubTree ID=\"Go\"/><A/></Sequence></BehaviorTree>\n"
                                  "<BehaviorTree ID=\"Go\"><B _while=\"x\"/>")
                               .insert(5, " main_tree_to_execute=\"Main\""));
  CHECK(contains(text, "(if (B_while No)\n        (failure skipped))"));
  CHECK(contains(text, "((^ (B_while No)))"));
  CHECK(contains(text, "(Go)\n     (if (= Go.res skipped)\n        (goto skipped))"));
}

TEST_CASE("loops over spelt-out queues, RunOnce and TryCatch are exact") {
  const auto isExact = [](const std::string& node) {
    const MemoryFiles files({{"main.xml", treeOf(node)}});
    const auto imported = importTree(files, "main.xml", Leaves(), {});
    REQUIRE(imported);
    return imported->exact;
  };
  CHECK(isExact("<LoopString queue=\"a;b\" value=\"{x}\"><A/></LoopString>"));
  CHECK(isExact("<RunOnce><A/></RunOnce>"));
  CHECK(isExact("<TryCatch><A/><B/><C/></TryCatch>"));
  CHECK_FALSE(isExact("<LoopString queue=\"{all}\" value=\"{x}\"><A/></LoopString>"));
  CHECK_FALSE(isExact("<Sequence><A _while=\"x\"/></Sequence>"));
}

TEST_CASE("control nodes of the author are approximated, and named") {
  const MemoryFiles files({{"main.xml", treeOf("<Strange><A/><B/></Strange>")}});
  const auto imported = importTree(files, "main.xml", Leaves(), {});
  REQUIRE(imported);
  CHECK_FALSE(imported->exact);
  CHECK(imported->summary[1] ==
        "not built in, taken as control nodes and decorators of the author, which halt their "
        "children before they end: Strange");
}

TEST_CASE("types of leaves that differ have actions that differ, and the summary says so") {
  const MemoryFiles files(
      {{"main.xml", treeOf("<Sequence><Move-Base/><Move_Base/><Mov\u00e9/></Sequence>")}});
  const auto imported = importTree(files, "main.xml", Leaves(), {});
  REQUIRE(imported);
  CHECK(contains(imported->text, ":action (Move_Base)"));
  CHECK(contains(imported->text, ":action (Move_Base_2)"));
  const auto says = [&](const std::string& line) {
    return std::ranges::find(imported->summary, line) != imported->summary.end();
  };
  CHECK(says("the action of `Move-Base` is called `Move_Base`"));
  CHECK(says("the action of `Move_Base` is called `Move_Base_2`"));
  CHECK(says("the action of `Mov\u00e9` is called `Mov__`"));
}

TEST_CASE("a condition of Nav2 is one under the name that Nav2 registers, too") {
  CHECK_FALSE(
      contains(textOf(treeOf("<Sequence><GlobalUpdatedGoal/><GloballyUpdatedGoal/></Sequence>")),
               ":action"));
}

TEST_CASE("children of a PipelineSequence that end in each tick are one branch") {
  const auto tree = [](const std::string& first) {
    return treeOf("<PipelineSequence><" + first + "/><PlannerSelector/><IsStuck/><Go/><Follow/>" +
                  "</PipelineSequence>");
  };
  const std::string slow = R"({"leaves": {"ControllerSelector": {"duration": [0, null]}}})";
  CHECK(contains(textOf(tree("ControllerSelector")), "(^ (= PipelineSequence_passed 2))"));
  CHECK(contains(textOf(tree("ControllerSelector"), slow), "(^ (= PipelineSequence_passed 3))"));
  CHECK(contains(textOf(tree("Slow")), "(^ (= PipelineSequence_passed 3))"));
}

TEST_CASE("actions of Nav2 that are known to end in each tick are named") {
  const auto summaryOf = [](const std::string& leaves) {
    const auto xml = treeOf("<Sequence><TruncatePath/><Go/><ControllerSelector/></Sequence>");
    return importTree(MemoryFiles({{"main.xml", xml}}), "main.xml", *Leaves::read(leaves), {})
        ->summary;
  };
  const std::string known = "actions of Nav2 that end in the tick that starts them, unless a file "
                            "of `--leaves` says otherwise: ";
  CHECK(summaryOf("{}")[1] == known + "ControllerSelector, TruncatePath");
  CHECK(summaryOf(R"({"leaves": {"TruncatePath": {"duration": [0, 1]},
                                 "ControllerSelector": {"outcomes": ["success"]}}})")[1] ==
        known + "ControllerSelector");
}

TEST_CASE("a tree of Nav2 is imported, with its own nodes and conditions") {
  const std::string xml = R"(<root main_tree_to_execute="MainTree">
<BehaviorTree ID="MainTree">
  <RecoveryNode number_of_retries="6" name="Navigate">
    <PipelineSequence name="WithReplanning">
      <RateController hz="1.0"><ComputePath/></RateController>
      <FollowPath/>
    </PipelineSequence>
    <ReactiveFallback name="Recover">
      <GoalUpdated/>
      <RoundRobin name="Actions"><Spin/><Wait/></RoundRobin>
    </ReactiveFallback>
  </RecoveryNode>
</BehaviorTree>
</root>)";
  const auto imported = importTree(MemoryFiles({{"main.xml", xml}}), "main.xml", Leaves(), {});
  REQUIRE(imported);
  CHECK(imported->summary[0] == "`BTCPP_format` is not 4: read as version 4");
  CHECK(imported->summary[1] ==
        "not declared in `TreeNodesModel`, taken as actions: ComputePath, FollowPath, Spin, Wait");
  CHECK(contains(imported->text, "(defsv GoalUpdated\n"));
  CHECK(contains(imported->text, "(if (>= Navigate_retries 6)"));
  CHECK(contains(imported->text, "(^ (= WithReplanning_passed 1))"));
  CHECK(errorsIn(treeOf("<RecoveryNode number_of_retries=\"x\"><A/><B/></RecoveryNode>")) ==
        "main.xml:3:1: `number_of_retries` must be a number from 0 to 1,000,000\n");
}

} // namespace read_trees
