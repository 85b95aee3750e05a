#include "tests/syntax/programs.h"

#include <catch2/catch.hpp>

using namespace proskill;
using syntax::Document;
using test::codesOf;
using test::Parsed;

TEST_CASE("a natural") {
  Parsed<syntax::StateVariable> level("(defsv level :init 1 :min 0 :max 3)");
  CHECK(level->name.text == "level");
  CHECK(level->isNatural());
  CHECK(level->init.number == syntax::Rational{1});
  CHECK(level->min->number == syntax::Rational{0});
  CHECK(level->max->number == syntax::Rational{3});
  CHECK(level->fields.size() == 3);
}

TEST_CASE("an enumeration with all transitions, stated or not") {
  Parsed<syntax::StateVariable> stated(
      "(defsv d :states (Open Shut) :init Open :transitions :all)");
  CHECK(stated->transitionsKind == syntax::Transitions::All);
  Parsed<syntax::StateVariable> unstated("(defsv d :states (Open Shut) :init Open)");
  CHECK(unstated->transitionsKind == syntax::Transitions::Unstated);
  CHECK(unstated->states.size() == 2);
}

TEST_CASE("an event with one effect, and with two") {
  Parsed<syntax::Event> one("(defevent e :effects (motion Free))");
  CHECK(one->effects.items.size() == 1);
  Parsed<syntax::Event> two("(defevent e :effects ((motion Free) (level (+ level 1))))");
  REQUIRE(two->effects.items.size() == 2);
  CHECK(two->effects.items[1].variable.text == "level");
  CHECK(two->effects.items[1].value.kind == syntax::ExprKind::Add);
}

TEST_CASE("a resource with a capacity, and without") {
  Parsed<syntax::Resource> slots("(defresource slots :capacity 3)");
  CHECK(slots->capacity->number == syntax::Rational{3});
  CHECK_FALSE(Parsed<syntax::Resource>("(defresource arm)")->capacity);
}

TEST_CASE("a constant is a name and a number") {
  Parsed<syntax::Constant> home("(defconst home -0.5)");
  CHECK(home->name.text == "home");
  CHECK(home->value.number == syntax::Rational{-1, 2});
  CHECK(codesOf(Document::parse("(defconst home)")) == "PS0114");
  CHECK(codesOf(Document::parse("(defconst home far)")) == "PS0115");
  CHECK(codesOf(Document::parse("(defconst home 1 2)")) == "PS0112");
  CHECK(codesOf(Document::parse("(defconst)")) == "PS0111");
}

TEST_CASE("an environment") {
  Parsed<syntax::Environment> calm(
      "(defenvironment calm :body ((^ [1,2]) (choose ((emit gust)) ((break)))))");
  REQUIRE(calm->body.statements.size() == 2);
  const auto& choice = calm->body.statements[1];
  CHECK(choice.kind == syntax::StatementKind::Choose);
  CHECK(choice.branches.at(0).statements.at(0).name.text == "gust");
}

TEST_CASE("an include") {
  Parsed<syntax::Include> include("(include \"parts/arm.proskill\")");
  CHECK(include->path.text == "parts/arm.proskill");
  CHECK(include->path.range == syntax::Range{10, 28});
}

TEST_CASE("a platform") {
  Parsed<syntax::Platform> platform("(defplatform \"robots/arm.platform.json\")");
  CHECK(platform->path.text == "robots/arm.platform.json");
  CHECK(platform->path.range == syntax::Range{14, 38});
  CHECK(test::codesOf(platform.document).empty());
}

TEST_CASE("a platform without a path") {
  for (const auto* text : {"(defplatform)", "(defplatform \"\")", "(defplatform robot)"}) {
    INFO(text);
    Parsed<syntax::Platform> platform(text);
    CHECK(platform->path.text.empty());
    CHECK(test::codesOf(platform.document).starts_with("PS0130"));
  }
}

TEST_CASE("a form that the language does not know keeps its head") {
  Parsed<syntax::UnknownForm> form("(defun f (x) x)");
  CHECK(form->head.text == "defun");
  CHECK(test::codesOf(form.document) == "PS0109");
}

TEST_CASE("a form remembers the comment above it") {
  auto document = Document::parse("; about something else\n"
                                  "\n"
                                  "; The wind.\n"
                                  "  ; It comes and goes.\n"
                                  "(defevent gust :effects (a B)) ; not this\n"
                                  "(defevent lull :effects (a C))\n");
  REQUIRE(document.forms().size() == 2);
  auto comment = document.forms()[0].comment;
  CHECK(document.text().substr(comment.begin, comment.length()) ==
        "; The wind.\n  ; It comes and goes.");
  CHECK(document.forms()[1].comment.empty());
  CHECK(document.comments().size() == 4);
}

TEST_CASE("half-typed definitions keep what is there, and say what is missing") {
  Parsed<syntax::StateVariable> nameless("(defsv :init 1)");
  CHECK(test::codesOf(nameless.document) == "PS0111");
  CHECK_FALSE(nameless->name);
  CHECK(nameless->name.range == syntax::Range{6, 6});
  CHECK(nameless->init.number == syntax::Rational{1});

  Parsed<syntax::StateVariable> valueless("(defsv a :init)");
  CHECK(test::codesOf(valueless.document) == "PS0114");
  CHECK(valueless->init.kind == syntax::ExprKind::Missing);
  CHECK(valueless->init.range == syntax::Range{14, 14});

  CHECK(test::codesOf(Document::parse("(")) == "PS0101");
  CHECK(test::codesOf(Document::parse("()")) == "PS0110");
  CHECK(test::codesOf(Document::parse("(defskill)")) == "PS0111");
}

TEST_CASE("of a field that is there twice the first counts, and both are known") {
  Parsed<syntax::StateVariable> level("(defsv level :init 1 :min 0 :max 3 :max 5)");
  CHECK(level->max->number == syntax::Rational{3});
  CHECK(level->fields.size() == 4);
}

TEST_CASE("what does not belong into a definition is one diagnostic") {
  auto codes = [](std::string text) { return test::codesOf(Document::parse(std::move(text))); };
  CHECK(codes("(defsv level 3 4 :init 1)") == "PS0112");
  CHECK(codes("(defsv level :init 1 2 3)") == "PS0112");
  CHECK(codes("(defsv level :initial 1)") == "PS0113");
  CHECK(codes("(defsv level :states Good :init Good)") == "PS0115");
  CHECK(codes("(defsv level :states (Good 3) :init Good)") == "PS0106");
  CHECK(codes("(defsv level :states (A B) :init A :transitions (A B))") == "PS0115");
  CHECK(codes("(defsv v :states (A B) :init (A B))") == "");
  CHECK(codes("(defsv v :states (A B) :init ())") == "PS0110");
  CHECK(codes("(defsv v :states (A B) :init A B)") == "PS0112");
  CHECK(codes("(defevent e :effects)") == "PS0114");
  CHECK(codes("(defevent e :every [1,5] :effects (a B))") == "");
  CHECK(codes("(defevent e :guard (a B) :effects (a B))") == "");
  CHECK(codes("(defevent e :guard :effects (a B))") == "PS0114");
  CHECK(codes("(defevent e :guard (a B) (a C) :effects (a B))") == "PS0112");
  CHECK(codes("(defevent e :every 5 :effects (a B))") == "PS0115");
  CHECK(codes("(defevent e :every :effects (a B))") == "PS0114");
  CHECK(codes("(defevent e :effects ())") == "PS0110");
  CHECK(codes("(defevent e :effects motion)") == "PS0120");
  CHECK(codes("some words (defevent e :effects (a B)) and more") == "PS0108 PS0108");
  CHECK(codes("(include \"a\" \"b\")") == "PS0112");
}

TEST_CASE("a misspelt field or word of a definition comes with the edit that fixes it") {
  const std::string text = "(defskil x :action (x))\n(defskill y :succes ok)\n(zzz)\n";
  const auto document = Document::parse(text);
  const auto& found = document.diagnostics();
  REQUIRE(found.size() == 3);
  const auto fixed = [&](std::size_t i) {
    const syntax::Fix& fix = found[i].fixes.at(0);
    const syntax::Range range = fix.location.range;
    return text.substr(range.begin, range.length()) + " -> " + fix.text;
  };
  CHECK(fixed(0) == "defskil -> defskill");
  CHECK(fixed(1) == ":succes -> :success");
  CHECK(found[2].fixes.empty());
}
