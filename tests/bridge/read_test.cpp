#include "analysis/program/program.h"
#include "bridge/bt/import.h"
#include "tests/support/memory_files.h"

#include <catch2/catch.hpp>

#include <fmt/format.h>

using namespace proskill;
using namespace proskill::test;
using bridge::bt::importTree;
using bridge::bt::Leaves;

namespace {

std::string rooted(const std::string& inner, const std::string& attributes = "") {
  return "<root BTCPP_format=\"4\"" + attributes + ">\n" + inner + "</root>\n";
}

std::string treeOf(const std::string& node) {
  return rooted("<BehaviorTree ID=\"Main\">\n" + node + "\n</BehaviorTree>\n");
}

/// All errors, one per line, or "none".
std::string errorsIn(const std::map<std::string, std::string>& files) {
  const auto imported = importTree(MemoryFiles(files), "main.xml", Leaves());
  if (imported) return "none";
  std::string text;
  for (const auto& [place, message] : imported.error())
    text += fmt::format("{}:{}:{}: {}\n", place.file.generic_string(), place.line, place.column,
                        message);
  return text;
}

std::string errorsIn(const std::string& xml) { return errorsIn({{"main.xml", xml}}); }

std::string textOf(const std::string& xml, const std::string& leaves = "{}") {
  const auto imported =
      importTree(MemoryFiles({{"main.xml", xml}}), "main.xml", *Leaves::read(leaves));
  REQUIRE(imported);
  return imported->text;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("errors in a tree have places") {
  CHECK(errorsIn(treeOf("<Sequence/>")) ==
        "main.xml:3:1: `Sequence` must have at least 1 child, not 0\n");
  CHECK(errorsIn(treeOf("<Action/>")) == "main.xml:3:1: `Action` needs an attribute `ID`\n");
  CHECK(errorsIn(treeOf("<Sequence>\n  <Inverter/>\n  <Repeat num_cycles=\"x\"><A/></Repeat>\n"
                        "</Sequence>")) == "main.xml:4:3: `Inverter` must have 1 child, not 0\n");
  CHECK(errorsIn(treeOf("<Repeat num_cycles=\"x\"><A/></Repeat>")) ==
        "main.xml:3:1: `Repeat` needs a number of rounds from 1 to 1,000,000, or -1\n");
  CHECK(errorsIn(treeOf("<Strange><A/></Strange>")) ==
        "main.xml:3:1: control node or decorator `Strange` is not supported\n");
  CHECK(errorsIn(treeOf("<A _skipIf=\"x\"/>")) == "main.xml:3:1: `_skipIf` is not supported\n");
  CHECK(contains(errorsIn(treeOf("<ReactiveSequence><A/><B/></ReactiveSequence>")),
                 "main.xml:3:1: a `ReactiveSequence` with 2 children that can run"));
}

TEST_CASE("errors in a file have places") {
  CHECK(errorsIn("<root>\n</root>") ==
        "main.xml:1:1: `root` needs `BTCPP_format=\"4\"`\nmain.xml:1:1: there is no "
        "`BehaviorTree`\n");
  CHECK(errorsIn("<root>\n  <a>\n</root>") ==
        "main.xml:3:3: not well-formed XML: mismatched tag\n");
  CHECK(contains(errorsIn(""), "main.xml:1:1: not well-formed XML"));
  CHECK(contains(errorsIn("\xff\xfe\x00garbage"), "not well-formed XML"));
  CHECK(errorsIn("<!DOCTYPE root [<!ENTITY a \"b\">]>\n<root/>") ==
        "main.xml:1:16: a document type is not allowed here\n");
  CHECK(errorsIn(treeOf("<A/>text")) == "main.xml:3:5: text is not allowed between elements\n");
  CHECK(errorsIn(rooted("<BehaviorTree ID=\"A\"><X/></BehaviorTree>\n"
                        "<BehaviorTree ID=\"A\"><X/></BehaviorTree>\n",
                        " main_tree_to_execute=\"B\"")) ==
        "main.xml:3:1: the tree `A` is defined twice\nmain.xml:1:1: there is no tree `B`\n");
}

TEST_CASE("trees and files that contain themselves are errors") {
  CHECK(errorsIn(treeOf("<SubTree ID=\"Main\"/>")) ==
        "main.xml:3:1: the tree `Main` contains itself\n");
  CHECK(errorsIn(treeOf("<SubTree ID=\"Other\"/>")) == "main.xml:3:1: there is no tree `Other`\n");
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
  std::string doubled;
  for (int i = 0; i < 40; ++i)
    doubled += fmt::format("<BehaviorTree ID=\"T{0}\"><Sequence><SubTree ID=\"T{1}\"/>"
                           "<SubTree ID=\"T{1}\"/></Sequence></BehaviorTree>\n",
                           i, i + 1);
  doubled += "<BehaviorTree ID=\"T40\"><A/></BehaviorTree>\n";
  CHECK(contains(errorsIn(rooted(doubled, " main_tree_to_execute=\"T0\"")), "is too large"));
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
  const auto imported = importTree(MemoryFiles(files), "main.xml", Leaves());
  REQUIRE(imported);
  CHECK(contains(imported->text, "; sub/go.xml:3:11 At\n(defsv At\n"));
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
  CHECK(Leaves::read("[").error() == "the file is not JSON");
  CHECK(Leaves::read(R"({"leaves": {"A": {"duration": [3, 2]}}})").error() ==
        "/leaves/A/duration: the second number is less than the first");
  CHECK(Leaves::read(R"({"leaves": {"A": {"speed": 2}}})").error() ==
        "/leaves/A/speed is not a field of a leaf, or has a wrong value");
}

TEST_CASE("the summary names what was approximated") {
  const auto imported =
      importTree(MemoryFiles({{"main.xml", treeOf("<Sequence><ScriptCondition code=\"x\"/>\n"
                                                  "<A _failureIf=\"y\"/></Sequence>")}}),
                 "main.xml", Leaves());
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
