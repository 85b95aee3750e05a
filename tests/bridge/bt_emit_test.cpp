#include "analysis/program/program.h"
#include "bridge/bt/emit/emit.h"
#include "bridge/bt/import.h"
#include "bridge/bt/read/read.h"
#include "bridge/bt/tree/expand.h"
#include "tests/bridge/errors_text.h"
#include "tests/bridge/random_mission.h"
#include "tests/bridge/verdicts.h"
#include "tests/support/memory_files.h"
#include "tests/support/random/seeds.h"

#include <catch2/catch.hpp>

#include <fmt/format.h>

using namespace proskill;
using namespace proskill::test;

namespace {

std::expected<bridge::bt::EmittedTree, bridge::Errors> emitted(const std::string& text) {
  const MemoryFiles files({{"p", text}});
  const auto program = analysis::load(files, "p");
  for (const auto& finding : analysis::check(program))
    if (finding.severity == syntax::Severity::Error) FAIL(finding.message << "\n" << text);
  return bridge::bt::emitTree(program, "Main");
}

/// The skills a0, a0_2, … of an imported program stand for a0.
Copies copiesIn(const std::string& text) {
  Copies copies;
  for (std::size_t at = text.find("(defskill a"); at != std::string::npos;
       at = text.find("(defskill a", at + 1)) {
    const auto begin = at + std::string_view("(defskill ").size();
    const auto name = text.substr(begin, text.find_first_of(" \n", begin) - begin);
    copies[name.substr(0, 2)].push_back(name);
  }
  return copies;
}

void nameActions(bridge::bt::Node& node) {
  if (node.kind == bridge::bt::Kind::Action) node.name = node.id;
  for (auto& child : node.children) nameActions(child);
}

/// What an interpreter of ticks sees of a tree.
std::optional<Observed> ticked(const MemoryFiles& files, const bridge::Leaves& leaves) {
  auto tree = bridge::bt::expand(*bridge::bt::read(files, "t.xml"));
  nameActions(*tree);
  return observe(*tree, leaves, 1'000);
}

struct Trips {
  std::size_t exact = 0;
  std::size_t approximate = 0;
  std::size_t refused = 0;
  std::size_t tooLarge = 0;
};

void roundTrip(std::uint64_t seed, Trips& counts) {
  const auto program = randomMission(seed);
  const auto tree = emitted(program);
  if (!tree) return static_cast<void>(++counts.refused);
  INFO("seed " << seed << "\n" << program << "\n" << tree->tree.text);
  const auto leaves = bridge::Leaves::read(tree->leaves);
  REQUIRE(leaves);
  const MemoryFiles files({{"t.xml", tree->tree.text}});
  const auto imported = bridge::bt::importTree(files, "t.xml", *leaves, {});
  INFO(errorsText(imported));
  REQUIRE(imported);
  const auto copies = copiesIn(imported->text);
  Copies originals;
  for (const auto& [name, all] : copies) originals[name] = {name};
  const auto before = verified(program + questions(originals, false));
  const auto after = verified(imported->text + questions(copies, false));
  const auto ticks = ticked(files, *leaves);
  if (!before || !after || !ticks) return static_cast<void>(++counts.tooLarge);
  ++(imported->exact ? counts.exact : counts.approximate);
  INFO(imported->text << "\nbefore: " << inWords(*before) << "\nafter:  " << inWords(*after)
                      << "\nticked: " << inWords(*ticks));
  const bool mayRefuse = program.contains(":precondition"); // the leaf runs, and fails
  const bool isTimed = program.contains("(^ 1)"); // the interpreter does not compare times
  if (!isTimed && !mayRefuse) REQUIRE(*ticks == *before);
  REQUIRE(covers(*ticks, *before));
  if (imported->exact && !mayRefuse) REQUIRE(*after == *before);
  REQUIRE(covers(*after, *before));
}

} // namespace

TEST_CASE("a mission that is written as a tree and imported keeps its verdicts") {
  Trips counts;
  const auto seeds = seedsOr(1, 400);
  for (auto seed = seeds.first; seed < seeds.end; ++seed) roundTrip(seed, counts);
  CAPTURE(counts.exact, counts.approximate, counts.refused, counts.tooLarge);
  const auto all = seeds.end - seeds.first;
  CHECK((counts.exact + counts.approximate) * 5 >= all * 4);
  CHECK(counts.exact * 4 >= all);
}

namespace {

constexpr auto kSkills = "(defsv c :states (Yes No) :init Yes)\n"
                         "(defevent on :effects (c Yes))\n"
                         "(defevent off :effects (c No))\n"
                         "(defsv n :init 0 :min 0 :max 3)\n"
                         "(defskill a :time_interval [1,2] :action (a) :success ok :failure bad)\n"
                         "(defskill b :input ($x float) :action (b) :success ok)\n";

std::string withMain(const std::string& body) {
  return kSkills + ("(defskill Main :success ok :failure bad :body (" + body + "))\n");
}

/// The lines of the tree of `Main`, without white space around them.
std::string writtenAs(const std::string& body) {
  const auto tree = emitted(withMain(body));
  INFO(errorsText(tree));
  REQUIRE(tree);
  const auto& xml = tree->tree.text;
  const auto begin = xml.find("<BehaviorTree ID=\"Main\">\n") + 26;
  std::string text;
  bool isIndent = true;
  for (const char c : xml.substr(begin, xml.find("</BehaviorTree>") - begin)) {
    if (!isIndent || c != ' ') text += c;
    isIndent = c == '\n' || (isIndent && c == ' ');
  }
  std::erase(text, '\n');
  return text;
}

std::string refused(const std::string& body) { return errorsText(emitted(withMain(body))); }

} // namespace

TEST_CASE("statements become nodes") {
  CHECK(writtenAs("(a) (b x 2.5)") == "<Sequence><ForceSuccess><Action ID=\"a\"/></ForceSuccess>"
                                      "<Action ID=\"b\" x=\"2.5\"/></Sequence>");
  CHECK(writtenAs("(a) (if (/= a.status success) (failure bad)) (b x 1) (success ok)") ==
        "<Sequence><Action ID=\"a\"/><Action ID=\"b\" x=\"1\"/></Sequence>");
  CHECK(writtenAs("(a) (if (= a.status success) (success ok)) (b x 1) (failure bad)") ==
        "<Fallback><Action ID=\"a\"/><Sequence><Action ID=\"b\" x=\"1\"/><AlwaysFailure/>"
        "</Sequence></Fallback>");
  CHECK(writtenAs("(if (c No) (a) else (^ 1.5))") ==
        "<IfThenElse><Inverter><Condition ID=\"c\"/></Inverter>"
        "<ForceSuccess><Action ID=\"a\"/></ForceSuccess><Sleep msec=\"1500\"/></IfThenElse>");
  CHECK(writtenAs("(label again) (a) (if (= a.status failure) (goto again))") ==
        "<RetryUntilSuccessful num_attempts=\"-1\"><Action ID=\"a\"/></RetryUntilSuccessful>");
  CHECK(writtenAs("(race ((a)) ((^ 5)))") ==
        "<Parallel success_count=\"1\" failure_count=\"1\"><ForceSuccess><Action ID=\"a\"/>"
        "</ForceSuccess><Sleep msec=\"5000\"/></Parallel>");
  CHECK(writtenAs("(set (n 1)) (if (> n 2) (a))") ==
        "<Sequence><Script code=\"@n := 0\"/><Script code=\"@n := 1\"/><Fallback><Inverter>"
        "<ScriptCondition code=\"@n &gt; 2\"/></Inverter><ForceSuccess><Action ID=\"a\"/>"
        "</ForceSuccess></Fallback></Sequence>");
}

TEST_CASE("a loop that counts its rounds is a node") {
  const std::string retry = "<RetryUntilSuccessful num_attempts=\"3\"><Action ID=\"a\"/>"
                            "</RetryUntilSuccessful>";
  CHECK(writtenAs("(set (n 0)) (while (< n 3) (b x 1) (set (n (+ n 1))))") ==
        "<Repeat num_cycles=\"3\"><Action ID=\"b\" x=\"1\"/></Repeat>");
  CHECK(writtenAs("(set (n 0)) (while (< n 3) (a) (if (= a.status success) (success ok)) "
                  "(set (n (+ n 1)))) (failure bad)") == retry);
  CHECK(writtenAs("(set (n 0)) (label l) (a) (if (= a.status success) (success ok)) "
                  "(set (n (+ n 1))) (if (< n 3) (goto l)) (failure bad)") == retry);
  CHECK(writtenAs("(set (n 0)) (label l) (a) (if (= a.status success) (success ok)) "
                  "(if (>= n 2) (failure bad)) (^ 1) (set (n (+ n 1))) (goto l)") ==
        "<RecoveryNode number_of_retries=\"2\"><Action ID=\"a\"/><Sleep msec=\"1000\"/>"
        "</RecoveryNode>");
}

TEST_CASE("a loop whose number is used elsewhere, or too small to count, is no such node") {
  const std::string loop = "(set (n 0)) (while (< n 3) (a) (set (n (+ n 1))))";
  CHECK(writtenAs(loop + " (if (> n 2) (a))").contains("<ScriptCondition code=\"@n &lt; 3\"/>"));
  CHECK(writtenAs("(set (n 0)) (while (< n 4) (a) (set (n (+ n 1))))")
            .contains("num_attempts=\"-1\""));
  CHECK(writtenAs("(set (n 1)) (while (< n 3) (a) (set (n (+ n 1))))")
            .contains("num_attempts=\"-1\""));
}

TEST_CASE("a branch that may end at once comes last, since a tick starts none after it") {
  const auto tree = writtenAs("(// ((if (c Yes) (success ok)) (^ 1)) ((a)))");
  CHECK(tree.find("<Action ID=\"a\"") < tree.find("<Condition ID=\"c\""));
}

TEST_CASE("what a tree cannot say is an error with its place") {
  const auto at = [](const std::string& column, const std::string& what) {
    return "p:7:" + column + ": a tree cannot say this: " + what + "\n";
  };
  CHECK(refused("(^ [1,2])") == at("51", "a time that is not a number of milliseconds"));
  CHECK(refused("(label l) (if (c No) (goto l))") ==
        at("48", "a loop that may repeat without any time"));
  CHECK(refused("(// ((a)) ((a)))") == at("48", "two branches that call `a`"));
  CHECK(refused("(a) (b x 1) (if (= a.status success) (failure bad))") ==
        at("64", "the status of a call that is not tested right after the call, by itself"));
  CHECK(refused("(if (or (c Yes) (c No)) (a))") == at("67", "two tests of `c` in one instant"));
  CHECK(refused("(a.interrupt)") == at("48", "an interruption of a skill"));
  CHECK(refused("(if (c No) (^ [1,2]) (success ok)) (a.interrupt)") ==
        at("62", "a time that is not a number of milliseconds") +
            at("83", "an interruption of a skill"));
  const std::string refusing = "(defskill a :precondition (p true) :action (a) :success ok)\n";
  CHECK(errorsText(
            emitted(refusing + "(defskill Main :body ((a) (if (= a.status no_status) (a))))")) ==
        "p:2:27: a tree cannot say this: a test that distinguishes several ways to fail\n");
  CHECK(errorsText(emitted(refusing + "(defskill b :precondition (p true) :body ((a)))\n"
                                      "(defskill Main :body ((b)))")) ==
        "p:2:28: a tree cannot say this: a precondition\n");
}

TEST_CASE("the guards of a composite skill are tested at each tick") {
  const auto said = [](const std::string& guard, const std::string& body) {
    return errorsText(emitted(kSkills + ("(defskill part :invariant (calm " + guard +
                                         ") :body ((a)))\n(defskill Main :body (" + body + "))")));
  };
  const auto tree = emitted(kSkills + std::string("(defskill Main :invariant (calm (:guard (and (c "
                                                  "Yes) true))) :body ((a)))"));
  REQUIRE(tree);
  CHECK(tree->tree.text.contains("    <ReactiveSequence>\n"
                                 "      <Condition ID=\"c\"/>\n"
                                 "      <ForceSuccess>\n"));
  CHECK(said("(:guard (c Yes))", "(part)") == "none");
  CHECK(said("(:guard (c Yes))", "(part) (if (c No) (a))") ==
        "p:7:42: a tree cannot say this: a guard with `c`, which is tested elsewhere, too\n");
  CHECK(said("(:guard (= n 1))", "(set (n 1)) (part)") ==
        "p:7:44: a tree cannot say this: a guard with `n`, which skills change\n");
  CHECK(said("(:guard (c Yes) :effects (n 1))", "(part)") ==
        "p:7:58: a tree cannot say this: an effect of a composite skill\n");
}

TEST_CASE("a test of an input is an error with its place") {
  const auto tested = [](const std::string& condition) {
    return errorsText(emitted("(defskill walk :input ($fast bool) :action (walk))\n"
                              "(defskill go :input ($fast bool) :body ((if " +
                              condition + " (walk fast $fast))))\n" +
                              "(defskill Main :body ((go fast true)))"));
  };
  CHECK(tested("true") == "none");
  CHECK(tested("$fast") == "p:2:45: a tree cannot say this: a test of an input\n");
  CHECK(tested("(= $fast true)") == "p:2:45: a tree cannot say this: a test of an input\n");
}

TEST_CASE("a string that a port would read as an entry of the blackboard is an error") {
  const auto said = [](const std::string& text) {
    return errorsText(emitted("(defskill say :input ($s string) :action (say) :success ok)\n"
                              "(defskill Main :body ((say s \"" +
                              text + "\")))"));
  };
  CHECK(said("{k}") == "p:2:28: a tree cannot say this: a string in braces, which a port reads as "
                       "an entry\n");
  CHECK(said("{k} ") != "none");
  CHECK(said("{k} and {l") == "none");
}

TEST_CASE("a long body is written, and one with too many loops in a row is an error") {
  std::string calls;
  std::string jumps;
  for (int i = 0; i < 10'000; ++i) calls += "(a)\n";
  for (int i = 0; i < 2000; ++i)
    jumps += fmt::format("(label l{0}) (a) (if (/= a.status success) (goto l{0}))\n", i);
  CHECK(refused(calls) == "none");
  CHECK(refused(jumps).ends_with("statements that are nested so deeply\n"));
}

TEST_CASE("what follows both results of a call is written once") {
  CHECK(writtenAs("(a) (if (= a.status no_status) (^ 1) else (b x 1))") ==
        "<Sequence><ForceSuccess><Action ID=\"a\"/></ForceSuccess><Action ID=\"b\" x=\"1\"/>"
        "</Sequence>");
  std::string nested = "(a)";
  for (int i = 0; i < 40; ++i) nested = "(a) (if (= a.status no_status) (^ 1) else " + nested + ")";
  CHECK(refused(nested) == "none");
}

TEST_CASE("branches that are nested deeply are written without trying all ways through them") {
  std::string nested = "(^ 1)";
  for (int i = 0; i < 60; ++i) nested = fmt::format("(// ({}) ((^ 2)))", nested);
  CHECK(refused(nested) == "none");
}

TEST_CASE("a composite skill with the name of a built-in node is renamed, a leaf is an error") {
  const std::string main = "(defskill Main :body ((Timeout)))";
  const auto tree = emitted("(defskill a :action (a) :success ok)\n"
                            "(defskill Timeout :body ((a)))\n" +
                            main);
  REQUIRE(tree);
  CHECK(tree->tree.text.contains("<SubTree ID=\"Timeout_tree\"/>"));
  CHECK(tree->tree.text.contains("<BehaviorTree ID=\"Timeout_tree\">"));
  CHECK(errorsText(emitted("(defskill Timeout :action (a) :success ok)\n" + main)) ==
        "p:1:11: a tree cannot say this: a skill with the name of a built-in node\n");
}

TEST_CASE("each condition of a tree has an id of its own") {
  const auto answer = [](const std::string& name) {
    return fmt::format("(defsv {0} :states (Yes No) :init Yes)\n(defevent {0}_on :effects ({0} "
                       "Yes))\n(defevent {0}_off :effects ({0} No))\n",
                       name);
  };
  const std::string door = "(defsv door :states (Open Shut) :init Open)\n"
                           "(defevent opens :effects (door Open))\n"
                           "(defevent shuts :effects (door Shut))\n"
                           "(defskill a :action (a) :success ok)\n";
  const auto written = [&](const std::string& definitions, const std::string& body) {
    const auto tree =
        emitted(definitions + door + "(defskill Main :success ok :body (" + body + "))");
    INFO(errorsText(tree));
    REQUIRE(tree);
    const MemoryFiles files({{"t.xml", tree->tree.text}});
    const auto imported =
        bridge::bt::importTree(files, "t.xml", *bridge::Leaves::read(tree->leaves), {});
    CHECK(errorsText(imported) == "none");
    return tree->tree.text.substr(tree->tree.text.find("<TreeNodesModel>"));
  };
  const auto model = [](const std::string& action, const std::string& first,
                        const std::string& second) {
    return fmt::format("<TreeNodesModel>\n    <Action ID=\"{}\"/>\n    <Condition ID=\"{}\"/>\n"
                       "{}  </TreeNodesModel>\n</root>\n",
                       action, first,
                       second.empty() ? "" : "    <Condition ID=\"" + second + "\"/>\n");
  };
  CHECK(written(answer("IsStuck") + answer("IsStuck_leaf"),
                "(if (and (IsStuck Yes) (IsStuck_leaf No)) (a))") ==
        model("a", "IsStuck_leaf", "IsStuck_leaf_"));
  CHECK(written(answer("door_is_Open"), "(if (and (door Open) (door_is_Open No)) (a))") ==
        model("a", "door_is_Open", "door_is_Open_"));
  CHECK(written("(defskill door_is_Open :action (b) :success ok)\n",
                "(if (door Shut) (door_is_Open))") == model("door_is_Open", "door_is_Open_", ""));
  CHECK(written("(defskill door_is_Open :success ok :body ((a)))\n",
                "(if (door Open) (door_is_Open))") == model("a", "door_is_Open_", ""));
}

TEST_CASE("what a tree lacks is noted with its place") {
  const auto tree =
      emitted(withMain("(printf \"hi\") (a)") + "(defproperty ends (reachable (ended Main)))\n");
  REQUIRE(tree);
  std::string notes;
  for (const auto& note : tree->tree.notes)
    notes += fmt::format("{}:{} {}\n", note.place.line, note.place.column, note.message);
  CHECK(notes ==
        "7:48 not in the tree: a message\n6:11 not in the tree: a skill that is not called\n"
        "8:14 not in the tree: a property\n");
  CHECK(tree->leaves == "{\n  \"leaves\": {\n    \"a\": {\n      \"duration\": [\n        1.0,\n"
                        "        2.0\n      ]\n    }\n  }\n}\n");
}
