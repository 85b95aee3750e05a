#include "tests/bridge/import/trees.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace proskill;
using namespace proskill::test;
using bridge::Leaves;
using bridge::bt::importTree;

namespace read_as_btcpp {

using test::trees::contains;
using test::trees::errorsIn;
using test::trees::rooted;
using test::trees::textOf;
using test::trees::treeOf;

TEST_CASE("texts between elements are named, not those in models") {
  const auto imported = importTree(
      MemoryFiles({{"main.xml",
                    rooted("<BehaviorTree ID=\"Main\"><Sequence>>\n<A/><![CDATA[x]]></Sequence>"
                           "</BehaviorTree><TreeNodesModel><Action ID=\"A\"><input_port name=\"p\">"
                           "what it means</input_port></Action></TreeNodesModel>")}}),
      "main.xml", Leaves(), {});
  REQUIRE(imported);
  REQUIRE(imported->summary.size() == 2);
  CHECK(imported->summary[0] == "main.xml:2:35: a text between elements has no effect");
}

TEST_CASE("a file is read in the encoding that it names") {
  const auto tree = [](const std::string& encoding, const std::string& name) {
    return "<?xml version=\"1.0\" encoding=\"" + encoding + "\"?>\n" +
           treeOf("<A p=\"" + name + "\"/>");
  };
  const auto* accented = "(A \"\xC3\xA9\")";
  CHECK(contains(textOf(tree("UTF-8", "\xC3\xA9")), accented));
  CHECK(contains(textOf("\xEF\xBB\xBF" + tree("utf-8", "\xC3\xA9")), accented));
  CHECK(contains(textOf(tree("ISO-8859-1", "\xE9")), accented));
  std::string wide = "\xFF\xFE";
  for (const char c : tree("UTF-16", "\xE9")) wide += std::string{c, '\0'};
  CHECK(contains(textOf(wide), accented));
  // Editors save files as UTF-8 and leave another name in them.
  CHECK(contains(textOf(tree("UTF-16", "\xC3\xA9")), accented));
  CHECK(contains(textOf(tree("utf8", "\xC3\xA9")), accented));
  CHECK(contains(errorsIn(tree("windows-1252", "\xE9")), "unknown encoding"));
  CHECK(contains(errorsIn(tree("UTF-8", "\xE9")), "main.xml:4:7: not well-formed XML"));
}

TEST_CASE("what is not well-formed is read as BehaviorTree.CPP reads it") {
  const std::string text =
      "\n <?xml version=\"1.0\"?>\n<!-- a -- b ---><root BTCPP_format=\"4\">"
      "<BehaviorTree ID=\"Main\"><Sequence>\n"
      "<Precondition if=\"a<3 && b\"><A p=\"&lt;&#65;&\"/>"
      "</Precondition><B p='x&amp;&y' _x=\"\"/></Sequence></BehaviorTree></root>";
  const auto imported = importTree(MemoryFiles({{"main.xml", text}}), "main.xml", Leaves(), {});
  REQUIRE(imported);
  CHECK(contains(imported->text, "(A \"<A&\")"));
  CHECK(contains(imported->summary[1], "main.xml:3:17: not well-formed XML"));
  CHECK(contains(imported->text, "(B \"x&&y\")"));
  // Columns are those of the file.
  CHECK(contains(imported->text, "; from main.xml:4:29 A"));
  CHECK(contains(imported->text, "; from main.xml:4:63 B"));
  CHECK(errorsIn(treeOf("<Sequence if=\"a && b\"><A></Sequence>")) ==
        "main.xml:3:28: not well-formed XML: mismatched tag\n");
  CHECK(errorsIn(treeOf("<A x=\"a && b/>")) ==
        "main.xml:3:1: not well-formed XML: unclosed token\n");
}

TEST_CASE("what is not well-formed keeps its encoding and its columns") {
  const auto tree = [](const std::string& encoding, const std::string& name) {
    return "<?xml version=\"1.0\" encoding=\"" + encoding + "\"?>\n" +
           treeOf("<Sequence><A p=\"a && b" + name + "\"/><B/></Sequence>");
  };
  for (const auto& text : {tree("ISO-8859-1", "\xE9"), tree("utf8", "\xC3\xA9")}) {
    CAPTURE(text);
    CHECK(contains(textOf(text), "(A \"a && b\xC3\xA9\")"));
  }
  std::string many;
  for (int i = 0; i < 40; ++i) many += "\xC3\xA9";
  CHECK(contains(textOf(tree("UTF-8", many)), "; from main.xml:4:66 B"));
  // In UTF-16, the bytes of `&` are two.
  std::string wide = "\xFF\xFE";
  for (const char c : tree("UTF-16", "")) wide += std::string{c, '\0'};
  CHECK(contains(errorsIn(wide), "main.xml:4:20: not well-formed XML"));
}

TEST_CASE("attributes that only editors know are named, once") {
  const auto imported = importTree(
      MemoryFiles({{"main.xml", treeOf("<Sequence>\n<A _collapsed=\"1\"/>\n<B _collapsed=\"0\"/>"
                                       "</Sequence>")}}),
      "main.xml", Leaves(), {});
  REQUIRE(imported);
  CHECK(imported->exact);
  CHECK(
      std::ranges::count(imported->summary,
                         "main.xml:4:1: `_collapsed` is not an attribute of BehaviorTree.CPP, and "
                         "has no effect") == 1);
}

TEST_CASE("built-in nodes keep their meaning in the explicit form") {
  const auto text = textOf(treeOf(
      "<Control ID=\"Fallback\"><Action ID=\"AlwaysFailure\"/><Action ID=\"Sleep\" msec=\"20\"/>"
      "<Action ID=\"Script\" code=\"a := 1\"/><Condition ID=\"Near\"/></Control>"));
  CHECK_FALSE(contains(text, "(defskill AlwaysFailure"));
  CHECK_FALSE(contains(text, "(defskill Script"));
  CHECK(contains(text, "(^ 0.02)"));
  CHECK(errorsIn(treeOf("<Action ID=\"Script\"/>")) ==
        "main.xml:3:1: `Script` needs an attribute `code`\n");
  // Nav2 has a condition with this name; here it is an action.
  CHECK(contains(textOf(treeOf("<Action ID=\"GoalReached\"/>")), "(defskill GoalReached"));
}

TEST_CASE("ports have the values that TreeNodesModel gives them by default") {
  const auto model = [](const std::string& models) {
    return "</BehaviorTree><TreeNodesModel>" + models + "</TreeNodesModel>\n";
  };
  const auto tree = [&](const std::string& nodes, const std::string& models) {
    return textOf(
        rooted("<BehaviorTree ID=\"Main\"><Sequence>\n" + nodes + "</Sequence>\n" + model(models)));
  };
  const std::string drive = "<Action ID=\"Drive\"><input_port name=\"speed\" default=\"3\"/>"
                            "<input_port name=\"to\"/><inout_port name=\"pose\" default=\"{=}\"/>"
                            "<output_port name=\"log\" default=\"none\"/>"
                            "<output_port name=\"end\" default=\"{here}\"/></Action>";
  // An output has its default only if that is an entry of the blackboard.
  CHECK(contains(tree("<Drive/>", drive), ":action (Drive \"{here}\" \"{pose}\" \"3\")"));
  CHECK(contains(tree("<Drive speed=\"\" end=\"{x}\" log=\"{y}\"/>", drive),
                 ":action (Drive \"{x}\" \"{y}\" \"{pose}\" \"\")"));
  // Conditions with the same ports are one.
  const std::string near = "<Condition ID=\"Near\"><input_port name=\"at\" default=\"2\"/>"
                           "</Condition>";
  CHECK_FALSE(contains(tree("<Near/><Near at=\"2\"/>", near), "(defsv Near_2"));
  CHECK(contains(tree("<Near/><Near at=\"3\"/>", near), "(defsv Near_2"));
}

TEST_CASE("subtrees need a value for each port that has none by default") {
  const auto files = [](const std::string& use, const std::string& format = "4") {
    return "<root BTCPP_format=\"" + format +
           "\" main_tree_to_execute=\"Main\"><BehaviorTree ID=\"Main\">\n" + use +
           "</BehaviorTree><BehaviorTree ID=\"Go\"><Drive to=\"{to}\" by=\"{by}\"/>"
           "</BehaviorTree><TreeNodesModel><SubTree ID=\"Go\"><input_port name=\"to\"/>"
           "<input_port name=\"by\" default=\"road\"/></SubTree></TreeNodesModel></root>";
  };
  CHECK(errorsIn(files("<SubTree ID=\"Go\"/>")) ==
        "main.xml:2:1: `Go` needs a value for its port `to`: `TreeNodesModel` declares it without "
        "a default\n");
  CHECK(contains(textOf(files("<SubTree ID=\"Go\" to=\"{=}\"/>")), "(Drive \"road\" \"{to}\")"));
  CHECK(contains(textOf(files("<SubTree ID=\"Go\" to=\"home\" by=\"{way}\"/>")),
                 "(Drive \"{way}\" \"home\")"));
  // Remapped ports have no default, and version 3 has no models of subtrees.
  CHECK(contains(textOf(files("<SubTree ID=\"Go\" _autoremap=\"True\"/>")),
                 "(Drive \"{by}\" \"{to}\")"));
  CHECK(errorsIn(files("<SubTree ID=\"Go\"/>", "3")) == "none");
}

TEST_CASE("a port with the value {=} is the entry of its name in its own subtree") {
  const auto text = textOf(rooted(
      "<BehaviorTree ID=\"Main\"><Sequence><SubTree ID=\"Go\"/><SubTree ID=\"Go\"/></Sequence>"
      "</BehaviorTree><BehaviorTree ID=\"Go\"><Condition ID=\"At\" x=\"{=}\"/></BehaviorTree>",
      " main_tree_to_execute=\"Main\""));
  CHECK(contains(text, "(defsv At_2"));
}

} // namespace read_as_btcpp
