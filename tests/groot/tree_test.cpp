#include "tests/groot/watched_run.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

using namespace proskill;
using test::WatchedRun;

TEST_CASE(
    "a body is a tree of the same structure, and each call of a composite skill has its own") {
  const WatchedRun it(R"(
    (defsv x :states (A B) :init A :transitions :all)
    (defskill fly :input ($name string) :action (fly $name) :success there :failure lost)
    (defskill search :success found :body ((fly name "home") (set (x B)) (success found)))
    (defskill mission :body (
      (// ((search)) ((^ 2) (fly.interrupt)))
      (if (= fly.status success) (search) elseif (x A) (printf "no <luck>"))
      (while (x A) (label again) (goto again)))))");
  constexpr auto kXml = R"xml(<?xml version="1.0" encoding="UTF-8"?>
<root BTCPP_format="4" main_tree_to_execute="mission">
  <BehaviorTree ID="mission" _fullpath="">
    <Sequence name="Sequence" _uid="1">
      <Parallel name="Parallel" failure_count="1" _uid="2">
        <SubTree ID="search" _fullpath="search::3" _uid="3"/>
        <Sequence name="Sequence" _uid="4">
          <WaitFor name="WaitFor" statement="(^ 2)" _uid="5"/>
          <Interrupt name="Interrupt" statement="(fly.interrupt)" _uid="6"/>
        </Sequence>
      </Parallel>
      <IfThenElse name="IfThenElse" _uid="7">
        <Test name="Test" condition="(= fly.status success)" _uid="8"/>
        <SubTree ID="search" _fullpath="search::9" _uid="9"/>
        <IfThenElse name="IfThenElse" _uid="10">
          <Test name="Test" condition="(x A)" _uid="11"/>
          <Print name="Print" message="no &lt;luck&gt;" _uid="12"/>
        </IfThenElse>
      </IfThenElse>
      <Repeat name="Repeat" num_cycles="-1" _uid="13">
        <Sequence name="Sequence" _uid="14">
          <Test name="Test" condition="(x A)" _uid="15"/>
          <Goto name="Goto" label="again" _uid="16"/>
        </Sequence>
      </Repeat>
    </Sequence>
  </BehaviorTree>
  <BehaviorTree ID="search" _fullpath="search::3">
    <Sequence name="Sequence" _uid="17">
      <fly name="fly" of_name="&quot;home&quot;" _uid="18"/>
      <Set name="Set" statement="(set (x B))" _uid="19"/>
      <Succeed name="Succeed" with="found" _uid="20"/>
    </Sequence>
  </BehaviorTree>
  <BehaviorTree ID="search" _fullpath="search::9">
    <Sequence name="Sequence" _uid="21">
      <fly name="fly" of_name="&quot;home&quot;" _uid="22"/>
      <Set name="Set" statement="(set (x B))" _uid="23"/>
      <Succeed name="Succeed" with="found" _uid="24"/>
    </Sequence>
  </BehaviorTree>
  <TreeNodesModel>
    <Action ID="Goto">
      <input_port name="label"/>
    </Action>
    <Action ID="Interrupt">
      <input_port name="statement"/>
    </Action>
    <Action ID="Print">
      <input_port name="message"/>
    </Action>
    <Action ID="Set">
      <input_port name="statement"/>
    </Action>
    <Action ID="Succeed">
      <input_port name="with"/>
    </Action>
    <Condition ID="Test">
      <input_port name="condition"/>
    </Condition>
    <Action ID="WaitFor">
      <input_port name="statement"/>
    </Action>
    <Action ID="fly">
      <input_port name="of_name"/>
    </Action>
  </TreeNodesModel>
</root>
)xml";
  CHECK(groot::xmlOf(it.tree) == kXml);
}

TEST_CASE("monitors are beside the mission, in a tree with a name of its own") {
  const WatchedRun it(R"(
    (defsv x :states (A B) :init A :transitions :all)
    (defskill program :body ((^ 1)))
    (defskill watch :monitor t :body ((^ (x B)))))");
  CHECK(it.tree.name() == "program_");
  REQUIRE(it.tree.instances.size() == 3);
  CHECK(it.tree.instances[1].path == "program::2");
  CHECK(it.tree.instances[2].path == "watch::3");
  CHECK(it.tree.mission == 1);
}

TEST_CASE("a skill with the name of another node has another tag") {
  const WatchedRun it(R"(
    (defskill Sequence :action (go))
    (defskill Test :action (go))
    (defskill mission :body ((Sequence) (Test))))");
  CHECK(it.tagged("Sequence_skill").size() == 1);
  CHECK(it.tagged("Test_skill").size() == 1);
}

TEST_CASE("a tree that viewers cannot number is refused") {
  std::string text = "(defskill s0 :body ((^ 1)))";
  for (int i = 1; i < 17; ++i)
    text += "(defskill s" + std::to_string(i) + " :body ((s" + std::to_string(i - 1) + ") (s" +
            std::to_string(i - 1) + ")))";
  const auto program = test::programOfText(text);
  const auto executable = runtime::makeExecutable(program, "", true);
  REQUIRE(executable);
  const auto tree = groot::treeOf(program, **executable);
  REQUIRE(!tree);
  CHECK(tree.error().find("more than 65535 nodes") != std::string::npos);
}

TEST_CASE("without a composite skill there is no tree") {
  const auto program = test::programOfText("(defskill fly :action (fly))");
  const auto executable = runtime::makeExecutable(program, "", true);
  REQUIRE(executable);
  CHECK(groot::treeOf(program, **executable).error() == "no composite skill is executed");
}
