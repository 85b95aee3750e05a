#include "fiacre/check/check.h"
#include "fiacre/syntax/parse.h"
#include "tests/support/text_model.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>

namespace proskill::test::fiacre_text_test {

using test::Text;

namespace {

/// A single process.
Text process(const std::string& body) { return test::processText(body); }

} // namespace

TEST_CASE("`any` takes each value that `where` lets through") {
  const auto model = process("states a, b var x: 0..3, y: bool "
                             "from a x, y := any where x > 1 and y; to b");
  CHECK(model.reaches("main/1/value x = 2"));
  CHECK(model.reaches("main/1/value x = 3"));
  CHECK_FALSE(model.reaches("main/1/value x = 1"));
  CHECK_FALSE(model.reaches("(main/1/state b) and not (main/1/value y)"));
}

TEST_CASE("queues are first in, first out; `append` puts in front") {
  const auto model = process("states a, b var q: short := {||}, x, y: 0..3 "
                             "from a q := enqueue(enqueue(q, 1), 2); q := append(dequeue q, 3); "
                             "x := first q; q := dequeue q; y := first q; to b");
  CHECK(model.reaches("(main/1/state b) and (main/1/value (x = 3 and y = 2))"));
  CHECK(model.reaches("main/1/value q = {|2|}"));
  CHECK_FALSE(model.reaches("main/1/value full q"));
}

TEST_CASE("loops in functions and in processes") {
  const Text model("type four is 0..3\n"
                   "function sum (n: four) : nat is var s: nat := 0, i: four "
                   "begin foreach i do if i <= n then s := s + i end end; return s end\n"
                   "function halves (n: nat) : nat is var c: nat := 0, m: nat "
                   "begin m := n; while m > 1 do c := c + 1; m := m / 2 end; return c end\n"
                   "process P is states a, b var x, y: nat := 0, i: four, c: nat := 0 "
                   "from a x := sum(3); y := halves(9); foreach i do c := c + i end; to b\n"
                   "component main is par * in P end");
  CHECK(model.reaches("main/1/value (x = 6 and y = 3 and c = 6)"));
}

TEST_CASE("a value crosses a port as it is when it is sent, and `where` chooses") {
  const Text model("process S [p: out 0..5] is states a, b var x: 0..5 := 1 "
                   "from a x := x + 1; p ! x + 1; x := 0; to b\n"
                   "process R [p: in 0..5] is states a, b, c var y: 0..5 "
                   "from a select p ? y where y = 3; to b [] p ? y where y <> 3; to c end\n"
                   "component main is port p: 0..5 in [1,1] par * in S[p] || R[p] end");
  CHECK(model.reaches("(main/2/state b) and (main/2/value y = 3)"));
  CHECK_FALSE(model.reaches("main/2/state c"));
  CHECK(model.reaches("main/event p"));
  CHECK(model.reaches("main/1/value x = 0"));
}

TEST_CASE("what is sent may depend on choices before it on the path") {
  const auto model = [](const std::string& choice) {
    return Text("type u is union one of 0..3 | two end\n"
                "process S [p: out 0..9] is states a, b var x: 0..9, y: u := one(2) from a " +
                choice +
                "; p ! x; to b\n"
                "process R [p: in 0..9] is states a, b var x: 0..9 from a p ? x; to b\n"
                "component main is port p: 0..9 in [1,1] par * in S[p] || R[p] end");
  };
  const auto chosen = model("case y of one(0) -> x := 4 | one(2) -> x := 7 | any -> x := 8 end");
  CHECK(chosen.reaches("main/2/value x = 7"));
  CHECK_FALSE(chosen.reaches("main/2/value (x = 4 or x = 8)"));
  const auto tested =
      model("x := any where x < 3; if x > 1 then x := 6 elsif x = 1 then x := 5 end");
  for (const auto* value : {"0", "5", "6"})
    CHECK(tested.reaches(std::string("main/2/value x = ") + value + " and main/2/state b"));
  CHECK_FALSE(tested.reaches("main/2/value (x = 1 or x = 2)"));
}

TEST_CASE("two who send on one port must agree; what nobody sends nobody gets") {
  const auto model = [](const std::string& first, const std::string& second) {
    return Text("process S [p: out 0..5] is states a, b var x: 0..5 from a p ! " + first +
                "; to b\nprocess T [p: out 0..5] is states a, b from a p ! " + second +
                "; to b\nprocess R [p: in 0..5] is states a, b var y: 0..5 from a p ? y; to b\n"
                "component main is port p: 0..5 par * in S[p] || T[p] || R[p] end");
  };
  CHECK(model("2", "2").reaches("main/3/value y = 2"));
  CHECK_FALSE(model("2", "3").reaches("main/event p"));
  const Text silent("process R [p: in 0..5] is states a, b var y: 0..5 from a p ? y; to b\n"
                    "component main is port p: 0..5 par * in R[p] end");
  CHECK_FALSE(silent.reaches("main/1/state b"));
}

TEST_CASE("what is received reads the state before the step") {
  const Text model("process S [p: out 0..5] (&x: 0..5) is states a, b from a p ! x; to b\n"
                   "process R [p: in 0..5] (&x: 0..5) is states a, b var y: 0..5 "
                   "from a p ? y; x := 5; to b\n"
                   "component main is var x: 0..5 := 1 port p: 0..5 "
                   "par * in R[p](&x) || S[p](&x) end");
  CHECK(model.reaches("(main/value x = 5) and (main/1/value y = 1)"));
  CHECK_FALSE(model.reaches("main/1/value y = 5"));
}

TEST_CASE("who does not wait on a port passes it alone") {
  const auto both = [](const std::string& composition) {
    return Text("process P [p: sync] is states a, b from a p; to b\n"
                "process Q [p: sync] is states a, b, c from a wait [0,0]; to b from b p; to c\n"
                "component main is port p: sync in [0,0] " +
                composition);
  };
  const std::string alone = "(main/1/state b) and (main/2/state a)";
  CHECK(both("par P[p] || Q[p] end").reaches(alone));
  CHECK(both("par * -> P[p] || Q[p] end").reaches(alone));
  CHECK_FALSE(both("par p -> P[p] || p -> Q[p] end").reaches(alone));
}

TEST_CASE("components within components have ports and variables of their own") {
  const Text model("process P [p: sync] (&x: 0..9, by: 0..9) is states a, b "
                   "from a p; x := x + by; to b\n"
                   "process Q [p: sync] is states a, b from a p; to b\n"
                   "component pair (&total: 0..9, by: 0..9) is var own: 0..9 := by port p: sync "
                   "par * in P[p](&total, own) || Q[p] end\n"
                   "component main is var total: 0..9 := 0 "
                   "par * in pair(&total, 2) || pair(&total, 3) end");
  CHECK(model.reaches("main/value total = 5"));
  CHECK(model.reaches("(main/1/1/state b) and (main/2/1/state a)"));
  CHECK_FALSE(model.reaches("(main/1/1/state b) and (main/1/2/state a)"));
  CHECK(model.reaches("main/2/value own = 3"));
  CHECK_FALSE(model.reaches("main/1/value own = 3"));
  CHECK(model.reaches("main/2/event p"));
}

TEST_CASE("a port with priority goes first where it can") {
  const auto model = [](const std::string& higher) {
    return Text("process P [h: sync, l: sync] (go: bool) is states a, b, c "
                "from a select h; to b [] l; to c end\n"
                "process G [h: sync] (go: bool) is states a from a on go; h; to a\n"
                "component main is port h: sync in [0,0], l: sync in [0,...[ priority h > l "
                "par * in P[h, l](true) || G[h](" +
                higher + ") end");
  };
  CHECK(model("true").reaches("main/1/state b"));
  CHECK_FALSE(model("true").reaches("main/1/state c"));
  CHECK(model("false").reaches("main/1/state c"));
}

TEST_CASE("the parts behind `unless` go first") {
  const auto model = process("states a, b, c var x: 0..1 := 0 from a "
                             "select wait [0,0]; to b unless wait [0,0]; on x = 0; to c end");
  CHECK(model.reaches("main/1/state c"));
  CHECK_FALSE(model.reaches("main/1/state b"));
  const auto guarded = process("states a, b, c var x: 0..1 := 1 from a "
                               "select wait [0,0]; to b unless wait [0,0]; on x = 0; to c end");
  CHECK(guarded.reaches("main/1/state b"));
}

TEST_CASE("what has priority and has to wait goes first from its time on") {
  const auto model = [](const std::string& low, const std::string& high) {
    return process("states a, b, c from a select wait " + low + "; to b unless wait " + high +
                   "; to c end");
  };
  CHECK(model("[1,2]", "[1,2]").reaches("main/1/state c"));
  CHECK_FALSE(model("[1,2]", "[1,2]").reaches("main/1/state b"));
  CHECK(model("[0,2]", "[1,2]").reaches("main/1/state b")); // before the other is ready
  CHECK_FALSE(model("[1,2]", "]0,3]").reaches("main/1/state b"));
  CHECK(model("[1,2]", "]1,3]").reaches("main/1/state b")); // at 1 itself
  const auto late = model("[0,...[", "[2,3]");
  CHECK(late.isTrue("absent enter (main/1/state b) within [2,...["));
  CHECK(late.isFalse("absent enter (main/1/state b) within ]1,2["));
}

TEST_CASE("a process alone is a model") {
  auto parsed = fiacre::parse("process main is states a, b from a wait [1,1]; to b\nmain\n"
                              "property p is absent main/state b assert p");
  REQUIRE(parsed.problems.empty());
  REQUIRE(fiacre::check(parsed.program).empty());
  const auto result = verify::verify(parsed.program, parsed.provenance, {{0}});
  REQUIRE(result.has_value());
  CHECK(result->answers[0].truth == verify::Truth::False);
}

TEST_CASE("a path is atomic, `on` sees what it has assigned, and `loop` keeps the clocks") {
  const auto atomic = process("states a, b var x: 0..3 := 0 from a x := 1; on x = 1; x := 2; to b");
  CHECK(atomic.reaches("main/1/value x = 2"));
  CHECK_FALSE(atomic.reaches("main/1/value x = 1"));
  const auto clocks = [](const std::string& again) {
    return process("states a, b var n: 0..1 := 0 from a "
                   "select wait [1,1]; on n = 0; n := 1; " +
                   again + " [] wait [2,2]; to b end");
  };
  CHECK(clocks("loop").isTrue("present main/1/state b within [2,2]"));
  CHECK(clocks("to a").isTrue("present main/1/state b within [3,3]"));
}

TEST_CASE("what is urgent happens before time passes; what is not may be put off for ever") {
  const auto model = [](const std::string& when) {
    return process("states a, b from a wait " + when + "; to b");
  };
  CHECK(model("[0,0]").isTrue("absent main/1/state a within ]0,...["));
  CHECK(model("[0,...[").isFalse("absent main/1/state a within ]0,...["));
}

TEST_CASE("a port's interval counts from when all who share it are ready") {
  const Text model("process P [p: sync] is states a, b from a p; to b\n"
                   "process Q [p: sync] is states a, b, c from a wait [2,3]; to b from b p; to c\n"
                   "component main is port p: sync in [1,4] par * in P[p] || Q[p] end");
  CHECK(model.isTrue("present main/event p within [3,7]"));
  CHECK(model.isFalse("present main/event p within [3,7["));
  CHECK(model.isFalse("present main/event p within ]3,7]"));
  CHECK(model.isTrue("(enter (main/2/state b)) leadsto (main/event p) within [1,4]"));
}

TEST_CASE("a `while` runs within its step; what it reads it has written") {
  const auto model = process("states a, b var x: nat := 9, n: nat := 0 "
                             "from a while x > 1 do x := x / 2; n := n + 1 end; to b");
  CHECK(model.reaches("(main/1/state b) and (main/1/value (x = 1 and n = 3))"));
  CHECK_FALSE(model.reaches("main/1/value n = 2"));
}

TEST_CASE("the constructors of a union carry values, and `case` gives them to variables") {
  const Text model(
      "type frame is union nothing | data of 0..3 | pair of record l: 0..3, r: bool end end\n"
      "process S [p: out frame] is states a, b, c var f: frame := nothing "
      "from a f := data(2); p ! f; to b from b p ! pair({l = 3, r = true}); to c\n"
      "process R [p: in frame] is states a, b, c var f: frame := nothing, x: 0..3 := 0, "
      "y: record l: 0..3, r: bool end := {l = 0, r = false} "
      "from a p ? f; to b "
      "from b case f of nothing -> to c | data(x) -> to a | pair(y) -> to c end\n"
      "component main is port p: frame par * in S[p] || R[p] end");
  CHECK(model.reaches("main/2/value x = 2"));
  CHECK_FALSE(model.reaches("main/2/value x = 3"));
  CHECK(model.reaches("(main/2/state c) and (main/2/value (y.l = 3 and y.r))"));
  CHECK(model.reaches("main/2/value f = data(2)"));
  CHECK_FALSE(model.reaches("main/2/value f = data(3)"));
}

TEST_CASE("a pattern may ask for one value of a constructor, and stand in a function") {
  const Text model(
      "type frame is union nothing | data of 0..3 end\n"
      "function size (f: frame) : nat is var n: 0..3 := 0 begin "
      "case f of data(0) -> return 9 | data(n) -> return n | nothing -> return 7 end end\n"
      "process P is states a, b var f: frame := nothing, x, y, z: nat := 0 "
      "from a x := size(f); y := size(data(0)); z := size(data(3)); to b\n"
      "component main is par * in P end");
  CHECK(model.reaches("main/1/value (x = 7 and y = 9 and z = 3)"));
}

TEST_CASE("a pattern on the left of `:=` lets through what matches it") {
  const Text model("type opt is union nothing | some of 0..3 end\n"
                   "process P (b: bool, o: opt) is states a, yes, no, value var x: 0..3 "
                   "from a select true := b; to yes [] false := b; to no "
                   "[] some(x) := o; to value end\n"
                   "component main is par * in P(true, some(2)) || P(false, nothing) end");
  CHECK(model.reaches("main/1/state yes"));
  CHECK_FALSE(model.reaches("main/1/state no"));
  CHECK(model.reaches("(main/1/state value) and (main/1/value x = 2)"));
  CHECK(model.reaches("main/2/state no"));
  CHECK_FALSE(model.reaches("main/2/state value"));
}

TEST_CASE("`any` within a pattern matches every value, and behind `?` it drops what is received") {
  const Text model("type opt is union nothing | some of 0..3 end\n"
                   "process S [p: out 0..3 # 0..3] is states a, b from a p ! 1, 2; to b\n"
                   "process R [p: in 0..3 # 0..3] (o: opt) is states a, b, c var x: 0..3 "
                   "from a p ? any, x; to b "
                   "from b case o of some(any) -> to c | any -> to a end\n"
                   "component main is port p: 0..3 # 0..3 par * in S[p] || R[p](some(3)) end");
  CHECK(model.reaches("(main/2/state c) and (main/2/value x = 2)"));
}

TEST_CASE("several assignments at once exchange the cells of an array, whatever the indices are") {
  const auto model = process("states a, b var x: array 3 of 0..3 := [1, 2, 3], i, j: 0..2 "
                             "from a i, j := any; x[i], x[j] := x[j], x[i]; to b");
  CHECK_FALSE(model.reaches("main/1/value (x[0] + x[1] + x[2] <> 6)"));
  CHECK(model.reaches("main/1/value (x[0] = 3 and x[2] = 1)"));
  CHECK(model.reaches("main/1/value (x[1] = 3 and x[2] = 2)"));
  const auto both = process("states a, b var x: array 2 of 0..3, i: 0..1 := 1 "
                            "from a x[0], x[i] := 2, 3; to b");
  CHECK(both.reaches("main/1/value (x[0] = 2 and x[1] = 3)"));
  const auto first = process("states a var x: array 2 of 0..3 := [1, 2], i: 0..1 := 1 "
                             "init x[i], x[0] := x[0], x[i]; to a from a wait [1,1]; to a");
  CHECK(first.isTrue("always main/1/value (x[0] = 2 and x[1] = 1)"));
}

TEST_CASE("`init` computes with loops and tests, in processes and in components") {
  const Text model("type three is 0..2\n"
                   "process P (&a: array 3 of 0..9) is states start, other var x: 0..9, i: three "
                   "init foreach i do a[i] := i + 1 end foreach; "
                   "while x < 5 do x := x + 2 end while; "
                   "case a[2] of 3 -> to other | any -> to start end "
                   "from start to start from other wait [1,1]; to other\n"
                   "component main is var a: array 3 of 0..9 := [7, 7, 7], i: three, b: 0..9 "
                   "init foreach i do a[i] := 4 end foreach; "
                   "if a[0] = 4 then b := 8 else b := 1 end if "
                   "par * in P (&a) end par");
  CHECK(model.isTrue("always main/1/state other"));
  CHECK(model.isTrue("always main/1/value (a[0] = 1 and a[1] = 2 and a[2] = 3 and x = 6)"));
  CHECK(model.isTrue("always main/value (b = 8)"));
}

TEST_CASE("a loop in `init` that does not end is refused") {
  const auto model =
      process("states a var x: 0..3 init while true do x := 1 end; to a from a to a");
  CHECK(model.refusal().find("does not end") != std::string::npos);
}

TEST_CASE("what two senders agree on is known, though nothing else looks at it") {
  const Text model("process S [p: out 0..3] is states a, b var x: 0..3 := 0 from a p ! x; to b\n"
                   "process T [p: out 0..3] is states a, b var x: 0..3 := 2 "
                   "from a select p ! x; to b [] on x > 0; wait [1,1]; x := x - 1; to a end\n"
                   "component main is port p: 0..3 par * in S[p] || T[p] end");
  CHECK(model.reaches("main/1/state b"));
  CHECK(model.isTrue("absent (main/1/state b) within [0,1]"));
}

TEST_CASE("priorities are passed on, in one chain and in several") {
  const auto reaches = [](const std::string& priorities) {
    return Text("process P [p, q, r: sync] is states a, b, c "
                "from a select p; to b [] r; to c end\n"
                "component main is port p, q, r: sync priority " +
                priorities + " par * in P[p, q, r] end")
        .reaches("main/1/state c");
  };
  CHECK_FALSE(reaches("p > q > r"));
  CHECK_FALSE(reaches("q > r, p > q"));
  CHECK(reaches("p > q"));
}

TEST_CASE("a formula that has no value in a state does not hold there") {
  const auto model = process("states a, b var x: 0..3 := 1, q: short := {||} "
                             "from a x := 0; to b");
  CHECK(model.isTrue("absent main/1/value (10 / x < 2)"));
  CHECK(model.isFalse("always main/1/value (10 / x > 2)"));
  CHECK(model.isTrue("absent main/1/value (first q = 0)"));
  CHECK(model.isFalse("absent main/1/value (not (x = 1))"));
}

} // namespace proskill::test::fiacre_text_test
