#include "ide/actions/action.h"
#include "syntax/format/format.h"
#include "tests/ide/marked_program.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace proskill;
using test::MarkedProgram;

namespace {

constexpr auto kSkills = "(defsv lamp\n  :states (On Off)\n  :init Off)\n\n"
                         "(defskill f\n  :action (f)\n  :success ok\n  :failure bad)\n\n";

std::vector<std::string> errorsOf(const std::string& text) {
  const MarkedProgram program(text);
  std::vector<std::string> errors;
  for (const auto& it : program.view().owner->findings())
    if (it.severity == syntax::Severity::Error) errors.push_back(it.message);
  return errors;
}

const ide::Action* find(const ide::Actions& actions, std::string_view title) {
  auto found = std::ranges::find_if(
      actions, [&](const ide::Action& it) { return it.title.contains(title); });
  return found == actions.end() ? nullptr : &*found;
}

syntax::Range selectionOf(const MarkedProgram& program) {
  auto marked = program.marked();
  return marked.empty() ? syntax::Range{program.at(), program.at()} : marked.front().range;
}

/// The text after the action whose title contains these words, or "refused".
std::string after(std::string_view marked, std::string_view title) {
  const MarkedProgram program(marked);
  auto all = ide::actions(program.snapshot(), "/w/main.proskill", selectionOf(program));
  const auto* action = find(all, title);
  if (!action) return "refused";
  std::vector<syntax::TextEdit> edits;
  for (const auto& edit : action->edits) edits.push_back(edit.edit);
  auto text = syntax::applyEdits(program.view().text(), edits);
  INFO(text);
  CHECK(syntax::Document::parse(text).diagnostics().size() <=
        program.view().document().diagnostics().size());
  bool isFix = action->fixes || action->kind == ide::ActionKind::SourceFixAll;
  if (!isFix) CHECK(errorsOf(text) == errorsOf(program.view().text()));
  return text;
}

std::string body(std::string_view statements) {
  return std::string(kSkills) + "(defskill m\n  :success done\n  :body\n    (" +
         std::string(statements) + "))\n";
}

} // namespace

TEST_CASE("the fixes of a diagnostic, where it is") {
  CHECK(after("(defsv lamp :states (On Off) :init Of^ff)\n", "did you mean") ==
        "(defsv lamp :states (On Off) :init Off)\n");
  CHECK(after("(defsv ^lamp :states (On Off) :init Offf)\n", "did you mean") == "refused");
}

TEST_CASE("all findings of one kind, and all that one edit fixes") {
  const auto* text = "(defsv lamp :states (On Off) :init Of^ff)\n"
                     "(defsv door :states (Open Closed) :init Opn)\n";
  const auto* fixed = "(defsv lamp :states (On Off) :init Off)\n"
                      "(defsv door :states (Open Closed) :init Open)\n";
  CHECK(after(text, "Fix all PS") == fixed);
  CHECK(after(text, "Apply all automatic fixes") == fixed);
}

TEST_CASE("a finding that is no error can be ignored") {
  CHECK(after(body("(f)\n     (^ ^0)"), "Ignore PS1005") ==
        body("(f)\n     ; proskill-ignore: PS1005\n     (^ 0)"));
  CHECK(after("(defsv lamp :states (On Off) :init Of^ff)\n", "Ignore") == "refused");
}

TEST_CASE("the missing branch for a failure") {
  const auto branched =
      body("(f)\n     (if (/= f.status success)\n        (printf \"f has failed\"))");
  CHECK(after(body("(f)^"), "when `f` fails") == branched);
  // If a finding reports the untested outcome, there is one fix, not two.
  CHECK(after(body("(f^)"), "when `f` fails") == "refused");
  CHECK(after(body("(f^)"), "test its status") != "refused");
  CHECK(after(body("(f^) (if (= f.status failure) (success done))"), "when `f` fails") ==
        "refused");
  CHECK(after(body("(m^)"), "fails") == "refused");
}

TEST_CASE("statements are wrapped in an if") {
  CHECK(after(body("(f)\n     [[(f)\n     (f)]]\n     (success done)"), "Wrap") ==
        body("(f)\n     (if true\n        (f)\n        (f))\n     (success done)"));
  CHECK(after(body("(la^bel x)"), "Wrap") == "refused");
}

TEST_CASE("statements become a skill, where they mean the same there") {
  auto extracted = after(body("[[(f)\n     (f)]]\n     (success done)"), "Extract");
  CHECK(extracted == std::string(kSkills) +
                         "(defskill part_of_m\n  :body\n    ((f)\n     (f)))\n\n"
                         "(defskill m\n  :success done\n  :body\n    ((part_of_m)\n"
                         "     (success done)))\n");
  CHECK(after(body("(f)\n     [[(success done)]]"), "Extract") == "refused");
  CHECK(after("(defskill m\n  :body\n    ([[(printf \"$x\")]]))\n", "Extract") == "refused");
  CHECK(after(body("(while true [[break]])"), "Extract") == "refused");
  CHECK(after(body("[[(while true (f) break)]]"), "Extract") != "refused");
}

TEST_CASE("a skill that statements become has the inputs that they need") {
  const std::string callee = "(defskill go\n  :input ($x float $y float)\n  :action (go $x $y)\n"
                             "  :success ok)\n\n";
  const std::string head = "(defskill m\n  :input ($a float $b float $c nat)\n  :body\n    (";
  CHECK(
      after(callee + head + "[[(go x $b y $a)]]\n     (go x 1.0 y 2.0)))\n", "Extract") ==
      callee +
          "(defskill part_of_m\n  :input ($a float $b float)\n  :body\n    ((go x $b y $a)))\n\n" +
          head + "(part_of_m a $a b $b)\n     (go x 1.0 y 2.0)))\n");
}

TEST_CASE("a plain skill is inlined, another is not") {
  const std::string part =
      "(defskill part\n  :body\n    ((f) ; once\n     (f) ; twice\n     ))\n\n";
  CHECK(after(part + body("(pa^rt)\n     (success done)"), "Inline") ==
        part + body("(f) ; once\n     (f) ; twice\n     (success done)"));
  CHECK(after(part + body("(pa^rt)\n     (^ (= part.status success))"), "Inline") == "refused");
  CHECK(after(body("(f^)"), "Inline") == "refused");
}

TEST_CASE("a monitor of a state variable") {
  CHECK(after("(defsv lamp\n  :states (O^n Off)\n  :init Off)\n", "monitor") ==
        R"((defsv lamp
  :states (On Off)
  :init Off)

(defskill monitor_lamp
  :monitor t
  :body
    ((while true
        (^ (lamp On))
        (printf "lamp is On")
        (^ (not (lamp On))))))
)");
  CHECK(after("(defsv ^n :init 1 :max 2)\n", "monitor") == "refused");
}

TEST_CASE("transitions as a list, and as :all") {
  const std::string all = "(defsv lamp\n  :states (A B C)\n  :init A\n  :transitions :a^ll)\n";
  auto listed = after(all, "List all");
  CHECK(listed == "(defsv lamp\n  :states (A B C)\n  :init A\n"
                  "  :transitions ((A B) (A C)\n                (B A) (B C)\n"
                  "                (C A) (C B)))\n");
  auto at = listed.find("(A B)");
  CHECK(after(listed.substr(0, at) + "^" + listed.substr(at), ":all") ==
        "(defsv lamp\n  :states (A B C)\n  :init A\n  :transitions :all)\n");
  CHECK(after("(defsv lamp :states (A B) :init A :transitions ((A ^B)))", ":all") == "refused");
}

TEST_CASE("fields are sorted, and take their comments along") {
  CHECK(after("(defskill ^f ; what\n  :success ok ; good\n  ; slow\n  :time_interval [1,2]\n"
              "  :action (f))\n",
              "Sort") == "(defskill f ; what\n  ; slow\n  :time_interval [1,2]\n  :action (f)\n"
                         "  :success ok ; good\n  )\n");
  CHECK(after("(defskill ^f :action (f) :success ok)", "Sort") == "refused");
  CHECK(after("(defskill ^f :success ok :action (f) :success no)", "Sort") == "refused");
}
