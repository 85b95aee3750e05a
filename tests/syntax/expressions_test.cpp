#include "tests/syntax/programs.h"

#include <catch2/catch.hpp>

using namespace proskill;
using syntax::Expr;
using syntax::ExprKind;

namespace {

/// A condition, or a proposition of a property.
struct Condition {
  syntax::Document document;

  explicit Condition(const std::string& text)
      : document(syntax::Document::parse("(defskill s :body ((^ " + text + ")))")) {}
  const Expr* operator->() const {
    const auto& skill = std::get<syntax::Skill>(document.forms().at(0).node());
    return &skill.body->statements.at(0).condition;
  }
  [[nodiscard]] std::string codes() const { return test::codesOf(document); }
};

struct Formula {
  syntax::Document document;

  explicit Formula(const std::string& text)
      : document(syntax::Document::parse("(defproperty p (ltl " + text + "))")) {}
  const Expr* operator->() const {
    return &std::get<syntax::Property>(document.forms().at(0).node()).operands.at(0);
  }
  [[nodiscard]] std::string codes() const { return test::codesOf(document); }
};

} // namespace

TEST_CASE("a test of a state variable") {
  Condition test("(battery Low)");
  CHECK(test->kind == ExprKind::Test);
  CHECK(test->name.text == "battery");
  CHECK(test->operands.at(0).name.text == "Low");
}

TEST_CASE("connectives in words and in signs") {
  CHECK(Condition("(and (a B) (c D) (e F))")->operands.size() == 3);
  CHECK(Condition("(& (a B) (c D))")->kind == ExprKind::And);
  CHECK(Condition("(or (a B) (c D))")->kind == ExprKind::Or);
  CHECK(Condition("(| (a B) (c D))")->kind == ExprKind::Or);
  CHECK(Condition("(not (a B))")->kind == ExprKind::Not);
  CHECK(Condition("(~ (a B))")->kind == ExprKind::Not);
  CHECK(Condition("(~ (a B))")->head.text == "~");
}

TEST_CASE("implication and equivalence stand in all conditions") {
  CHECK(Condition("(=> (a B) (c D))")->kind == ExprKind::Implies);
  CHECK(Condition("(<=> (a B) (c D))")->kind == ExprKind::Equivalent);
  CHECK(Condition("(=> (a B) (c D))").codes() == "");
  CHECK(Condition("(=> (a B))").codes() == "PS0118");
  CHECK(Condition("(<=> (a B) (c D) true)").codes() == "PS0118");
}

TEST_CASE("comparisons and sums") {
  CHECK(Condition("(= a b)")->kind == ExprKind::Equal);
  CHECK(Condition("(/= a b)")->kind == ExprKind::NotEqual);
  CHECK(Condition("(< a 2)")->kind == ExprKind::Less);
  CHECK(Condition("(<= a 2)")->kind == ExprKind::LessEqual);
  CHECK(Condition("(> a 2)")->kind == ExprKind::Greater);
  CHECK(Condition("(>= a 2)")->kind == ExprKind::GreaterEqual);
  Condition sum("(= a (- (+ b 1 2) 3))");
  CHECK(sum->operands.at(1).kind == ExprKind::Subtract);
  CHECK(sum->operands.at(1).operands.at(0).operands.size() == 3);
}

TEST_CASE("both halves of an access are known") {
  Condition status("(= takeoff.status success)");
  const auto& access = status->operands.at(0);
  CHECK(access.kind == ExprKind::Access);
  CHECK(access.name.text == "takeoff");
  CHECK(access.member.text == "status");
  CHECK(access.member.range.begin == access.name.range.end + 1);
}

TEST_CASE("an access that is being typed has its place for the other half") {
  Condition half("(= takeoff. success)");
  CHECK(half.codes() == "PS0111");
  const auto& access = half->operands.at(0);
  CHECK_FALSE(access.member);
  CHECK(access.member.range.begin == access.range.end);
}

TEST_CASE("operators have the operands that they need, missing ones included") {
  Condition comparison("(= a)");
  CHECK(comparison.codes() == "PS0118");
  REQUIRE(comparison->operands.size() == 2);
  CHECK(comparison->operands[1].kind == ExprKind::Missing);
  CHECK(Condition("(battery)")->operands.size() == 1);
  CHECK(Condition("(not)")->operands.size() == 1);
  CHECK(Condition("(= a b c)")->operands.size() == 2);
}

TEST_CASE("formulas of linear temporal logic") {
  Formula always("([] (=> (battery Low) (<> (running landing))))");
  CHECK(always.codes() == "");
  CHECK(always->kind == ExprKind::Globally);
  CHECK(always->operands.at(0).kind == ExprKind::Implies);
  CHECK(always->operands.at(0).operands.at(1).kind == ExprKind::Finally);
  CHECK(Formula("(() (battery Low))")->kind == ExprKind::Next);
  CHECK(Formula("(until (battery Good) (battery Low))")->kind == ExprKind::Until);
  CHECK(Formula("(() (battery Low))").codes() == "");
}

TEST_CASE("operators of linear temporal logic are also letters, but not before a value") {
  Formula always("(G (=> (battery Low) (F (running landing))))");
  CHECK(always.codes() == "");
  CHECK(always->kind == ExprKind::Globally);
  CHECK(always->operands.at(0).operands.at(1).kind == ExprKind::Finally);
  CHECK(Formula("(X (battery Low))")->kind == ExprKind::Next);
  CHECK(Formula("(U true (battery Low))")->kind == ExprKind::Until);
  CHECK(Formula("(W (battery Good) (battery Low))")->kind == ExprKind::WeakUntil);
  CHECK(Formula("(R (battery Good) (battery Low))")->kind == ExprKind::Release);
  CHECK(Formula("(M (battery Good) (battery Low))")->kind == ExprKind::StrongRelease);
  CHECK(Formula("(W (battery Good))").codes() == "PS0118");
  CHECK(Formula("(F Low)")->kind == ExprKind::Test);
  CHECK(Formula("(F 3)")->name.text == "F");
}

TEST_CASE("propositions about skills, events and labels") {
  CHECK(Formula("(running takeoff)")->name.text == "takeoff");
  CHECK(Formula("(called takeoff)")->kind == ExprKind::Called);
  CHECK(Formula("(ended takeoff)")->kind == ExprKind::Ended);
  CHECK(Formula("(ended takeoff success)")->member.text == "success");
  CHECK(Formula("(occurs gust)")->kind == ExprKind::Occurs);
  CHECK(Formula("(at again)")->kind == ExprKind::At);
  CHECK(Formula("(value battery Low)")->operands.at(0).name.text == "Low");
}

TEST_CASE("malformed conditions are one diagnostic each") {
  for (std::string text : {"(== a b)", "(!= a b)", "(&& (a B) (c D))", "(3 4)", "(\"a\")", "(:a)",
                           "(and (a B) [1,2])"}) {
    INFO(text);
    CHECK(Condition(text).codes() == "PS0117");
  }
  CHECK(Condition("()").codes() == "PS0110");
  CHECK(Condition("(and)").codes() == "PS0118");
  CHECK(Condition("(+ 1)").codes() == "PS0118");
  CHECK(Condition("(battery Low Good)").codes() == "PS0118");
  CHECK(Formula("([] )").codes() == "PS0118");
  CHECK(Formula("(running)").codes() == "PS0111");
  CHECK(Formula("(running a b)").codes() == "PS0112");
}
