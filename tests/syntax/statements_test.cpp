#include "tests/syntax/programs.h"

#include "syntax/tree/statements.h"

#include <catch2/catch.hpp>

using namespace proskill;
using syntax::Statement;
using syntax::StatementKind;

namespace {

/// A skill whose body is this statement, or several.
struct Body {
  syntax::Document document;

  explicit Body(const std::string& statements)
      : document(syntax::Document::parse("(defskill s :body (" + statements + "))")) {}
  [[nodiscard]] const syntax::List<Statement>& statements() const {
    return std::get<syntax::Skill>(document.forms().at(0).node()).body->statements;
  }
  const Statement* operator->() const { return &statements().at(0); }
  [[nodiscard]] std::string codes() const { return test::codesOf(document); }
};

} // namespace

TEST_CASE("a call with arguments") {
  Body call("(goto_waypoint x -3 y $y mode \"fast\" room kitchen up (+ level 1) on true)");
  CHECK(call.codes() == "");
  CHECK(call->kind == StatementKind::Call);
  CHECK(call->name.text == "goto_waypoint");
  REQUIRE(call->arguments.size() == 6);
  CHECK(call->arguments[1].value.kind == syntax::ExprKind::Parameter);
  CHECK(call->arguments[3].value.name.text == "kitchen");
  CHECK(call->arguments[4].value.kind == syntax::ExprKind::Add);
}

TEST_CASE("an interrupt") {
  Body interrupt("(camera_survey.interrupt)");
  CHECK(interrupt->kind == StatementKind::Interrupt);
  CHECK(interrupt->name.text == "camera_survey");
  CHECK(interrupt->head.text == "interrupt");
}

TEST_CASE("waits") {
  CHECK(Body("(^ (battery Low))")->condition.name.text == "battery");
  CHECK(Body("(^ 2)")->kind == StatementKind::WaitTime);
  CHECK(Body("(^ 2)")->duration.upper == syntax::Rational{2});
  CHECK(Body("(^ [1,3])")->duration.lower == syntax::Rational{1});
  Body testAndSet("(^ (zone Free) :effects (zone Taken))");
  CHECK(testAndSet.codes() == "");
  CHECK(testAndSet->kind == StatementKind::WaitCondition);
  CHECK(testAndSet->effects.items.at(0).value.name.text == "Taken");
  CHECK(Body("(^ true)")->condition.kind == syntax::ExprKind::True);
}

TEST_CASE("a wait with a timeout") {
  Body plain("(^ (door Open) :timeout 5)");
  CHECK(plain.codes() == "");
  CHECK(syntax::hasTimeout(*plain.operator->()));
  CHECK(plain->duration.upper == syntax::Rational{5});
  CHECK(plain->branches.at(0).statements.empty());
  Body full("(^ (door Open) :timeout [1,3] (x) (y) :effects (door Closed))");
  CHECK(full.codes() == "");
  CHECK(full->duration.lower == syntax::Rational{1});
  CHECK(full->branches.at(0).statements.size() == 2);
  CHECK(full->effects.items.size() == 1);
  CHECK_FALSE(syntax::hasTimeout(*Body("(^ (door Open))").operator->()));
  CHECK(Body("(^ (door Open) :timeout)").codes() == "PS0114");
  CHECK(Body("(^ (door Open) :timeout -1)").codes() == "PS0116");
  CHECK(Body("(^ (door Open) :timeout (x))").codes() == "PS0114");
  CHECK(Body("(^ 3 :timeout 5)").codes() == "PS0112");
}

TEST_CASE("an if with all its arms") {
  Body branching("(if (a B) (x) elseif (c D) (y) (z) elseif (e F) else (w))");
  CHECK(branching.codes() == "");
  REQUIRE(branching->arms.size() == 4);
  CHECK(branching->arms[1].condition->name.text == "c");
  CHECK(branching->arms[1].body.statements.size() == 2);
  CHECK(branching->arms[2].body.statements.empty());
  CHECK_FALSE(branching->arms[3].condition);
}

TEST_CASE("loops") {
  Body loop("(while (a B) (x) break (y) (break))");
  CHECK(loop.codes() == "");
  REQUIRE(loop->branches.size() == 1);
  CHECK(loop->branches[0].statements.at(1).kind == StatementKind::Break);
  CHECK(loop->branches[0].statements.at(3).kind == StatementKind::Break);

  Body until("(do (x) (y) until (a B))");
  CHECK(until.codes() == "");
  CHECK(until->kind == StatementKind::DoUntil);
  CHECK(until->condition.name.text == "a");
  CHECK(until->branches.at(0).statements.size() == 2);

  Body doUntil("(do-until (a B) (x) (y))");
  CHECK(doUntil.codes() == "");
  CHECK(doUntil->kind == StatementKind::DoUntil);
  CHECK(doUntil->condition.name.text == "a");
  CHECK(doUntil->branches.at(0).statements.size() == 2);
}

TEST_CASE("a case with its call and arms") {
  Body cases("(case (drive x 1) ((success near far) (y)) (failure) (refused (z) (w)) (else))");
  CHECK(cases.codes() == "");
  CHECK(cases->kind == StatementKind::Case);
  const Statement* call = syntax::callOf(*cases.operator->());
  REQUIRE(call);
  CHECK(call->head.text == "drive");
  CHECK(call->arguments.size() == 1);
  REQUIRE(cases->arms.size() == 4);
  const auto& near = cases->arms[0].pattern;
  CHECK(near.status.text == "success");
  REQUIRE(near.tags.size() == 2);
  CHECK(near.tags[1].text == "far");
  CHECK(cases->arms[1].pattern.tags.empty());
  CHECK(cases->arms[2].body.statements.size() == 2);
  CHECK(cases->arms[2].condition->operands.at(1).name.text == "no_status");
  CHECK_FALSE(cases->arms[3].condition);
}

TEST_CASE("a case is a call with arms") {
  auto codes = [](const std::string& statement) { return Body(statement).codes(); };
  CHECK(codes("(case)") == "PS0121");
  CHECK(codes("(case drive (success))") == "PS0121");
  CHECK(codes("(case (x) done)") == "PS0121");
  CHECK(codes("(case (x) ())") == "PS0121");
  CHECK(codes("(case (x) (3 (y)))") == "PS0121");
  CHECK(codes("(case (x) ((interrupted gently)))") == "PS0121");
}

TEST_CASE("branches in parallel, nested") {
  Body parallel("(// ((x)) ((y) (// ((z)) ())))");
  CHECK(parallel.codes() == "");
  REQUIRE(parallel->branches.size() == 2);
  CHECK(parallel->branches[1].statements.at(1).branches.size() == 2);
}

TEST_CASE("a race has branches") {
  Body race("(race ((x) (break)) () ((race ((y)) ((^ 1)))))");
  CHECK(race.codes() == "");
  CHECK(race->kind == StatementKind::Race);
  REQUIRE(race->branches.size() == 3);
  CHECK(race->branches[2].statements.at(0).branches.size() == 2);
  CHECK(Body("(race)").codes() == "PS0122");
  CHECK(Body("(race (x) ((^ 1)))").codes() == "PS0122");
}

TEST_CASE("the other statements") {
  Body body("(label again) (goto again) (set (a B)) (set ((a B) (c 3))) (printf \"%d%%\" level)\n"
            "(success done) (failure cold) (emit gust)");
  CHECK(body.codes() == "");
  std::vector<StatementKind> kinds;
  for (const auto& statement : body.statements()) kinds.push_back(statement.kind);
  CHECK(kinds == std::vector{StatementKind::Label, StatementKind::Goto, StatementKind::Set,
                             StatementKind::Set, StatementKind::Printf, StatementKind::Success,
                             StatementKind::Failure, StatementKind::Emit});
  CHECK(body.statements()[0].name.text == "again");
  CHECK(body.statements()[3].effects.items.size() == 2);
  CHECK(body.statements()[4].format.text == "%d%%");
  CHECK(body.statements()[4].arguments.at(0).value.name.text == "level");
}

TEST_CASE("words of the language are names wherever they mean nothing else") {
  Body call("(takeoff if 1 while do status else)");
  CHECK(call.codes() == "");
  REQUIRE(call->arguments.size() == 3);
  CHECK(call->arguments[0].name.text == "if");
  CHECK(call->arguments[2].value.name.text == "else");
  CHECK(Body("(^ (at Home))")->condition.kind == syntax::ExprKind::Test);
  CHECK(Body("(^ (running Yes))")->condition.kind == syntax::ExprKind::Test);
}

TEST_CASE("malformed statements are one diagnostic each") {
  auto codes = [](const std::string& statement) { return Body(statement).codes(); };
  CHECK(codes("(x) landing") == "PS0121");
  CHECK(codes("(x) 3") == "PS0121");
  CHECK(codes("()") == "PS0110");
  CHECK(codes("( ; nothing yet\n)") == "PS0110");
  CHECK(codes("((x) (y))") == "PS0121");
  CHECK(codes("(if)") == "PS0119");
  CHECK(codes("(if (a B) (x) (else (y)))") == "PS0121");
  CHECK(codes("(if (a B) (x) else (y) else (z))") == "PS0121");
  CHECK(codes("(while (a B) (x) else (y))") == "PS0121");
  CHECK(codes("(do (x))") == "PS0121");
  CHECK(codes("(do (x) until)") == "PS0119");
  CHECK(codes("(do (x) until (a B) (y))") == "PS0112");
  CHECK(codes("(^)") == "PS0119");
  CHECK(codes("(^ (a B) (c D))") == "PS0112");
  CHECK(codes("(^ 2 :effects (a B))") == "PS0112");
  CHECK(codes("(^ -1)") == "PS0116");
  CHECK(codes("(goto)") == "PS0111");
  CHECK(codes("(goto again now)") == "PS0112");
  CHECK(codes("(set)") == "PS0114");
  CHECK(codes("(set a B)") == "PS0120");
  CHECK(codes("(set (a B) (c D))") == "PS0120");
  CHECK(codes("(printf)") == "PS0121");
  CHECK(codes("(printf level)") == "PS0121");
  CHECK(codes("(takeoff 3.0)") == "PS0123");
  CHECK(codes("(takeoff height)") == "PS0123");
  CHECK(codes("(takeoff.)") == "PS0121");
  CHECK(codes("(takeoff.status)") == "PS0121");
  CHECK(codes("(//)") == "PS0122");
  CHECK(codes("(// (x) ((y)))") == "PS0122");
  CHECK(codes("(// x ((y)))") == "PS0122");
}
