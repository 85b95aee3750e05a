#include "tests/fiacre/printed.h"

#include <catch2/catch.hpp>

using namespace proskill::fiacre;
using namespace proskill::fiacre::test;

TEST_CASE("alternatives print as if, elsif and else") {
  const auto nested = ifElse(name("b"), to("t"), sequence({ifElse(name("c"), to("u"), to("s"))}));
  CHECK(printed({ifElse(binary(Op::Equal, name("a"), number(1)), with("stay", to("s")), nested)}) ==
        R"(
    if (a = 1) then
        to s // stay
    elsif b then
        to t
    elsif c then
        to u
    else
        to s
    end
)");
}

TEST_CASE("text goes on behind an if whose branch has left") {
  CHECK(printed({ifThen(name("a"), to("t")), to("s")}) == R"(
    if a then
        to t
    end;
    to s
)");
}

TEST_CASE("a branch of comments alone is null") {
  CHECK(printed({ifThen(name("a"), sequence({comment("nothing to do")})), to("s")}) == R"(
    if a then
        // nothing to do
        null
    end;
    to s
)");
  CHECK(printed({}) == "\n    null\n");
}

TEST_CASE("a comment behind the last statement brings no semicolon") {
  CHECK(printed({tag("done"), to("s"), comment("the end")}) == R"(
    #done;
    to s
    // the end
)");
}

TEST_CASE("a case has a branch for each pattern") {
  Statement choice{.kind = StatementKind::Case,
                   .values = {name("x"), name("A"), call("B", {name("n")}), name("any")},
                   .children = {to("s"), to("t"), to("u")}};
  CHECK(printed({choice}) == R"(
    case x of
      A ->
        to s
    | B(n) ->
        to t
    | any ->
        to u
    end
)");
}

TEST_CASE("unless separates groups of priority") {
  auto choice = select({to("s"), to("t"), to("u")});
  choice.priorityGroups = {2};
  CHECK(printed({choice}) == R"(
    select
        to s
    []
        to t
    unless
        to u
    end
)");
}

TEST_CASE("values go through ports and into variables") {
  CHECK(printed({{.kind = StatementKind::Send,
                  .name = "p",
                  .values = {binary(Op::Add, name("x"), number(1)), name("y")}},
                 {.kind = StatementKind::Receive,
                  .name = "q",
                  .targets = {name("x"), name("y")},
                  .values = {binary(Op::Less, name("x"), name("y"))}},
                 {.kind = StatementKind::Any, .targets = {name("x")}},
                 {.kind = StatementKind::Any,
                  .targets = {name("x")},
                  .values = {binary(Op::Greater, name("x"), number(2))}},
                 {.kind = StatementKind::Assign,
                  .targets = {name("x"), name("y")},
                  .values = {name("y"), name("x")}},
                 {.kind = StatementKind::Loop}}) == R"(
    p ! (x + 1), y;
    q ? x, y where (x < y);
    x := any;
    x := any where (x > 2);
    x, y := y, x;
    loop
)");
}

TEST_CASE("loops print with their ends") {
  CHECK(printed({{.kind = StatementKind::While,
                  .values = {binary(Op::Less, name("x"), number(3))},
                  .children = {assign(name("x"), binary(Op::Add, name("x"), number(1)))}},
                 {.kind = StatementKind::Foreach, .name = "v", .children = {null()}},
                 to("s")}) == R"(
    while (x < 3) do
        x := x + 1
    end;
    foreach v do
        null
    end;
    to s
)");
}
