#include "tests/syntax/programs.h"

#include <catch2/catch.hpp>

using namespace proskill;
using syntax::Property;
using syntax::PropertyKind;
using test::Parsed;

namespace {

std::string codes(const std::string& body) {
  return test::codesOf(syntax::Document::parse("(defproperty p " + body + ")"));
}

} // namespace

TEST_CASE("the paper's wish") {
  Parsed<Property> wish(
      "(defproperty critical_lands (leadsto (and (battery Critical) (flight_status InAir))\n"
      "                                     (running landing) :within [0,1]))");
  CHECK(test::codesOf(wish.document) == "");
  CHECK(wish->name.text == "critical_lands");
  CHECK(wish->kind == PropertyKind::LeadsTo);
  CHECK(wish->head.text == "leadsto");
  REQUIRE(wish->operands.size() == 2);
  CHECK(wish->operands[1].kind == syntax::ExprKind::Running);
  CHECK(wish->within->upper == syntax::Rational{1});
}

TEST_CASE("every pattern") {
  auto kind = [](const std::string& body) {
    INFO(body);
    CHECK(codes(body) == "");
    return Parsed<Property>("(defproperty p " + body + ")")->kind;
  };
  CHECK(kind("(always (a B))") == PropertyKind::Always);
  CHECK(kind("(never (a B))") == PropertyKind::Never);
  CHECK(kind("(reachable (ended s success))") == PropertyKind::Reachable);
  CHECK(kind("(deadlockfree)") == PropertyKind::DeadlockFree);
  CHECK(kind("(infinitelyoften (a B))") == PropertyKind::InfinitelyOften);
  CHECK(kind("(leadsto (a B) (c D))") == PropertyKind::LeadsTo);
  CHECK(kind("(precedes (a B) (c D))") == PropertyKind::Precedes);
  CHECK(kind("(present (a B) :after (c D) :before (e F) :within [0,2] :lasting 1.5)") ==
        PropertyKind::Present);
  CHECK(kind("(absent (a B) :after (c D) :before true :for [0,2])") == PropertyKind::Absent);
  CHECK(kind("(ltl ([] (a B)))") == PropertyKind::Ltl);
}

TEST_CASE("the fields of a pattern") {
  Parsed<Property> present("(defproperty p (present (a B) :after (occurs e) :lasting 1.5))");
  CHECK(present->after->name.text == "e");
  CHECK_FALSE(present->before);
  CHECK(present->lasting->number == syntax::Rational{3, 2});
  CHECK(present->fields.size() == 2);
}

TEST_CASE("a property of what happens in the end says which runs count") {
  const auto fair = [](const std::string& pattern) {
    return Parsed<Property>("(defproperty p " + pattern + ")")->fair;
  };
  CHECK(fair("(infinitelyoften (a B) :fair nil)") == false);
  CHECK(fair("(ltl ([] (a B)) :fair t)") == true);
  CHECK_FALSE(fair("(present (a B))").has_value());
  Parsed<Property> named("(defproperty p (present (a B) :fair (drive dock)))");
  CHECK(named->fair == true);
  REQUIRE(named->fairSkills.size() == 2);
  CHECK(named->fairSkills[1].text == "dock");
  CHECK(codes("(present (a B) :fair ())") == "PS0115");
  CHECK(codes("(leadsto (a B) (c D) :fair nil)") == "");
  CHECK(codes("(leadsto (a B) (c D) :fair always)") == "PS0115");
  CHECK(codes("(always (a B) :fair t)") == "PS0113");
}

TEST_CASE("malformed properties are one diagnostic each") {
  CHECK(codes("") == "PS0127");
  CHECK(codes("()") == "PS0110");
  CHECK(codes("always") == "PS0126");
  CHECK(codes("(alway (a B))") == "PS0126");
  CHECK(codes("(always)") == "PS0118");
  CHECK(codes("(always (a B) (c D))") == "PS0118");
  CHECK(codes("(always (a B) :within [0,1])") == "PS0113");
  CHECK(codes("(leadsto (a B) (c D) :within 1)") == "PS0115");
  CHECK(codes("(present (a B) :lasting [0,1])") == "PS0115");
  CHECK(codes("(always (a B)) (never (c D))") == "PS0112");
  CHECK(codes("(never (<> (a B)))") == "PS0128");
}
