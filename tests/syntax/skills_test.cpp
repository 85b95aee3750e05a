#include "tests/syntax/programs.h"

#include <catch2/catch.hpp>

namespace proskill::test::skills_test {

using syntax::Rational;
using syntax::Skill;
using test::Parsed;

namespace {

std::string codes(const std::string& fields) {
  return test::codesOf(syntax::Document::parse("(defskill s " + fields + ")"));
}

/// The fields with the first fix of each diagnostic, from the last one to the first.
std::string mended(const std::string& fields) {
  std::string text = "(defskill s " + fields + ")";
  const auto document = syntax::Document::parse(text);
  auto found = document.diagnostics();
  std::ranges::sort(found, std::greater{}, [](const auto& it) { return it.location.range.begin; });
  for (const auto& each : found) {
    REQUIRE(!each.fixes.empty());
    const auto& [title, location, by] = each.fixes[0];
    text.replace(location.range.begin, location.range.length(), by);
  }
  CHECK(test::codesOf(syntax::Document::parse(text)) == "");
  return text.substr(12, text.size() - 13);
}

} // namespace

TEST_CASE("parentheses around an outcome or a name are removed by a fix") {
  CHECK(mended(":failure ((cold) (hot))") == ":failure (cold hot)");
  CHECK(mended(":success ((done :effects (a B)))") == ":success (done (:effects (a B)))");
  CHECK(mended(":success ((done (:effects (a B))) late)") ==
        ":success (done (:effects (a B)) late)");
  CHECK(mended(":success ((done ; why\n :effects (a B) ; c\n))") ==
        ":success (done ; why\n (:effects (a B)) ; c\n)");
  CHECK(mended(":body ((success (done)))") == ":body ((success done))");
  Parsed<Skill> wrapped("(defskill s :success ((done :effects (a B)) late))");
  CHECK(test::codesOf(wrapped.document) == "PS0124");
  REQUIRE(wrapped->successes.size() == 2);
  CHECK(wrapped->successes[0].tag.text == "done");
}

TEST_CASE("a condition without a tag gets one by a fix") {
  CHECK(mended(":precondition ((a B) (< c 3))") == ":precondition (a_B (a B) c_3 (< c 3))");
  CHECK(mended(":precondition (n_1 (a B) (< n 1) (/= n 1))") ==
        ":precondition (n_1 (a B) n_1_2 (< n 1) n_1_3 (/= n 1))");
  CHECK(mended(":invariant ((:guard (a B)))") == ":invariant (a_B (:guard (a B)))");
  CHECK(mended(":invariant ((a B))") == ":invariant (a_B (:guard (a B)))");
}

TEST_CASE("outcomes in all their forms") {
  Parsed<Skill> bare("(defskill s :success done)");
  REQUIRE(bare->successes.size() == 1);
  CHECK(bare->successes[0].tag.text == "done");

  Parsed<Skill> several("(defskill s :failure (cold hot (:effects (a B)) wet))");
  REQUIRE(several->failures.size() == 3);
  CHECK(several->failures[0].effects.items.empty());
  CHECK(several->failures[1].effects.items.size() == 1);
  CHECK(several->failures[2].tag.text == "wet");

  Parsed<Skill> full("(defskill s :success done (:effects ((a B) (c D)) :postcondition (e F)))");
  CHECK(full->successes[0].effects.items.size() == 2);
  CHECK(full->successes[0].postcondition->name.text == "e");
  CHECK(test::codesOf(full.document) == "");
}

TEST_CASE("resources, monitors, actions with arguments") {
  Parsed<Skill> skill("(defskill s :input ($h float $deep bool) :resources (arm gripper)\n"
                      "  :action (move_arm $h \"fast\" -0.5 true) :monitor t)");
  CHECK(test::codesOf(skill.document) == "");
  CHECK(skill->resources.at(1).text == "gripper");
  CHECK(skill->monitor);
  CHECK_FALSE(skill->armed);
  REQUIRE(skill->action->arguments.size() == 4);
  CHECK(skill->action->arguments[0].kind == syntax::ExprKind::Parameter);
  CHECK(skill->action->arguments[0].name.text == "$h");
  CHECK(skill->action->arguments[1].name.text == "fast");
  CHECK(skill->action->arguments[2].number == Rational{-1, 2});
  CHECK(skill->action->arguments[3].kind == syntax::ExprKind::True);
}

TEST_CASE("a composite skill has a body, even an empty one") {
  CHECK(Parsed<Skill>("(defskill s :body ())")->isComposite());
  CHECK(Parsed<Skill>("(defskill s :body)")->isComposite());
  CHECK_FALSE(Parsed<Skill>("(defskill s :action (go))")->isComposite());
}

TEST_CASE("intervals of seconds") {
  auto interval = [](const std::string& text) {
    Parsed<Skill> skill("(defskill s :time_interval " + text + ")");
    INFO(text);
    CHECK(test::codesOf(skill.document) == "");
    return skill->timeInterval.value();
  };
  CHECK(interval("[1,3]").lower == Rational{1});
  CHECK(interval("[60 , 120]").upper == Rational{120});
  CHECK(interval("]0,1]").lowerOpen);
  CHECK_FALSE(interval("]0,1]").upperOpen);
  CHECK(interval("[0.5,2[").lower == Rational{1, 2});
  CHECK(interval("[0.5,2[").upperOpen);
  CHECK_FALSE(interval("[1,...[").upper);
  CHECK(interval("[1,...[").upperOpen);
}

TEST_CASE("malformed intervals are one diagnostic each") {
  for (std::string text : {"[", "[]", "[1", "[1]", "[1 3]", "[1,", "[1,]", "[,3]", "[1,3", "[-1,3]",
                           "]1,,3]", "[a,$b]"}) {
    INFO(text);
    CHECK(codes(":time_interval " + text).find("PS0116") == 0);
  }
  CHECK(codes(":time_interval 3") == "PS0115");
  CHECK(codes(":time_interval [1,3] [2,4]") == "PS0112");
}

TEST_CASE("malformed fields of skills are one diagnostic each") {
  CHECK(codes(":input ($height)") == "PS0114");
  CHECK(codes(":input (height float)") == "PS0115");
  CHECK(codes(":precondition ((a B))") == "PS0125");
  CHECK(codes(":precondition (tag)") == "PS0119");
  CHECK(codes(":precondition (one two (a B))") == "PS0119");
  CHECK(codes(":invariant (tag)") == "PS0119");
  CHECK(codes(":invariant (tag ())") == "PS0110");
  CHECK(codes(":invariant (tag (:effects (a B)))") == "PS0114");
  CHECK(codes(":invariant (tag (:guard (a B) :effect (c D)))") == "PS0113");
  CHECK(codes(":invariant (tag ((a B)))") == "PS0115");
  CHECK(codes(":success (:effects (a B))") == "PS0124");
  CHECK(codes(":success (done :effects (a B) :postcondition (c D))") == "PS0124");
  CHECK(codes(":success (done :effects ((a B) (c D)) late :effects (a B))") == "PS0124 PS0124");
  CHECK(codes(":success") == "PS0114");
  CHECK(codes(":success done (:postcondition)") == "PS0114");
  CHECK(codes(":action go") == "PS0115");
  CHECK(codes(":action ()") == "PS0111");
  CHECK(codes(":monitor yes") == "PS0115");
  CHECK(codes(":monitor always") == "");
  CHECK(codes(":interruptible nil") == "");
  CHECK(codes(":interruptible t") == "");
  CHECK(codes(":interruptible no") == "PS0115");
  CHECK(codes(":interruptible") == "PS0114");
  CHECK(codes(":interrupt (a B)") == "PS0115");
  CHECK(codes(":resources arm") == "PS0115");
  CHECK(codes(":body (go)") == "PS0121");
}

TEST_CASE("a bad word is reported as such, and nowhere else") {
  CHECK(codes(":input ($height float, $duration float)") == "PS0105");
  CHECK(codes(":resources (left-arm)") == "PS0106");
  CHECK(codes(":body ((take-off))") == "PS0106");
  CHECK(codes(":body ((printf \"a\\q\"))") == "PS0104");
  CHECK(codes(":start (motion Contrôlé)") == "PS0106");
  CHECK(codes(":body ((fly height 0.00000000000000000000001))") == "PS0107");
}

} // namespace proskill::test::skills_test
