#include "ide/features/inlay_hints.h"
#include "tests/ide/marked_program.h"

#include <catch2/catch.hpp>

using namespace proskill;
using test::MarkedProgram;

namespace {

/// The text with its hints in braces.
std::string hinted(const std::string& text) {
  const MarkedProgram program(text);
  auto result = program.view().text();
  const auto end = static_cast<syntax::Offset>(result.size());
  auto range = program.marked().empty() ? syntax::Range{0, end} : program.marked().front().range;
  auto hints = ide::inlayHints(program.view(), range);
  for (auto it = hints.rbegin(); it != hints.rend(); ++it)
    result.insert(it->at, "{" + it->label + "}");
  return result;
}

void check(const std::string& text, const std::string& part) {
  CHECK_THAT(hinted(text), Catch::Matchers::Contains(part));
}

const std::string kGo = "(defskill go :input ($x float) :time_interval [1,3] :action (go $x)\n"
                        "  :success a :failure b)\n";

} // namespace

TEST_CASE("literals in calls show the types of their inputs, bodies how long they take") {
  check(kGo + "(defskill m :body ((go x 3) (go x 4.5)))",
        "(defskill m{2 to 6 s} :body ((go x{: float} 3) (go x{: float} 4.5)))");
  check(kGo + "(defskill m :input ($y float) :body ((go x $y)))", "((go x $y))");
  check(kGo + "(defskill m :body ((go x 3) (go y 1) (nobody x 1)))",
        "(go x{: float} 3) (go y 1) (nobody x 1)");
  check("(defskill m :body ((while true (^ 1))))", "(defskill m{never ends}");
  check("(defskill m :body ((^ [2,...[)))", "(defskill m{at least 2 s}");
}

TEST_CASE("what is tested shows what it can be, where that is less than elsewhere") {
  check(kGo + "(defskill m :body ((go x 3) (if (= go.status success) (^ 1))))",
        "(= go.status{= success or failure} success)");
  const std::string lamp = "(defsv lamp :states (On Off Dim) :init Off)\n";
  check(lamp + "(defskill m :body ((set (lamp On)) (if (lamp On) (^ 1)) (set (lamp Dim))))",
        "(if (lamp{= On} On)");
  // Others may set it at any time, so nothing is known beyond the definition.
  check(lamp + "(defevent e :effects (lamp On)) (defevent f :effects (lamp Off))"
               "(defevent g :effects (lamp Dim))"
               "(defskill m :body ((set (lamp On)) (if (lamp On) (^ 1))))",
        "(if (lamp On)");
}

TEST_CASE("of many values the one is told that it cannot be") {
  const std::string mode = "(defsv mode :states (A B C D E) :init A)\n"
                           "(defevent b :effects (mode B)) (defevent c :effects (mode C))"
                           "(defevent d :effects (mode D)) (defevent e :effects (mode E))\n";
  check(mode + "(defskill m :body ((set (mode B)) (if (mode C) (^ 1))))", "(if (mode{≠ A} C)");
}

TEST_CASE("guards, which are looked at all the time, and bodies that take any time have no hints") {
  check("(defsv lamp :states (On Off) :init On) (defevent e :effects (lamp Off))"
        "(defskill m :invariant (t (:guard (lamp On))) :body ((^ (lamp Off))))",
        "(defskill m :invariant (t (:guard (lamp On)))");
}

TEST_CASE("hints are for the range that was asked for") {
  check(kGo + "(defskill m :body ((go x 3) [[(go x 4)]] (go x 5)))",
        "(defskill m :body ((go x 3) (go x{: float} 4) (go x 5)))");
}

TEST_CASE("a program with errors keeps what does not need its flow") {
  check(kGo + "(defskill m :body ((go x 3) (if (= go.status nonsense) (^ 1))))",
        "(defskill m :body ((go x{: float} 3) (if (= go.status nonsense)");
}

TEST_CASE("a debugger shows each state variable once a line, up to the end of the range") {
  const MarkedProgram program("(defsv lamp :states (On Off) :init Off)\n"
                              "[[(defskill m :body ((^ (| (lamp On) (lamp Off)))\n"
                              "  (set (lamp On)))]] (set (lamp Off))))");
  std::vector<std::string> names;
  for (const auto& variable : ide::inlineVariables(program.view(), program.marked().front().range))
    names.push_back(variable.name);
  CHECK(names == std::vector<std::string>{"lamp", "lamp"});
}
