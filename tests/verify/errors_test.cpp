#include "tests/support/text_model.h"

#include <catch2/catch.hpp>

using namespace proskill;
using test::processText;
using test::Text;

namespace {

/// The error of `from a STATEMENTS; to a`, with a queue of two, an array of three and numbers.
std::string errorOf(const std::string& statements) {
  return processText("states a, b var q: short := {||}, x: 0..3 := 0, y: int := 5, n: nat := 0, "
                     "a3: array 3 of 0..3 := [0, 0, 0] from a " +
                     statements + "; to a")
      .error();
}

} // namespace

TEST_CASE("a value that leaves its type is an error, at the statement that assigns it") {
  CHECK(errorOf("x := x + 1") == "x := x + 1: `P_1.x` would get the value 4, outside of 0..3");
  CHECK(
      errorOf("n := n + 1; n := n - 2").starts_with("n := n - 2: `P_1.n` would get the value -1"));
  CHECK(errorOf("x := (x + 1) % 4").empty());
}

TEST_CASE("a full queue and an empty one are errors, where an element is put in or taken out") {
  CHECK(errorOf("q := enqueue(q, 3)").ends_with("of a full queue"));
  CHECK(errorOf("q := append(q, 3)").ends_with("of a full queue"));
  CHECK(errorOf("q := dequeue q").ends_with("of an empty queue"));
  CHECK(errorOf("x := first q").ends_with("of an empty queue"));
  CHECK(errorOf("if not full q then q := enqueue(q, 3) end").empty());
}

TEST_CASE("an index beyond its array is an error, whether it is read or written") {
  CHECK(errorOf("x := a3[y]").ends_with("lies outside of 0..2"));
  CHECK(errorOf("a3[y] := 1").ends_with("lies outside of 0..2"));
  CHECK(errorOf("x := (x + 1) % 3; a3[x] := 1").empty());
  CHECK(errorOf("x := (x + 1) % 4; a3[x] := 1").ends_with("lies outside of 0..2"));
}

TEST_CASE("a division by zero is an error; `and` looks at its second side only where it has to") {
  CHECK(errorOf("y := 1 / x") == "y := 1 / x: a division by zero");
  CHECK(errorOf("y := 1 % x").ends_with("a division by zero"));
  CHECK(errorOf("if x <> 0 and 1 / x = 1 then y := 2 end").empty());
}

TEST_CASE("a number that is too large to calculate with is an error") {
  CHECK(errorOf("y := 30000; y := y * y * y * y * y").ends_with("a number beyond 2^62"));
}

TEST_CASE("an error of a guard is one as soon as the process is there") {
  CHECK(errorOf("on first q = 1; x := 1").ends_with("of an empty queue"));
  CHECK(errorOf("on not empty q; on first q = 1; x := 1").empty());
  CHECK(errorOf("x := 1; on 1 / (x - 1) = 1").ends_with("a division by zero"));
}

TEST_CASE("a function may come to no case, and give or take what its types do not have") {
  const auto model = [](const std::string& body, const std::string& statement) {
    return Text("type mood is union happy | sad end\nfunction f (x: 0..3, m: mood) : 0..3 is "
                "begin " +
                body + " end\nprocess P is states a var x: nat := 2 from a " + statement +
                "; to a\ncomponent main is par * in P end")
        .error();
  };
  CHECK(model("case m of sad -> return 1 end", "x := f(1, happy)").find("no pattern of a `case`") !=
        std::string::npos);
  CHECK(model("case m of sad -> return 1 end", "x := f(1, sad)").empty());
  CHECK(model("return x + 1", "x := f(x, sad)").find("the result of `f`") != std::string::npos);
  CHECK(model("return 0", "x := f(x + 5, sad)").find("`x` of `f`") != std::string::npos);
}

TEST_CASE("a loop that does not end is an error") {
  CHECK(errorOf("while x < 3 do y := 1 end").ends_with("a loop that does not end"));
}

TEST_CASE("an error has a trace with its dates; what is asked beside it is answered all the same") {
  const Text model("process P is states a, b var x: 0..2 := 0 "
                   "from a wait [2,3]; x := x + 1; to a\n"
                   "component main is par * in P end");
  CHECK(model.error() == "x := x + 1: `P_1.x` would get the value 3, outside of 0..2");
}

TEST_CASE("what is sent has to be of the port's type, whoever takes it") {
  const auto model = [](const std::string& receiver) {
    return Text("process S [p: out 0..3] is states a, b var x: nat := 5 from a p ! x; to b\n" +
                receiver);
  };
  const std::string why = "p ! x: what goes over the port gets a value outside of 0..3";
  CHECK(model("component main is port p: 0..3 par * in S[p] end").error() == why);
  CHECK(model("process R [p: in 0..3] is states a, b var y: nat from a p ? y; to b\n"
              "component main is port p: 0..3 par * in S[p] || R[p] end")
            .error() == why);
}
