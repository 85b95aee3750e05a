#include "analysis/program/program.h"
#include "bridge/rl/emit.h"
#include "bridge/rl/import.h"
#include "tests/bridge/errors_text.h"
#include "tests/support/memory_files.h"

#include <catch2/catch.hpp>

using namespace proskill;
using namespace proskill::test;
using bridge::rl::importSkillsets;

namespace rl_import {

namespace {

const std::string kResource = "resource r {\n state { A B }\n initial A\n transition all\n}\n";

std::string skillset(const std::string& inner) { return "skillset s {\n" + inner + "\n}\n"; }

std::string errorsIn(const std::map<std::string, std::string>& files) {
  return errorsText(importSkillsets(MemoryFiles(files), "main.rl", {}));
}

std::string errorsIn(const std::string& text) { return errorsIn({{"main.rl", text}}); }

bridge::Imported importedOf(const std::string& text) {
  const auto imported = importSkillsets(MemoryFiles({{"main.rl", text}}), "main.rl", {});
  if (!imported) FAIL(errorsIn(text));
  return *imported;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("a skillset becomes state variables, events and basic skills") {
  const auto imported = importedOf(skillset(kResource + R"(
data d: Pose period 1.0
event e { guard r == A and not r != A effect r -> B }
skill k {
  input { x: Float p: geometry_msgs::Pose }
  output y: Float
  precondition { free: r == A or r == B => true }
  start r -> B
  invariant busy { guard r == B effect { r -> A } }
  progress { period 2 sec message y: Float }
  interrupt { interrupting true effect r -> A }
  success { ok { effect r -> A postcondition r == A } fine {} }
  failure ko { effect r -> A }
})"));
  CHECK(imported.text == R"(; The skillsets of main.rl, by `proskill import rl`.

; from main.rl:2:10 resource r
(defsv r
  :states (A B)
  :init A
  :transitions :all)

; from main.rl:9:7 event e
(defevent e
  :guard (and (r A) (not (/= r A)))
  :effects (r B))

; from main.rl:10:7 skill k
(defskill k
  :input ($x float $p string)
  :precondition (free (=> (or (r A) (r B)) true))
  :start (r B)
  :invariant (busy (:guard (r B)
                    :effects (r A)))
  :action (k $x $p)
  :interrupt (:effects (r A))
  :success (ok (:effects (r A)
                :postcondition (r A))
            fine)
  :failure (ko (:effects (r A))))
)");
  CHECK(imported.exact);
  REQUIRE(imported.summary.size() == 3);
  CHECK(imported.summary[0] == "not in the program, and without influence on verdicts: 1 datum or "
                               "parameter, 1 output, 1 progress");
  CHECK(contains(imported.summary[2], "verdicts are exact"));
}

TEST_CASE("the other dialect writes durations without a unit and outputs of a progress") {
  CHECK(importedOf(skillset(kResource + "skill k { progress { period 1.0 output d: Float }\n"
                                        "interrupt { interrupting false } success ok { } }"))
            .exact);
}

TEST_CASE("a byte order mark and the ends of lines of Windows are read") {
  const auto plain = importedOf(skillset(kResource));
  CHECK(importedOf("\xEF\xBB\xBFskillset s {\r\n" + kResource + "\r\n}\r\n").text == plain.text);
}

TEST_CASE("several skillsets become one program, whose names say where they come from") {
  const auto text =
      importedOf("type T skillset a {" + kResource + "event go { effect r -> B } }\n" +
                 "skillset b<T> { " + kResource + "event go { guard r == B effect r -> A } }")
          .text;
  CHECK(contains(text, "(defsv a_r\n"));
  CHECK(contains(text, "(defevent b_go\n  :guard (b_r B)\n  :effects (b_r A))"));
}

TEST_CASE("errors in skillsets have places") {
  CHECK(errorsIn("") == "main.rl:1:1: there is no `skillset`\n");
  CHECK(errorsIn("skillset s {") == "main.rl:1:13: expected `}`, found the end of the file\n");
  CHECK(errorsIn("skillset s { go }") ==
        "main.rl:1:14: expected `parameter`, `data`, `resource`, `event` or `skill`, found `go`\n");
  CHECK(errorsIn(skillset("resource r { initial A }")) ==
        "main.rl:2:10: this resource needs `state { … }`\n");
  CHECK(errorsIn(skillset(kResource + "event e { guard q == A effect r -> C }")) ==
        "main.rl:7:17: unknown resource `q`\nmain.rl:7:36: `C` is not a state of `r`\n");
  CHECK(errorsIn(skillset(kResource + kResource)) ==
        "main.rl:7:10: a second resource is called `r`\n");
  CHECK(errorsIn(skillset(kResource + "event e { effect { r -> A r -> B } }")) ==
        "main.rl:7:27: `r` is set twice in one step\n");
  CHECK(errorsIn(skillset(kResource + "event e { guard r = A }")) ==
        "main.rl:7:19: expected `==`, found `=`\n");
  CHECK(errorsIn("/* never") == "main.rl:1:1: this comment is never closed\n");
  CHECK(errorsIn(skillset(kResource + "skill k { invariant i { effect r -> A } }")) ==
        "main.rl:7:21: this invariant needs a `guard`\n");
}

TEST_CASE("what may be there once in a skillset is not overwritten by a second one") {
  const auto secondIn = [](const std::string& inner) {
    return errorsIn(skillset(kResource + inner));
  };
  CHECK(secondIn("event e { guard r == A guard r == B effect r -> A }") ==
        "main.rl:7:24: a second `guard`\n");
  CHECK(secondIn("resource q { state { A B } initial A initial B transition all }") ==
        "main.rl:7:38: a second `initial`\n");
  CHECK(secondIn("resource q { state { A B } initial A transition all transition { A -> B } }") ==
        "main.rl:7:53: a second `transition`\n");
  CHECK(secondIn("skill k { invariant i { guard r == A guard r == B } }") ==
        "main.rl:7:38: a second `guard`\n");
  CHECK(secondIn("skill k { success s { postcondition r == A postcondition r == B } }") ==
        "main.rl:7:44: a second `postcondition`\n");
  CHECK(secondIn("skill k { interrupt { interrupting true } interrupt { effect r -> A } }") ==
        "main.rl:7:43: a second `interrupt`\n");
  CHECK(secondIn("skill k { success s { } success s { effect r -> A } }") ==
        "main.rl:7:33: a second success is called `s`\n");
  CHECK(secondIn("event e { effect r -> A } event e { effect r -> B }") ==
        "main.rl:7:33: a second event is called `e`\n");
  CHECK(secondIn("skill k { } skill k { }") == "main.rl:7:19: a second skill is called `k`\n");
  CHECK(errorsIn(skillset(kResource) + skillset(kResource)) ==
        "main.rl:9:10: a second skillset is called `s`\n");
}

TEST_CASE("files include each other, but not themselves") {
  const auto other = "skillset o { " + kResource + " }";
  const auto both =
      importSkillsets(MemoryFiles({{"main.rl", "include \"sub/o.rl\"\n" + skillset(kResource)},
                                   {"sub/o.rl", other}}),
                      "main.rl", {});
  REQUIRE(both);
  CHECK(contains(both->text, "; from sub/o.rl:1:23 resource r\n(defsv o_r\n"));
  CHECK(errorsIn({{"main.rl", "include \"main.rl\""}}) ==
        "main.rl:1:9: `main.rl` includes itself\n");
  CHECK(errorsIn({{"main.rl", "include \"/etc/passwd\""}}) ==
        "main.rl:1:9: the path of `include` must be relative\n");
  CHECK(contains(errorsIn({{"main.rl", "include \"no.rl\""}}), "cannot read `no.rl`"));
}

TEST_CASE("input that is too deep or too large ends in an error of a skillset") {
  const std::string open(100'000, '(');
  CHECK(contains(errorsIn(skillset(kResource + "event e { guard " + open)), "nested too deeply"));
  std::string arrows = "r == A";
  for (int i = 0; i < 1000; ++i) arrows += " => r == A";
  CHECK(contains(errorsIn(skillset(kResource + "event e { guard " + arrows + " effect r -> A }")),
                 "too many `=>`"));
  CHECK(contains(errorsIn(std::string(5 << 20, ' ')), "larger than 4 MiB"));
}

TEST_CASE("the summary of skillsets names what is approximated or not verified") {
  const auto imported = importedOf(
      skillset(kResource +
               "skill k { interrupt { interrupting true postcondition r == A } failure ko {} }"));
  CHECK_FALSE(imported.exact);
  REQUIRE(imported.summary.size() == 3);
  CHECK(imported.summary[0] == "main.rl:7:11: not verified: the postcondition of an interrupt");
  CHECK(imported.summary[1] == "main.rl:7:7: approximated: `k` has no `success`; in the program it "
                               "may succeed, without effects");
  CHECK(contains(imported.summary[2], "over-approximate"));
}

TEST_CASE("a program is written as a skillset as far as RL can say it") {
  const MemoryFiles files(std::map<std::string, std::string>{
      {"p", R"((defsv a :states (X Y) :init X :transitions ((X Y)))
(defevent e :every [1,2] :effects (a Y))
(defskill k :input ($h float) :precondition (p (<=> (a X) (/= a Y))) :time_interval [1,2]
  :action (k $h) :success (:effects (a Y)))
(defskill l :input ($h float) :action (lift $h 3))
(defskill m :body ((k h 1.0) (l h 2))))"}});
  const auto emitted = bridge::rl::emitSkillset(analysis::load(files, "p"), "robot");
  REQUIRE(emitted);
  CHECK(contains(emitted->text, "skillset robot {\n    resource a {\n        state { X Y }\n"));
  CHECK(contains(emitted->text, "precondition p: ((a == X => a != Y) and (a != Y => a == X))"));
  REQUIRE(emitted->notes.size() == 4);
  CHECK(emitted->notes[0].message == "not in RL: the time between two events");
  CHECK(emitted->notes[0].place.line == 2);
  CHECK(emitted->notes[2].message == "not in RL: an action of another form");
  CHECK(emitted->notes[2].place.line == 5);
  CHECK(importSkillsets(MemoryFiles({{"x.rl", emitted->text}}), "x.rl", {}));
}

TEST_CASE("keywords of RL are not names of a skillset, and an interrupt has its effect") {
  const MemoryFiles files(std::map<std::string, std::string>{
      {"p", R"((defsv effect :states (guard guard_ start) :init guard)
(defevent event :guard (effect guard_) :effects (effect start))
(defskill skill :precondition (initial (effect guard)) :interrupt ()
  :success (all (:effects (effect guard)))))"}});
  const auto emitted = bridge::rl::emitSkillset(analysis::load(files, "p"), "robot");
  REQUIRE(emitted);
  CHECK(contains(emitted->text, "resource effect_ {\n        state { guard__ guard_ start_ }"));
  CHECK(
      contains(emitted->text, "skill skill_ {\n        precondition initial_: effect_ == guard__"));
  CHECK(contains(emitted->text, "interrupting false\n            effect { }\n"));
  CHECK(contains(emitted->text, "success all_ {"));
  REQUIRE(emitted->notes.size() == 7);
  CHECK(emitted->notes[0].message == "`all` is a keyword of RL, and becomes `all_`");
  CHECK(importSkillsets(MemoryFiles({{"x.rl", emitted->text}}), "x.rl", {}));
}

TEST_CASE("the summary says that an interrupt may come before a start") {
  const auto interrupted = importedOf(
      skillset(kResource + "skill k { interrupt { interrupting false } success ok { } }"));
  REQUIRE(interrupted.summary.size() == 2);
  CHECK(contains(interrupted.summary[0], "between its call and its start"));
}

TEST_CASE("what RL cannot say is an error at its place") {
  const MemoryFiles files(std::map<std::string, std::string>{
      {"p", "(defsv n :init 0 :min 0 :max 3)\n(defsv a :states (X Y) :init X)\n"
            "(defevent e :guard (> n 1) :effects (a Y))"}});
  const auto emitted = bridge::rl::emitSkillset(analysis::load(files, "p"), "robot");
  REQUIRE_FALSE(emitted);
  REQUIRE(emitted.error().size() == 2);
  CHECK(emitted.error()[0].message == "RL cannot say this: a number");
  CHECK(emitted.error()[1].place.line == 3);
  CHECK(emitted.error()[1].place.column == 20);
}

TEST_CASE("RL has no conditions about inputs") {
  const MemoryFiles files(std::map<std::string, std::string>{
      {"p", "(defskill k :input ($fast bool)\n:precondition (p (not $fast)) :action (k $fast))"}});
  const auto emitted = bridge::rl::emitSkillset(analysis::load(files, "p"), "robot");
  REQUIRE_FALSE(emitted);
  REQUIRE(emitted.error().size() == 1);
  CHECK(emitted.error()[0].message == "RL cannot say this: a test of an input");
  CHECK(emitted.error()[0].place.line == 2);
  CHECK(emitted.error()[0].place.column == 23);
}

} // namespace rl_import
