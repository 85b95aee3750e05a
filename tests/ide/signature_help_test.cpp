#include "ide/completion/signature_help.h"
#include "tests/ide/marked_program.h"

#include <catch2/catch.hpp>

namespace proskill::test::signature_help_test {

using test::MarkedProgram;

namespace {

/// The signature with its active parameter between `<` and `>`.
std::string helpText(const std::string& text) {
  const MarkedProgram program(text);
  auto found = ide::signatureHelp(program.view(), program.at());
  if (!found) return {};
  auto label = found->label;
  if (found->active) {
    const auto range = found->parameters.at(*found->active).label;
    label.insert(range.end, ">");
    label.insert(range.begin, "<");
  }
  return label;
}

const std::string kGo = "; Goes.\n(defskill go :input ($x float $mode string) :action (go $x))\n";

} // namespace

TEST_CASE("the inputs of a call, and which is being written") {
  const std::string body = kGo + "(defskill m :body ((go ";
  CHECK(helpText(body + "^") == "(go <x float> mode string)");
  CHECK(helpText(body + "x ^") == "(go <x float> mode string)");
  CHECK(helpText(body + "x 3 ^)))") == "(go x float <mode string>)");
  CHECK(helpText(body + "mode \"a^\")))") == "(go x float <mode string>)");
  CHECK(helpText(body + "mode \"a\" ^)))") == "(go <x float> mode string)");
  CHECK(helpText(body + "x 3 mode \"a\" ^)))") == "(go x float mode string)");
  const MarkedProgram program(body + "^");
  CHECK(ide::signatureHelp(program.view(), program.at())->documentation.plain() == "Goes.");
}

TEST_CASE("the innermost list that has a signature counts") {
  CHECK(helpText(kGo + "(defskill m :body ((if (= 1 ^") == "(= A <B>)");
  CHECK(helpText(kGo + "(defskill m :body ((go x (+ 1 ^") == "(+ A <B>)");
  CHECK(helpText(kGo + "(defskill m :body ((printf ^") == "(printf <\"FORMAT\"> ARGUMENT…)");
  CHECK(helpText(kGo + "(defproperty p (leadsto true ^") == "(leadsto P <Q> [:within I])");
}

TEST_CASE("fields of definitions and clauses") {
  CHECK(helpText("(defevent e :effects ^") ==
        "(defevent NAME :every [LEAST,MOST] :guard CONDITION <:effects EFFECTS>)");
  CHECK(helpText("(defskill f :invariant (t (:guard ^") == "(<:guard CONDITION> :effects EFFECTS)");
  CHECK(helpText("(defskill f :time_interval ^") == "<:time_interval [LEAST,MOST]>");
  CHECK(helpText("(defsv lamp ^").starts_with("(defsv NAME :states"));
}

TEST_CASE("no signature at the top level, in comments, and of a call of nobody") {
  for (const auto* text : {"^", "; (go ^", "(defskill f ^", "(^"}) CHECK(helpText(text).empty());
  CHECK(helpText("(defskill f :body ((nobody ^") == "<:body (STATEMENT…)>");
}

TEST_CASE("a text that is nested without end, or is one line of strings, is looked at in no time") {
  const std::size_t much = 50'000;
  CHECK(helpText("(defskill m :body " + std::string(much, '(') + "^").empty());
  std::string ifs, strings;
  for (std::size_t i = 0; i < much; ++i) {
    ifs += "(if (lamp On) ";
    strings += "\"a\" ";
  }
  CHECK(helpText("(defskill m :body (" + ifs + "(printf ^").starts_with("(printf"));
  CHECK(helpText(kGo + "(defskill m :body ((go " + strings + "x ^").starts_with("(go"));
}

} // namespace proskill::test::signature_help_test
