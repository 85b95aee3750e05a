#include "tests/bridge/import/trees.h"

#include <catch2/catch.hpp>

using namespace proskill;
using namespace proskill::test;
using bridge::Leaves;
using bridge::bt::importTree;
using test::trees::contains;

namespace {

/// A tree without the attribute that says version 4.
std::string oldTree(const std::string& node, const std::string& after = "") {
  return "<root main_tree_to_execute=\"Main\"><BehaviorTree ID=\"Main\">\n" + node +
         "</BehaviorTree>\n" + after + "</root>\n";
}

/// Without comments, which name places and types.
std::string textOf(const std::string& xml) {
  auto text = trees::textOf(xml);
  for (auto at = text.find(';'); at != std::string::npos; at = text.find(';', at))
    text.erase(at, text.find('\n', at) - at);
  return text;
}

} // namespace

TEST_CASE("a file may say that it is of version 3") {
  const std::string xml = "<root BTCPP_format=\"3\"><BehaviorTree><A/></BehaviorTree></root>";
  const auto imported = importTree(MemoryFiles({{"main.xml", xml}}), "main.xml", Leaves(), {});
  REQUIRE(imported);
  CHECK(imported->summary[0] == "`BTCPP_format` is not 4: read as version 4");
}

TEST_CASE("nodes of version 3 are read under their old names") {
  const auto old =
      textOf(oldTree("<RetryUntilSuccessful num_attempts=\"2\"><SequenceStar name=\"s\">"
                     "<A/><B/></SequenceStar></RetryUntilSuccessful>"));
  CHECK(contains(old, "(if (= s_at 0)"));
  CHECK(contains(old, "(set (s_at 1))"));
  CHECK(contains(textOf(oldTree("<RetryUntilSuccesful num_attempts=\"3\"><A/>"
                                "</RetryUntilSuccesful>")),
                 "_count 3)"));
}

TEST_CASE("a type may be in the attribute `ID` of `Control` and `Decorator`") {
  const auto text = textOf(oldTree("<Control ID=\"Fallback\"><Decorator ID=\"Inverter\"><A/>"
                                   "</Decorator><B/></Control>"));
  const auto brief = textOf(oldTree("<Fallback><Inverter><A/></Inverter><B/></Fallback>"));
  CHECK(text == brief);
}

TEST_CASE("the thresholds of a Parallel have their names of version 3") {
  const auto parallel = [](const std::string& ports) {
    return textOf(oldTree("<Parallel name=\"p\" " + ports + "><A/><B/><C/></Parallel>"));
  };
  CHECK(parallel("success_threshold=\"1\" failure_threshold=\"2\"") ==
        parallel("success_count=\"1\" failure_count=\"2\""));
  CHECK(parallel("threshold=\"2\"") == parallel("success_count=\"2\" failure_count=\"2\""));
  CHECK(parallel("success_threshold=\"1\"") != parallel(""));
  CHECK(parallel("success_threshold=\"1\" failure_threshold=\"2\"") !=
        parallel("success_threshold=\"1\""));
}

TEST_CASE("subtrees share the entries outside as they did in version 3") {
  const std::string at = "<Condition ID=\"At\" place=\"${goal}\"/>";
  const auto program = [&](const std::string& attribute) {
    return textOf(oldTree("<Sequence>" + at + "<SubTree ID=\"T\" " + attribute + "/></Sequence>",
                          "<BehaviorTree ID=\"T\"><Sequence>" + at +
                              "<A/></Sequence>"
                              "</BehaviorTree>"));
  };
  CHECK(contains(program(""), "(defsv At_2\n"));
  CHECK_FALSE(contains(program("__shared_blackboard=\"true\""), "(defsv At_2\n"));
  CHECK_FALSE(contains(program("__autoremap=\"true\""), "(defsv At_2\n"));
}

TEST_CASE("ports of models may have descriptions") {
  const std::string model = "<TreeNodesModel><Condition ID=\"X\"><input_port name=\"p\">what it "
                            "means</input_port></Condition></TreeNodesModel>";
  CHECK(contains(textOf(oldTree("<X/>", model)), "(defskill Main"));
}
