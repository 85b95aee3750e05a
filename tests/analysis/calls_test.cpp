#include "tests/analysis/findings.h"

#include "syntax/diagnostics/codes.h"

#include <catch2/catch.hpp>

using proskill::test::diagnose;
using proskill::test::findings;
using proskill::test::kWorld;
using proskill::test::mission;
namespace syntax = proskill::syntax;

TEST_CASE("a call gives each input once") {
  CHECK(findings(mission("(takeoff height 3.0 duration 0)")) == "");
  CHECK(findings(mission("(takeoff duration 0 height 3)")) == "");
  CHECK(findings(mission("(takeoff height 3.0)")) == "PS0320 takeoff");
  CHECK(findings(mission("(takeoff)")) == "PS0320 takeoff");
  CHECK(findings(mission("(takeoff height 1 duration 2 height 3)")) == "PS0321 height");
  CHECK(findings(mission("(takeoff height 1 duration 2 speed 3)")) == "PS0208 speed");
  CHECK(findings(mission("(survey speed 3)")) == "PS0208 speed");
  CHECK(findings(mission("(takeoff 3.0)")) == "PS0123 3.0");
  CHECK(diagnose(mission("(takeoff)"))[0].message ==
        "the call of `takeoff` needs `height` and `duration`");
}

TEST_CASE("a value without the name of its input gets the name where only one is left") {
  const std::string go = "(defskill go :input ($to battery $speed int) :action (go $to $speed))"
                         "(defskill wait :input ($long nat) :action (wait $long))";
  const auto fixed = [&](const std::string& call) {
    const auto found = diagnose(kWorld + go + "(defskill m :body (" + call + "))");
    REQUIRE(found.size() == 1);
    CHECK(syntax::info(found[0].code).id == "PS0320");
    return found[0].fixes.at(0).title;
  };
  CHECK(fixed("(wait 3)") == "write the name `long` before the value");
  CHECK(fixed("(go speed 3 Low)") == "write the name `to` before the value");
  CHECK(fixed("(go to Low 3)") == "write the name `speed` before the value");
  CHECK(findings(kWorld + go + "(defskill m :body ((go Low)))") == "PS0123 Low, PS0208 Low");
  CHECK(findings(kWorld + go + "(defskill m :body ((wait long)))") == "PS0123 long");
}

TEST_CASE("arguments have the types of their inputs") {
  auto call = [](const std::string& type, const std::string& value) {
    return findings(kWorld + "(defskill s :input ($p " + type + ") :action (s $p))" +
                    "(defskill m :body ((s p " + value + ")))");
  };
  CHECK(call("nat", "3") == "");
  CHECK(call("nat", "-3") == "PS0322 -3");
  CHECK(call("nat", "3.0") == "PS0322 3.0");
  CHECK(call("int", "3") == "");
  CHECK(call("int", "-3") == "");
  CHECK(call("int", "0.5") == "PS0322 0.5");
  CHECK(call("float", "3") == "");
  CHECK(call("float", "-0.5") == "");
  CHECK(call("float", "\"3\"") == "PS0322 \"3\"");
  CHECK(call("bool", "true") == "");
  CHECK(call("bool", "1") == "PS0322 1");
  CHECK(call("string", "\"here\"") == "");
  CHECK(call("string", "here") == "PS0323 here");
  CHECK(call("string", "3") == "PS0322 3");
  CHECK(call("battery", "Low") == "");
  CHECK(call("battery", "Empty") == "PS0203 Empty");
  CHECK(call("battery", "1") == "PS0322 1");
  CHECK(call("level", "3") == "");
  CHECK(call("level", "4") == "PS0305 4");
  CHECK(call("level", "1.5") == "PS0322 1.5");
  CHECK(call("nat", "(+ 1 2)") == "PS0323 (+ 1 2)");
  CHECK(call("nat", "level") == "PS0323 level");
}

TEST_CASE("an input is handed on where its type fits") {
  auto handOn = [](const std::string& from, const std::string& to) {
    return findings(kWorld + "(defskill s :input ($p " + to + ") :action (s $p))" +
                    "(defskill t :input ($q " + from + ") :body ((s p $q)))" +
                    "(defskill m :body ((t " + (from == "battery" ? "q Low" : "q 1") + ")))");
  };
  CHECK(handOn("nat", "nat") == "");
  CHECK(handOn("nat", "float") == "");
  CHECK(handOn("level", "nat") == "");
  CHECK(handOn("battery", "battery") == "");
  CHECK(handOn("float", "nat") == "PS0322 $q");
  CHECK(handOn("nat", "level") == "PS0322 $q");
  CHECK(handOn("battery", "camera") == "PS0322 $q");
}

TEST_CASE("an action takes literals and the skill's own inputs") {
  CHECK(findings("(defskill s :input ($x float) :action (go $x 1 -2.5 \"fast\" true))") == "");
  CHECK(findings("(defskill s :action (go fast))") == "PS0323 fast");
  CHECK(findings("(defskill s :action (go $x))") == "PS0208 x");
}

TEST_CASE("a word where an action takes a text may be put in quotes") {
  const auto fixOf = [](const std::string& text) {
    const auto found = diagnose(kWorld + text);
    return found.size() == 1 && found[0].fixes.size() == 1 ? found[0].fixes[0].text : std::string();
  };
  CHECK(fixOf("(defskill s :action (go fast))") == "\"fast\"");
  CHECK(fixOf("(defskill s :action (go Low))") == "\"Low\"");
  CHECK(fixOf("(defskill s :action (go battery))").empty());
}

TEST_CASE("a monitor cannot be called") {
  CHECK(findings(kWorld + "(defskill watch :monitor t :body ((^ (battery Low))))"
                          "(defskill m :body ((watch)))") == "PS0421 watch");
}

TEST_CASE("nobody gives inputs to what starts with the program") {
  CHECK(findings("(defskill m :input ($x nat) :body ((^ 1)))") == "PS0422 $x");
  CHECK(findings("(defskill w :monitor t :input ($x nat) :body ((^ 1)))") == "PS0422 $x");
  CHECK(findings("(defskill s :input ($x nat) :body ((^ 1))) (defskill m :body ((s x 1)))") == "");
}

TEST_CASE("skills do not call themselves") {
  CHECK(findings("(defskill a :body ((a)))") == "PS0420 a");
  CHECK(findings("(defskill a :body ((b))) (defskill b :body ((c))) (defskill c :body ((b)))") ==
        "PS0420 b");
  CHECK(findings("(defskill a :body ((b) (b))) (defskill b :action (b))") == "");
  const auto found = diagnose("(defskill a :body ((b))) (defskill b :body ((c)))"
                              "(defskill c :body ((a)))");
  REQUIRE(found.size() == 1);
  CHECK(found[0].message == "`a` calls itself, directly or through other skills");
  REQUIRE(found[0].related.size() == 2);
  CHECK(found[0].related[0].message == "`a` calls `b` here");
  CHECK(found[0].related[1].message == "`b` calls `c` here");
}

TEST_CASE("a long chain of calls is no recursion") {
  std::string text = "(defskill s0 :action (s))";
  for (int i = 1; i <= 20000; ++i)
    text += "\n(defskill s" + std::to_string(i) + " :body ((s" + std::to_string(i - 1) + ")))";
  CHECK(findings(text) == "");
}

TEST_CASE("two branches that may call the same skill are warned of") {
  const std::string lift = "(takeoff height 1 duration 1)";
  CHECK(findings(mission("(// (" + lift + ") ((survey)))")) == "");
  CHECK(findings(mission("(// (" + lift + lift + ") ((survey)))")) == "");
  CHECK(findings(mission("(// ((survey)) ((^ 1) (survey)))")) == "PS0423W survey");
  CHECK(findings(mission("(// ((survey)) ((if (level 1) (survey))))")) == "PS0423W survey");
  CHECK(findings(mission("(// ((survey)) ((^ 1))) (survey)")) == "");
  CHECK(findings(mission("(// ((survey)) ((tour)))") + "(defskill tour :body ((survey)))") ==
        "PS0423W tour");
  CHECK(findings(mission("(// ((// ((survey)) ((^ 1)))) ((survey)))")) == "PS0423W survey");
}

TEST_CASE("what cannot be interrupted is told") {
  CHECK(findings(mission("(survey.interrupt)")) == "");
  CHECK(findings(mission("(takeoff.interrupt)")) == "PS0424W takeoff");
  CHECK(findings(kWorld + "(defenvironment e :body ((survey.interrupt)))") == "");
  CHECK(findings(kWorld + "(defenvironment e :body ((takeoff.interrupt)))") == "PS0424 takeoff");
}
