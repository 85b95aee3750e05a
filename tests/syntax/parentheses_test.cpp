#include "tests/support/marked_source.h"
#include "tests/syntax/programs.h"

#include <catch2/catch.hpp>

using namespace proskill;
using syntax::Code;
using syntax::Document;

/// Parentheses are diagnosed where a person would look: one error, one diagnostic.
namespace {

/// The marked `(` is reported as unclosed, and its `)` is proposed at the point.
void checkUnclosed(std::string_view marked) {
  test::MarkedSource source(marked);
  auto document = Document::parse(source.text);
  INFO(source.text);
  REQUIRE(test::codesOf(document) == "PS0101");
  const auto& diagnostic = document.diagnostics()[0];
  CHECK(diagnostic.location.range.begin == source.range().begin);
  REQUIRE(diagnostic.fixes.size() == 1);
  CHECK(diagnostic.fixes[0].location.range.begin == source.point());
  REQUIRE_FALSE(diagnostic.related.empty());
  CHECK(diagnostic.related.back().location.range.begin == source.point());
}

/// The marked `)` is reported as superfluous.
void checkSurplus(std::string_view marked) {
  test::MarkedSource source(marked);
  auto document = Document::parse(source.text);
  INFO(source.text);
  REQUIRE(test::codesOf(document) == "PS0102");
  CHECK(document.diagnostics()[0].location.range == source.range());
}

} // namespace

TEST_CASE("a field that is not closed before the next keyword") {
  checkUnclosed(R"(
(defsv battery
  :states [[(]]Good Low Critical^
  :init Good
  :transitions :all)
)");
}

TEST_CASE("a field that is not closed, all in one line") {
  checkUnclosed("(defsv battery :states [[(]]Good Low Critical^ :init Good :transitions :all)");
}

TEST_CASE("a precondition that is not closed") {
  checkUnclosed(R"(
(defskill takeoff
  :precondition [[(]]not_moving (motion Free)
                 on_ground (flight_status OnGround)^
  :start (motion Controlled)
  :action (takeoff))
)");
}

TEST_CASE("the last parenthesis of a definition is missing") {
  checkUnclosed(R"(
[[(]]defskill takeoff
  :start (motion Controlled)
  :action (takeoff)^

(defevent gust :effects (motion Free))
)");
}

TEST_CASE("a statement that is not closed before the next one") {
  checkUnclosed(R"(
(defskill mission
  :body ((takeoff)
         [[(]]camera_survey^
         (landing)))
)");
}

TEST_CASE("a condition that is not closed before its statements") {
  checkUnclosed(R"(
(defskill mission
  :body ((if [[(]]= takeoff.status success^
           (landing))
         (printf "done")))
)");
}

TEST_CASE("an if that is not closed before the statement after it") {
  checkUnclosed(R"(
(defskill mission
  :body ((takeoff)
         [[(]]if (= takeoff.status success)
           (landing)^
         (printf "done")
         (success done)))
)");
}

TEST_CASE("a branch that is not closed before the next one") {
  checkUnclosed(R"(
(defskill mission
  :body ((// [[(]](takeoff)
             (landing)^
             ((camera_survey)))
         (printf "done")))
)");
}

TEST_CASE("an event that is not closed before the next one") {
  checkUnclosed(R"(
[[(]]defevent gust
  :effects (motion Free)^
(defevent lull
  :effects (motion Controlled))
)");
}

TEST_CASE("a definition that breaks off leaves those after it alone") {
  auto document = Document::parse(R"(
(defskill mission
  :body ((takeoff)
         (if (= takeoff.
(defevent gust
  :effects (motion Free))
)");
  REQUIRE(test::codesOf(document) == "PS0101");
  CHECK(document.diagnostics()[0].related.size() == 4);
  REQUIRE(document.forms().size() == 2);
  CHECK(document.forms()[0].recovered);
  CHECK_FALSE(document.forms()[1].recovered);
  CHECK(std::get<syntax::Event>(document.forms()[1].node()).effects.items.size() == 1);
}

TEST_CASE("a definition that is closed too early") {
  checkSurplus(R"(
(defsv battery
  :states (Good Low Critical)[[)]]
  :init Good
  :transitions :all)
)");
}

TEST_CASE("one parenthesis too many at the end of a definition") {
  checkSurplus(
      "(defevent gust\n  :effects (motion Free))[[)]]\n\n(defevent lull :effects (motion A))");
}

TEST_CASE("a parenthesis that stands alone between definitions") {
  checkSurplus(
      "(defevent gust :effects (motion Free))\n[[)]]\n(defevent lull :effects (motion A))");
}

TEST_CASE("a body that is closed too early") {
  checkSurplus(R"(
(defskill mission
  :body ((takeoff)
         (if (= takeoff.status success)
           (landing))[[)]]
         (printf "done")
         (success done)))
)");
}

TEST_CASE("a branch that is closed too early") {
  checkSurplus(R"(
(defskill mission
  :body ((// ((takeoff)[[)]]
              (landing))
             ((camera_survey)))
         (printf "done")))
)");
}

TEST_CASE("two mistakes in two places are two diagnostics") {
  auto document = Document::parse(R"(
(defskill takeoff
  :start (motion Controlled
  :interrupt (:effects (motion Free)
  :action (takeoff))
)");
  CHECK(test::codesOf(document) == "PS0101 PS0101");
}

TEST_CASE("parentheses in comments and strings do not count") {
  auto document = Document::parse(R"program(
(defskill greet ; :-) (
  :body ((printf "(((") ; )))
         (printf ")\")")))
)program");
  CHECK(test::codesOf(document) == "");
}

TEST_CASE("a string that is not closed takes no parentheses with it") {
  auto document = Document::parse(R"(
(defskill greet
  :body ((printf "hello)
         (landing)))
)");
  REQUIRE(test::codesOf(document) == "PS0103");
  CHECK(std::get<syntax::Skill>(document.forms().at(0).node()).body->statements.size() == 2);
}

TEST_CASE(
    "each closing parenthesis that is left out of a program is one diagnostic near its line") {
  auto sound = Document::parse(test::allPrograms().at(1));
  for (syntax::Offset at = 0; at < sound.text().size(); ++at) {
    bool comment = std::ranges::any_of(sound.comments(), [&](auto it) { return it.contains(at); });
    if (sound.text()[at] != ')' || comment) continue;
    auto document = sound.edit({at, at + 1}, "");
    INFO(document.text());
    REQUIRE(test::codesOf(document) == "PS0101");
    auto line = sound.lines().position(at).line;
    auto proposed = document.diagnostics()[0].fixes.at(0).location.range.begin;
    CHECK(document.lines().position(proposed).line == line);
  }
}

TEST_CASE("where parentheses are recovered, all else is read as it was meant") {
  auto document = Document::parse(R"(
(defskill takeoff
  :precondition (on_ground (flight_status OnGround)
  :start (motion Controlled)
  :time_interval [1,3]
  :action (takeoff))
)");
  const auto& takeoff = std::get<syntax::Skill>(document.forms().at(0).node());
  CHECK(takeoff.fields.size() == 4);
  CHECK(takeoff.start.items.size() == 1);
  CHECK(takeoff.timeInterval->upper == syntax::Rational{3});
  CHECK(takeoff.action->command.text == "takeoff");
}
