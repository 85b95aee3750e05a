#include "analysis/flow/inspect.h"
#include "syntax/diagnostics/codes.h"
#include "tests/flow/told.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <iterator>
#include <vector>

using namespace proskill;
using test::expectAllTold;
using test::expectTold;

namespace {

std::string codes(const std::string& program) {
  std::string all;
  for (const auto& it : analysis::flow::inspect(test::programOfText(program), {}))
    all += syntax::info(it.code).id;
  return all;
}

} // namespace

TEST_CASE("Whatever makes a move that is forbidden from everywhere is an error") {
  expectAllTold({
      {R"((defsv d :states (A B C) :init A :transitions ((A B) (B A)))
(defevent e :effects [[(d C)]])
(defskill m :body ((^ 1))))",
       "PS0503"}, // from C, which it enters by itself, it may stay
      {R"((defsv d :states (A B C) :init A :transitions ((A B) (B A)))
(defskill s :start [[(d C)]] :action (s))
(defskill m :body ((s))))",
       "PS0501"},
      {R"((defsv d :states (A B C) :init A :transitions ((A B) (B A)))
(defskill s :action (s) :success done (:effects [[(d C)]]))
(defskill m :body ((s))))",
       "PS0501"},
      {R"((defsv d :states (A B C) :init A :transitions ((A B) (B A)))
(defsv w :states (Ok Bad) :init Ok)
(defevent bad :effects (w Bad))
(defskill s :action (s) :invariant (fine (:guard (w Ok) :effects [[(d C)]])))
(defskill m :body ((s))))",
       "PS0501"},
      {R"((defsv d :states (A B C) :init A :transitions ((A B) (B A)))
(defskill s :action (s) :interrupt (:effects [[(d C)]]))
(defskill m :body ((s))))",
       "PS0501"},
      {R"((defsv d :states (A B C) :init A :transitions ((A B)))
(defskill m :body ((^ (d A) :effects [[(d C)]]))))",
       "PS0501"},
      {R"((defsv n :init 5 :min 1 :max 5)
(defskill m :body ((set (n (- n 1))) (set [[(n (- n 5))]]))))",
       "PS0504"},
  });
}

TEST_CASE("A natural that stops in time stays in its range") {
  expectAllTold({
      {R"((defsv n :init 0 :min 0 :max 5)
(defskill m :body ((do (^ 1) (set (n (+ n 2))) until (> n 3)))))"},
      {R"((defsv n :init 0 :min 0 :max 4)
(defskill m :body ((do (^ 1) (set [[(n (+ n 3))]]) until (> n 3)))))",
       "PS0505"},
  });
}

TEST_CASE("What stands behind something that never leads on is never reached") {
  expectAllTold({
      {"(defskill m :success done :body ((success done) [[(^ 1)]] (^ 2)))", "PS0601"},
      {"(defskill m :body ((label a) (^ 1) (goto a) [[(^ 2)]]))", "PS0601"},
      {"(defskill m :body ((while true (^ 1) break [[(^ 2)]])))", "PS0601"},
      {"(defskill m :body ((while true (^ 1)) [[(^ 2)]]))", "PS0601"},
      {"(defskill m :success done :body ((// ((success done) [[(^ 1)]]) ((^ 2)))))", "PS0601"},
      {"(defskill m :body ((// ((while true (^ 1))) ((^ 2))) [[(^ 3)]]))", "PS0601"},
      {"(defskill e :body ((while true (^ 1))))\n(defskill m :body ((e) [[(^ 3)]]))", "PS0601"},
      {R"((defsv d :states (A B) :init A)
(defevent e :effects (d B))
(defskill m :success done :body ((if (d A) (success done) else (success done)) [[(^ 1)]])))",
       "PS0601"},
      {"(defskill m :success done :body ((goto end) [[(^ 1)]] (label end) (^ 2) (success done)))",
       "PS0601"},
  });
}

TEST_CASE("A variable that is never used is told once, and not for each of its values") {
  expectTold({R"((defsv [[d]] :states (A B C) :init A)
(defskill m :body ((^ 1))))",
              "PS0612"});
}

TEST_CASE("A status or a result that is read before the call is told, wherever it is read") {
  const std::string skill = "(defskill s :action (s) :success done :failure bad)\n";
  for (const char* body :
       {"(if (= [[s.status]] failure) (^ 1)) (s) (if (/= s.status success) (^ 1))",
        "(if (= [[s.res]] bad) (^ 1)) (s) (if (/= s.status success) (^ 1))",
        "(^ (= [[s.status]] success)) (s)", "(printf \"%s\" [[s.status]]) (s)"})
    expectTold({(skill + "(defskill m :body (" + body + "))").c_str(), "PS0707"});
  expectTold({(skill + "(defskill m :body ((s) (printf \"%s\" s.status)))").c_str()});
  expectTold(
      {(skill + "(defskill m :body ((while true (s) (^ 1) (if (= s.res bad) (^ 1)))))").c_str()});
}

TEST_CASE("A result is ignored only where there is a failure that may come") {
  expectAllTold({
      {R"((defskill s :action (s) :success done :failure bad)
(defskill m :body (([[s]]) (^ 1) (s))))",
       "PS0708"},
      {R"((defsv d :states (A B) :init A)
(defskill s :success done :failure bad :body ((if [[(d B)]] (failure bad)) (success done)))
(defskill m :body ((s) (set (d B)))))",
       "PS0703"},
  });
}

TEST_CASE("Two branches set the same variable, by what they call too") {
  expectAllTold({
      {R"((defsv d :states (A B C) :init A)
(defskill b :start (d B) :action (b))
(defskill c :start (d C) :action (c))
(defskill m :body ((// ((b)) ([[(c)]])))))",
       "PS0902"},
      {R"((defsv d :states (A B C) :init A)
(defskill b :precondition (free (d A)) :start (d B) :action (b) :success ok (:effects (d A)))
(defskill c :precondition (free (d A)) :start (d C) :action (c) :success ok (:effects (d A)))
(defskill m :body ((// ((b)) ((c))))))"},
  });
}

TEST_CASE("Branches may count together") {
  // The order of sums does not matter, but that of a sum and a value does.
  expectAllTold({
      {R"((defsv n :init 0 :min 0 :max 9)
(defskill m :body ((// ((^ 1) (set (n (+ n 1)))) ((^ 2) (set (n (+ 2 n))))))))"},
      {R"((defsv n :init 0 :min 0 :max 9)
(defskill m :body ((// ((^ 1) (set (n (+ n 1)))) ((^ 2) [[(set (n 5))]])))))",
       "PS0902"},
  });
}

TEST_CASE("A natural that each branch counts up once stays in its range") {
  const auto program = [](const char* most, const char* body) {
    return std::string("(defsv n :init 0 :min 0 :max ") + most +
           ")\n(defskill s :action (s) :success done :failure bad)\n"
           "(defskill t :action (t))\n(defskill m :body (" +
           body + "))";
  };
  // Each branch counts once on each of its paths, in each round.
  const char* two = "(while true (set (n 0)) (// ((s) (if (= s.status failure) (set (n (+ n 1))) "
                    "(goto end)) (set (n (+ n 1))) (label end)) ((t) (set (n (+ n 1))))) (^ 1))";
  CHECK(codes(program("2", two)).empty());
  CHECK(codes(program("1", two)) == "PS0505PS0505PS0505");
  // The branches of a branch count for it.
  CHECK(codes(program("2", "(set (n 0)) (// ((// ((s) (if (= s.status success) (set (n (+ n 1))))) "
                           "((^ 1) (set (n (+ n 1)))))) ((t)))"))
            .empty());
  // It is not set before each round.
  CHECK(
      codes(program("2", "(set (n 0)) (while true (// ((^ 1) (set (n (+ n 1)))) ((t))) (^ 1))")) ==
      "PS0610PS0505"); // and the loop never ends
  // The branches count further than any natural.
  CHECK(codes(program("3", "(set (n 0)) (// ((s) (set (n (+ n 9223372036854775807)))) "
                           "((t) (set (n (+ n 9223372036854775807)))))")) ==
        "PS0708PS0504PS0504"); // and nobody looks whether `s` fails
  // A branch counts in a loop.
  CHECK(codes(program("9", "(set (n 0)) (// ((while true (^ 1) (set (n (+ n 1))))) ((t)))")) ==
        "PS0610PS0505");
}

TEST_CASE("A resource is asked for beyond its capacity") {
  expectAllTold({
      {R"((defresource arm)
(defskill a :resources (arm) :action (grip))
(defskill b :resources (arm) :body ([[(a)]]))
(defskill m :body ((b))))",
       "PS0904"},
      {R"((defresource arm :capacity 2)
(defskill a :resources (arm) :action (grip))
(defskill b :resources (arm) :body ((a)))
(defskill m :body ((b))))"},
      {R"((defresource arm :capacity 2)
(defskill a :resources (arm) :action (grip))
(defskill b :resources (arm) :body ([[(a)]]))
(defskill c :resources (arm) :body ((b)))
(defskill m :body ((c))))",
       "PS0904"},
  });
}

TEST_CASE("Loops with known counts take as long as all their rounds") {
  const std::string parts = "(defsv n :init 0 :min 0 :max 5)\n"
                            "(defskill s :time_interval [1,2] :action (s))\n";
  const std::string loop = " :body ((while (< n 4) (s) (set (n (+ n 1))))))";
  auto told = [&](const std::string& interval) {
    return codes(parts + "(defskill m :time_interval " + interval + loop);
  };
  CHECK(told("[0,3]") == "PS1002");
  CHECK(told("[20,30]") == "PS1001");
  CHECK(told("[5,8]") == "PS1003");
  CHECK(told("[4,8]").empty());
}

TEST_CASE("A skill that is stopped earlier is not told that it never ends in time") {
  const std::string mission = "(defskill m :body ((a)))";
  const std::string body = " :time_interval [0,60] :body ((^ 100)))";
  CHECK(codes("(defskill a" + body + mission) == "PS1002");
  CHECK(codes("(defskill a :interrupt ()" + body + mission) == "PS1003");
  CHECK(codes("(defsv v :states (A B) :init A) (defevent e :effects (v B))"
              "(defskill a :invariant (i (:guard (v A)))" +
              body + mission) == "PS1003");
}

TEST_CASE("What can never hold says whether it is so by itself") {
  const auto told = [](const std::string& guards) {
    const std::string text = "(defsv v :states (A B) :init A)(defevent e :effects (v B))"
                             "(defevent f :effects (v A))(defskill a :invariant (" +
                             guards + ") :action (a)) (defskill m :body ((a)))";
    for (const auto& it : analysis::flow::inspect(test::programOfText(text), {}))
      if (it.code == syntax::Code::ContradictoryInvariants) return it.message;
    return std::string();
  };
  CHECK(told("i (:guard (and (v A) (v B)))") == "the invariant `i` of `a` can never hold");
  CHECK(told("i (:guard (v A)) j (:guard (v B))") ==
        "the invariant `j` of `a` can never hold together with those before it");
}

TEST_CASE("A count that somebody else changes is not known") {
  const std::string mission =
      "(defskill m :time_interval [1,3] :body ((while (< n 4) (^ 2) (set (n 4)))))";
  CHECK(codes("(defsv n :init 0 :min 0 :max 5)\n" + mission).empty());
  CHECK(codes("(defsv n :init 0 :min 0 :max 5)\n(defevent back :effects (n 0))\n" + mission) ==
        "PS1003");
}

TEST_CASE("Counts within counts") {
  expectTold({R"((defsv i :init 0 :min 0 :max 3)
(defsv j :init 0 :min 0 :max 3)
(defskill m :time_interval [6,6] :body
  ((while (< i 3) (set (j 0)) (while (< j 2) (^ 1) (set (j (+ j 1)))) (set (i (+ i 1)))))))"});
}

TEST_CASE("A loop in which no time passes is told at its beginning") {
  expectAllTold({
      {R"((defsv d :states (A B) :init A)
(defevent e :effects (d B))
(defskill m :body (([[do]] (printf "x") until (d B)))))",
       "PS1004"},
      {R"((defsv n :init 0 :min 0 :max 5)
(defskill m :body ((while (< n 5) (set (n (+ n 1)))))))"},
  });
}

TEST_CASE("A wait that may never end leaves no bound, even where no way leads on") {
  // If a stop comes at once, the mission takes no time; otherwise it waits for its own result for
  // ever.
  CHECK(codes("(defsv v :states (Low Bad) :init Bad)\n(defevent stop :effects (v Low))\n"
              "(defskill m :time_interval [1,3] :success done\n"
              "  :body ((if (v Bad) (^ (= m.res done)))))")
            .find("PS1001") == std::string::npos);
}

TEST_CASE("A skill that a monitor and the mission call is told once") {
  expectAllTold({
      {R"((defskill survey :action (survey))
(defskill watch :monitor t :body ((^ 5) (survey)))
(defskill mission :body ((survey) (^ 1) ([[survey]]))))",
       "PS0905"},
      {R"((defskill survey :action (survey))
(defskill tour :body ((survey)))
(defskill watch :monitor t :body ((^ 5) (survey)))
(defskill mission :body ((tour) ([[survey]]))))",
       "PS0905"},
      {R"((defskill survey :action (survey))
(defskill first :monitor t :body ((survey)))
(defskill second :monitor t :body (([[survey]])))
(defskill mission :body ((^ 1))))",
       "PS0905"},
      {R"((defskill survey :action (survey))
(defskill watch :monitor t :body ((^ 5)))
(defskill mission :body ((survey) (^ 1) (survey))))"},
  });
}

TEST_CASE("A skill that is called at once in thousands of places is told once, with some of them") {
  std::string calls;
  for (int i = 0; i < 5000; ++i) calls += "(survey) ";
  const auto found = analysis::flow::inspect(
      test::programOfText(
          "(defskill survey :action (survey))\n(defskill watch :monitor t :body ((^ 5) " + calls +
          "))\n(defskill mission :body (" + calls + "))"),
      {});
  std::vector<syntax::Diagnostic> shared;
  std::ranges::copy_if(found, std::back_inserter(shared),
                       [](const auto& it) { return it.code == syntax::Code::CallMayWait; });
  REQUIRE(shared.size() == 1);
  CHECK(shared[0].related.size() == 10);
}

TEST_CASE("A skill that is only called under a lock is free") {
  const std::string lock = "(defsv zone :states (Free Taken) :init Free)\n"
                           "(defskill survey :action (survey))\n";
  const std::string calls = "((^ (zone Free) :effects (zone Taken)) (survey) (set (zone Free)))";
  CHECK(codes(lock + "(defskill watch :monitor t :body " + calls + ")\n(defskill mission :body " +
              calls + ")")
            .find("PS0905") == std::string::npos);
}

TEST_CASE(
    "An outcome that is never returned is told where it is declared, not at who asks for it") {
  expectAllTold({
      {R"((defskill s :success done :failure [[lost]] :body ((^ 1) (success done)))
(defskill m :success done :failure lost
  :body ((s) (if (= s.status failure) (failure lost)) (success done))))",
       "PS0602"},
      {R"((defsv v :states (A B) :init A)
(defevent e :effects (v B))
(defskill s :success done :failure (lost [[late]])
  :body ((if (v B) (failure lost)) (^ 1) (success done)))
(defskill m :body ((s) (if (= s.res late) (printf "late")) (^ (= s.res late)))))",
       "PS0602"},
  });
  // A chain of skills, each of which tests the outcome of the next, has one error.
  std::string chain = "(defskill s30 :success done :failure lost :body ((^ 1) (success done)))\n";
  for (int i = 29; i >= 0; --i)
    chain += "(defskill s" + std::to_string(i) + " :success done :failure lost :body ((s" +
             std::to_string(i + 1) + ") (if (= s" + std::to_string(i + 1) +
             ".status failure) (failure lost)) (success done)))\n";
  CHECK(codes(chain) == "PS0602");
}

TEST_CASE("Hints of style look at values, tags, and properties too") {
  auto hints = [](const std::string& text) {
    std::string all;
    for (const auto& it : analysis::flow::inspect(test::programOfText(text), {.style = true}))
      if (syntax::info(it.code).id.starts_with("PS11")) all += syntax::info(it.code).id;
    return all;
  };
  const std::string mission = "(defskill mission :body ((^ (light On)) (set (light Off))))\n";
  const std::string light = "(defsv light :states (Off On) :init Off)\n";
  CHECK(hints(light + mission).empty());
  CHECK(hints("(defsv light :states (Off On dim) :init Off)\n" + mission) == "PS1104");
  CHECK(hints("(defsv light :states (Off On on) :init Off)\n" + mission) == "PS1102");
  CHECK(hints(light + mission + "(defproperty p (never (and (= light On) (running mission))))") ==
        "PS1103");
  CHECK(hints(light + mission + "(defproperty Dark (never (light On)))") == "PS1101");
  CHECK(hints(light + "(defskill mission :success Done :failure done :body ((^ (light On)) "
                      "(if (light On) (failure done)) (success Done)))") == "PS1102");
}

TEST_CASE("Bounds are rounded to whole ticks, and a postcondition to what the outcome sets") {
  auto fixed = [](std::string text) {
    for (const auto& it : analysis::flow::inspect(test::programOfText(text), {})) {
      if (it.fixes.empty()) continue;
      const auto& fix = it.fixes[0];
      text.replace(fix.location.range.begin, fix.location.range.length(), fix.text);
      return text;
    }
    return text;
  };
  CHECK(fixed("(defskill m :body ((^ 0.333)))") == "(defskill m :body ((^ 0.33)))");
  CHECK(fixed("(defskill m :body ((^ ]0.125,1.001[)))") == "(defskill m :body ((^ ]0.13,1[)))");
  CHECK(fixed("(defskill m :body ((^ [0.125,...[)))") == "(defskill m :body ((^ [0.13,...[)))");
  CHECK(fixed("(defskill m :body ((^ 0.001)))") == "(defskill m :body ((^ 0.001)))");
  const std::string light = "(defsv d :states (A B) :init A)\n";
  const std::string rest = "(defskill m :body ((s) (set (d B)) (^ (d B))))";
  auto skill = [&](const std::string& outcome) {
    return light + "(defskill s :action (s) :success ok (" + outcome + "))\n" + rest;
  };
  CHECK(fixed(skill(":postcondition (d B)")) == skill(":effects (d B) :postcondition (d B)"));
  CHECK(fixed(skill(":effects (d A) :postcondition (d B)")) ==
        skill(":effects (d A) :postcondition (d A)"));
}

TEST_CASE("An effect that a postcondition wants stands before its keyword, whatever comments say") {
  const std::string before = R"((defsv flight :states (OnGround InAir) :init OnGround)
(defskill takeoff
  :action (takeoff)
  :success up ()";
  const std::string behind = R"(:postcondition ; a :postcondition must hold
    (flight InAir)))
(defskill mission :body ((takeoff) (set (flight InAir))))
)";
  const auto found = analysis::flow::inspect(test::programOfText(before + behind), {});
  const auto wanted =
      std::ranges::find(found, syntax::Code::PostconditionNeverHolds, &syntax::Diagnostic::code);
  REQUIRE(wanted != found.end());
  REQUIRE_FALSE(wanted->fixes.empty());
  const auto& fix = wanted->fixes[0];
  CHECK(fix.location.range == syntax::Range{static_cast<syntax::Offset>(before.size()),
                                            static_cast<syntax::Offset>(before.size())});
  CHECK(fix.text == ":effects (flight InAir) ");
}
