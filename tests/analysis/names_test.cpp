#include "syntax/diagnostics/codes.h"
#include "tests/analysis/findings.h"

#include <catch2/catch.hpp>

using proskill::analysis::Extent;
using proskill::test::diagnose;
using proskill::test::findings;
using proskill::test::kWorld;
using proskill::test::mission;

TEST_CASE("what is defined nowhere is told at its name") {
  CHECK(findings(mission("(landing)")) == "PS0201 landing");
  CHECK(findings(mission("(landing.interrupt)")) == "PS0201 landing");
  CHECK(findings(mission("(^ (= landing.status success))")) == "PS0201 landing");
  CHECK(findings(mission("(^ (wind Strong))")) == "PS0202 wind");
  CHECK(findings(mission("(^ (> wind 3))")) == "PS0202 wind");
  CHECK(findings(mission("(set (wind Strong))")) == "PS0202 wind");
  CHECK(findings(mission("(^ (battery Empty))")) == "PS0203 Empty");
  CHECK(findings(mission("(^ (= battery Empty))")) == "PS0203 Empty");
  CHECK(findings(mission("(^ (= Empty battery))")) == "PS0203 Empty");
  CHECK(findings(mission("(goto again)")) == "PS0207 again");
  CHECK(findings(mission("(success finished)")) == "PS0205 finished");
  CHECK(findings(mission("(failure done)")) == "PS0205 done");
  CHECK(findings(mission("(^ (= takeoff.status landed))")) == "PS0211 landed");
  CHECK(findings(mission("(^ (= takeoff.result grounded))")) == "PS0210 result");
  CHECK(findings(mission("(printf \"%d\" $height)")) == "PS0208 height");
  CHECK(findings(kWorld + "(defskill grasp :resources (arm hand) :action (grasp))") ==
        "PS0206 hand");
  CHECK(findings(kWorld + "(defenvironment e :body ((emit full)))") == "PS0204 full");
  CHECK(findings(kWorld + "(defproperty p (infinitelyoften (battery Low) :fair (landing)))") ==
        "PS0201 landing");
  CHECK(findings("(defskill s :input ($x real) :action (s $x))") == "PS0209 real");
}

TEST_CASE("the uses of a name that its comment deprecates are told") {
  const auto messages = [](const std::string& text) {
    std::string all;
    for (const auto& each : diagnose(text)) all += each.message + "\n";
    return all;
  };
  const std::string body = "(defskill mission :body ((old) (^ (= old.status success))))\n";
  const std::string old =
      "(defskill old :action (old) :invariant (i (:guard (/= old.status success))))\n";
  CHECK(findings("; Deprecated: use new.\n" + old + body) == "PS0230H old, PS0230H old");
  CHECK(messages(";; What it does.\n  ;; Deprecated: use new.\n; More.\n" + old +
                 "(defskill mission :body ((old)))") == "`old` is deprecated: use new.\n");
  CHECK(messages("; Deprecated:\r\n" + old + "(defskill mission :body ((old)))") ==
        "`old` is deprecated\n");
  CHECK(messages("; Deprecated: a.\n; Deprecated: b.\n" + old +
                 "(defskill mission :body ((old)))") == "`old` is deprecated: a.\n");
  std::string endless; // each line is read once
  for (int i = 0; i < 40'000; ++i) endless += "; Deprecated: again.\n";
  CHECK(findings(endless + old + body) == "PS0230H old, PS0230H old");
  CHECK(findings("; Deprecated: use new.\n\n" + old + body) == "");
  CHECK(findings("; Not Deprecated: use it.\n" + old + body) == "");
  CHECK(findings("(defsv a :states (A B) :init A) ; Deprecated: use b.\n" + old + body) == "");
  CHECK(findings(old + body + "; Deprecated: use new.") == "");
  CHECK(findings("(defsv a\n  :states (A\n  ; Deprecated: use A.\n  B C)\n  :init B)\n(defevent e "
                 ":effects (a C))") == "PS0230H B");
}

TEST_CASE("a result is compared with the tags of the skill that it is of") {
  CHECK(findings(mission("(^ (= takeoff.res grounded))")) == "");
  CHECK(findings(mission("(^ (= takeoff.res at_altitude))")) == "");
  CHECK(findings(mission("(^ (= takeoff.res no_result))")) == "");
  CHECK(findings(mission("(^ (= survey.res powered))")) == "");
  CHECK(findings(mission("(^ (= survey.res grounded))")) == "PS0205 grounded");
  CHECK(findings(mission("(^ (= survey.res takeoff.res))")) == "");
}

TEST_CASE("the sides of a comparison can be swapped") {
  CHECK(findings(mission("(^ (= success takeoff.status)) (^ (/= grounded takeoff.res))")) == "");
  CHECK(findings(mission("(^ (= Low battery)) (^ (= 2 level))")) == "");
  CHECK(findings(mission("(^ (= landed takeoff.status))")) == "PS0211 landed");
}

TEST_CASE("a word beside an enumeration is its value first, then a state variable") {
  CHECK(findings(mission("(^ (= battery Low))")) == "");
  CHECK(findings(mission("(^ (= battery battery))")) == "");
  CHECK(findings("(defsv Low :states (Good Low) :init Low)"
                 "(defsv battery :states (Good Low) :init Low)"
                 "(defevent e :effects (battery Low))") == "");
}

TEST_CASE("a misspelt name comes with what was probably meant") {
  auto suggested = [](const std::string& text) {
    const auto found = diagnose(text);
    return found.size() == 1 && found[0].fixes.size() == 1 ? found[0].fixes[0].text : "";
  };
  CHECK(suggested(mission("(takeof height 1 duration 1)")) == "takeoff");
  CHECK(suggested(mission("(whlie (battery Good) (survey))")) == "while");
  CHECK(suggested(mission("(^ (batery Good))")) == "battery");
  CHECK(suggested(mission("(^ (battery good))")) == "Good");
  CHECK(suggested(mission("(^ (= takeoff.res gronded))")) == "grounded");
  CHECK(suggested(mission("(^ (= takeoff.status sucess))")) == "success");
  CHECK(suggested(mission("(takeoff heigth 1 duration 1)")) == "height");
  CHECK(suggested(mission("(label again) (goto agian)")) == "again");
  CHECK(suggested(mission("(^ (wind Good))")) == "");
}

TEST_CASE("a definition that is missing is told once, with all that would use it") {
  const auto found = diagnose(mission("(landing) (^ 1) (if (= landing.status success) (landing))"));
  REQUIRE(found.size() == 1);
  CHECK(found[0].related.size() == 2);
  CHECK(found[0].fixes.empty());
  std::string many;
  for (int i = 0; i < 100; ++i) many += "(landing)";
  const auto often = diagnose(mission(many));
  REQUIRE(often.size() == 1);
  REQUIRE(often[0].related.size() == 10);
  CHECK(often[0].related.back().message == "used here too, and 89 more times");
}

TEST_CASE("a misspelt definition is told once, and fixed where it stands") {
  auto fixed = [](std::string text) {
    const auto found = diagnose(text);
    if (found.size() != 1 || found[0].fixes.size() != 1) return findings(text);
    const auto& fix = found[0].fixes[0];
    text.replace(fix.location.range.begin, fix.location.range.length(), fix.text);
    return findings(text);
  };
  CHECK(fixed("(defskill tak :action (take))\n(defskill mission :body ((take) (^ 1) (take)))") ==
        "");
  CHECK(fixed("(defsv light :states (Of On) :init Off)\n(defevent e :effects (light Off))") == "");
  CHECK(fixed("(defskill s :input ($hight nat) :action (s $height))\n"
              "(defskill mission :body ((s height 1)))") == "");
  CHECK(fixed(mission("(label agian) (^ 1) (if (level 1) (goto again)) (goto again)")) == "");
  CHECK(fixed("(defsv moton :states (A B) :init A)\n"
              "(defskill s :input ($x motion) :precondition (a (motion A)) :action (s $x))\n"
              "(defskill mission :body ((s x A)))") == "");
}

TEST_CASE("a use that is misspelt is a mistake of its own, with an edit of its own") {
  const auto found = diagnose(mission("(takeof height 1 duration 1) (takeof height 1 duration 1) "
                                      "(takeoff height 1 duration 1)"));
  REQUIRE(found.size() == 2);
  for (const auto& each : found) {
    REQUIRE(each.fixes.size() == 1);
    CHECK(each.fixes[0].location == each.location);
  }
}

TEST_CASE("what was not read hides names, and is told alone") {
  CHECK(findings("(defskil take :action (take))\n(defskill mission :body ((take)))") ==
        "PS0109 defskil");
  CHECK(findings("(include \"missing.proskill\")\n"
                 "(defskill mission :body ((take) (^ (light On))))") == "PS0006 missing.proskill");
  CHECK(findings("(defskill take :action (take) :succes done)\n"
                 "(defskill mission :body ((take) (if (= take.res done) (^ 1))))") ==
        "PS0113 :succes");
  CHECK(findings("(defskill :action (take))\n(defskill mission :body ((take)))") ==
        "PS0111 defskill");
  // a name near to a known one is still misspelt
  CHECK(findings("(include \"missing.proskill\")\n(defskill take :action (take))\n"
                 "(defskill mission :body ((take) (tke)))") ==
        "PS0006 missing.proskill, PS0201 tke");
}

TEST_CASE("a second definition is told with the first beside it") {
  CHECK(findings(kWorld + "(defsv battery :init 0 :min 0 :max 1)") == "PS0220 battery");
  CHECK(findings(kWorld + "(defevent drained :effects (battery Low))") == "PS0220 drained");
  CHECK(findings(kWorld + "(defresource arm)") == "PS0220 arm");
  CHECK(findings(kWorld + "(defskill survey :action (survey))") == "PS0220 survey");
  CHECK(findings(kWorld + "(defproperty p (deadlockfree)) (defproperty p (deadlockfree))") ==
        "PS0220 p");
  const auto found = diagnose("(defresource arm) (defresource arm)");
  REQUIRE(found.size() == 1);
  REQUIRE(found[0].related.size() == 1);
  CHECK(found[0].related[0].location.range.begin == 13);
}

TEST_CASE("namespaces are separate") {
  CHECK(findings(kWorld + "(defevent battery :effects (battery Low)) (defresource battery)"
                          "(defskill battery :resources (battery) :action (battery))") == "");
}

TEST_CASE("names inside of a definition are told when they come twice") {
  CHECK(findings("(defsv s :states (A B A) :init A)") == "PS0221 A");
  CHECK(findings("(defskill s :input ($x nat $x int) :action (s $x))") == "PS0221 x");
  CHECK(findings(kWorld + "(defskill s :action (s) :precondition (a (level 1) a (level 2)))") ==
        "PS0221 a");
  CHECK(findings(kWorld + "(defskill s :action (s) :invariant (a (:guard (level 1)) "
                          "a (:guard (level 2))))") == "PS0221 a");
  CHECK(findings("(defskill s :action (s) :failure (a b a))") == "PS0221 a");
  CHECK(findings("(defskill s :action (s) :success a :failure a)") == "");
  CHECK(findings(mission("(label a) (// ((label a)) ((^ 1)))")) == "PS0221 a");
}

TEST_CASE("no tag is called as the absence of one") {
  CHECK(findings("(defskill s :action (s) :success no_result)") == "PS0222 no_result");
  CHECK(findings("(defskill s :action (s) :failure (lost no_result))") == "PS0222 no_result");
  CHECK(findings(kWorld + "(defskill s :action (s) :invariant (no_result (:guard (level 1))))") ==
        "PS0222 no_result");
  CHECK(findings("(defskill m :success no_result :body ((success no_result)))") ==
        "PS0222 no_result, PS0222 no_result");
  CHECK(findings("(defskill s :action (s)) (defskill m :body ((s) (^ (= s.res no_result))))") ==
        "");
}

TEST_CASE("no skill is called as a statement, which nothing could call") {
  for (const std::string word : {"if", "case", "while", "do", "break", "label", "goto", "set",
                                 "printf", "success", "failure", "emit", "choose", "race"})
    CHECK(findings("(defskill " + word + " :action (x))") == "PS0222 " + word);
  CHECK(findings("(defskill wait :action (x)) (defskill m :body ((wait)))") == "");
}

TEST_CASE("nothing that is compared is called as a truth value") {
  CHECK(findings("(defsv v :states (true Off) :init true)") == "PS0222 true");
  CHECK(findings("(defsv false :states (On Off) :init On)") == "PS0222 false");
  CHECK(findings("(defskill s :action (s) :failure (lost true))") == "PS0222 true");
  CHECK(findings("(defskill s :action (s) :input ($true bool))") == "");
  CHECK(findings("(defevent true :effects (level 1))" + kWorld) == "");
}

TEST_CASE("a state variable has values") {
  CHECK(findings("(defsv v :states () :init Good)") == "PS0110 ()");
  CHECK(findings("(defsv v :states () :init Good) (defskill m :body ((^ (v Good))))") ==
        "PS0110 ()");
}

TEST_CASE("an unknown name is not reported again by what depends on it") {
  CHECK(findings(mission("(^ (= wind Strong))")) == "PS0202 wind");
  CHECK(findings(mission("(^ (and (wind Strong) (> (+ wind 1) level)))")) == "PS0202 wind");
  CHECK(findings(mission("(set (wind (+ level 1)))")) == "PS0202 wind");
  CHECK(findings(mission("(landing speed 3 mode Fast)")) == "PS0201 landing");
  CHECK(findings(mission("(landing 3)")) == "PS0201 landing");
  CHECK(findings(mission("(printf \"%d\" wind)")) == "PS0202 wind");
  CHECK(findings("(defskill s :input ($x real) :action (s $x))"
                 "(defskill m :body ((s x 1)))") == "PS0209 real");
  CHECK(findings(mission("(takeoff hight 1 duration 2)")) == "PS0208 hight");
}

TEST_CASE("a fragment may use what only its root defines") {
  const std::string fragment = "(defskill land :action (land) :start (motion Controlled))"
                               "(defskill down :body ((land) (hover) (^ (= motion Free))))";
  CHECK(findings(fragment) == "PS0202 motion, PS0201 hover");
  CHECK(findings(fragment, Extent::Fragment) == "PS0202H motion, PS0201H hover");
  CHECK(findings(kWorld + "(defevent e :effects (battery Empty))", Extent::Fragment) ==
        "PS0203 Empty");
}

TEST_CASE("among thousands of unknown names what was meant is not looked for without end") {
  std::string text;
  for (int i = 0; i < 3000; ++i)
    text += "(defskill skill" + std::to_string(i) + " :body ((skil" + std::to_string(i) + ")))\n";
  const auto found = diagnose(text);
  std::vector<std::size_t> fixes;
  for (const auto& it : found)
    if (it.code == proskill::syntax::Code::UnknownSkill) fixes.push_back(it.fixes.size());
  REQUIRE(fixes.size() == 3000);
  CHECK(fixes.front() == 1);
  CHECK(fixes.back() == 0);
}
