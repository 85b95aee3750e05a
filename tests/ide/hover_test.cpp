#include "ide/features/hover.h"
#include "tests/ide/marked_program.h"

#include <catch2/catch.hpp>

namespace proskill::test::hover_test {

using test::MarkedProgram;

namespace {

std::string hoverText(const std::string& text) {
  const MarkedProgram program(text);
  auto found = ide::hover(program.view(), program.at());
  if (!found) return {};
  if (!program.marked().empty()) CHECK(found->range == program.marked().front().range);
  return found->text.markdown();
}

const std::string kBattery = "; Charge *left*.\n; In four.\n"
                             "(defsv battery :states (Good Low Empty) :init Good\n"
                             "  :transitions ((Good Low) (Low Empty) (Low Good)))\n"
                             "(defevent drain :effects (battery Low))\n";

} // namespace

TEST_CASE("a state variable: definition, comment, moves, who sets and who reads it") {
  CHECK(hoverText(kBattery + "(defskill f :precondition (t ([[bat^tery]] Good)) :action (x))") ==
        "```proskill\n"
        "(defsv battery :states (Good Low Empty) :init Good\n"
        "  :transitions ((Good Low) (Low Empty) (Low Good)))\n"
        "```\n\n"
        "Charge \\*left\\*.  \nIn four.\n\n"
        "| from | to |\n| --- | --- |\n"
        "| `Good` | `Low` |\n| `Low` | `Empty`, `Good` |\n| `Empty` | — |\n\n"
        "Set by `drain`.\n\n"
        "Read by `f`.\n\n"
        "Here it is Good or Low.");
}

TEST_CASE("at its definition, a state variable tells what it can be in all runs") {
  CHECK(hoverText("(defsv ^lamp :states (On Off Dim) :init Off)"
                  "(defevent e :effects (lamp On)) (defskill f :action (x))")
            .ends_with("In all runs it is On or Off."));
}

TEST_CASE("what a variable can be at a place comes from what was tested before it") {
  const std::string before = "(defsv lamp :states (On Off Dim) :init Off)"
                             "(defskill m :body ((set (lamp On)) (if (la";
  CHECK(hoverText(before + "^mp On) (set (lamp Off)))))").ends_with("Here it is On."));
}

TEST_CASE("a skill without its body, who calls it, and its comment") {
  auto text = hoverText("; Goes.\n(defskill go :input ($x int)\n  :body ((^ 1)))\n"
                        "(defskill m :body ((g^o x 1)))");
  CHECK(text == "```proskill\n(defskill go :input ($x int)\n  :body (…))\n```\n\nGoes.\n\n"
                "Called by `m`.");
}

TEST_CASE("values, inputs, tags and labels say what they belong to") {
  CHECK(hoverText("(defsv lamp :states (O^n Off) :init Off) (defevent e :effects (lamp On))") ==
        "```proskill\nOn\n```\n\nA value of `lamp`.\n\nSet by `e`.");
  CHECK(hoverText("(defsv lamp :states (On Off) :init On)"
                  "(defskill f :input ($l lamp) :action (x $^l))") ==
        "```proskill\n$l lamp\n```\n\nAn input of `f`.\n\n`lamp` is one of: On Off");
  CHECK(
      hoverText("(defskill m :success do^ne :body ((success done)))").contains("A success of `m`"));
  CHECK(hoverText("(defskill m :body ((label ag^ain) (goto again)))").contains("A label of `m`"));
}

TEST_CASE("a constant with its number, its comment and who uses it") {
  CHECK(
      hoverText("; Seconds.\n(defconst patience 60)\n(defskill m :body ((^ [1,[[pat^ience]]])))") ==
      "```proskill\n(defconst patience 60)\n```\n\nSeconds.\n\nUsed by `m`.");
}

TEST_CASE("words of the language, by the meaning that they have in their place") {
  CHECK(hoverText("(defs^v lamp :states (On) :init On)").contains("which the program knows"));
  CHECK(hoverText("(defskill f [[:st^art]] (lamp On) :action (x))")
            .contains("happen when the skill starts"));
  CHECK(hoverText("(defskill f :invariant (t (:gu^ard true)) :action (x))")
            .contains("while the skill runs"));
  CHECK(hoverText("(defskill f :success (d (:eff^ects (l On))) :action (x))")
            .contains("when the skill ends with this outcome"));
  CHECK(hoverText("(defskill f :body ((wh^ile true (^ 1))))").contains("as long as"));
  CHECK(hoverText("(defskill f :body ((if true (^ 1) el^se (^ 2))))").contains("no condition"));
  CHECK(hoverText("(defskill f :body ((do (^ 1) un^til true)))").contains("loop ends"));
  CHECK(hoverText("(defskill f :precondition (t (~^ true)) :action (x))").contains("not hold"));
  CHECK(hoverText("(defskill f :input ($x flo^at) :action (x))").contains("A number"));
  CHECK(hoverText("(defskill f :input ($x bo^ol) :action (x))").contains("can test it"));
  CHECK(hoverText("(defskill f :input ($x bool) :body ((if $^x (^ 1))))").contains("input of `f`"));
  CHECK(hoverText("(defproperty p (lea^dsto true false))").contains("Whenever P, then Q"));
  CHECK(hoverText("(defproperty p (always (run^ning f)))").contains("The skill runs"));
}

TEST_CASE("a state variable that is called like a word of the language is a state variable") {
  CHECK(hoverText("(defsv while :states (On Off) :init On) (defevent e :effects (whi^le On))")
            .contains("(defsv while"));
}

TEST_CASE("a skill's status and what it can be here") {
  const std::string program = "(defskill go :action (x) :success a :failure b)"
                              "(defskill m :body ((go) (if (= go.[[sta^tus]] failure) (^ 1))))";
  auto text = hoverText(program);
  CHECK(text.contains("How the skill's last call ended"));
  CHECK(text.contains("Here it is success or failure."));
  CHECK(hoverText(
            "(defskill go :action (x)) (defskill m :body ((go) (if (= g^o.status failure) (^ 1))))")
            .contains("(defskill go"));
}

TEST_CASE("nothing where no word stands, in comments and in texts") {
  for (const auto* text :
       {"(defsv lamp  ^  :states (On) :init On)", "; defsv^", "^",
        "(defskill f :body ((printf \"whi^le\")))", "(defskill f :body ((nobody^)))"})
    CHECK(hoverText(text).empty());
}

TEST_CASE("for who shows no markdown, the same as plain text") {
  const MarkedProgram program(kBattery + "(defevent e :effects (battery^ Low))");
  const auto text = ide::hover(program.view(), program.at())->text.plain();
  CHECK(text.contains("Charge *left*."));
  CHECK(text.contains("Low -> Empty, Good"));
  CHECK_FALSE(text.contains("`"));
}

} // namespace proskill::test::hover_test
