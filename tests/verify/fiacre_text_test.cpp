#include "fiacre/check.h"
#include "fiacre/parse.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

/// A model by its text, without properties; they are asked one by one.
class Text {
public:
  explicit Text(std::string of) : text(std::move(of)) {}

  /// The answer to `absent OBSERVABLE`, the same whatever is reduced. \pre it is decided
  [[nodiscard]] bool reaches(const std::string& observable) const {
    return isFalse("absent " + observable);
  }
  [[nodiscard]] bool isFalse(const std::string& pattern) const {
    const auto all = answer(pattern, {});
    verify::Options plain;
    plain.reductions.clear();
    CHECK(answer(pattern, plain) == all);
    return all;
  }
  /// Why the model cannot be explored to its end.
  [[nodiscard]] std::string failure() const {
    const auto parsed = read("deadlockfree");
    const auto result = verify::verify(parsed.program, parsed.provenance, {{0}});
    return result ? "" : result.error().message;
  }

private:
  [[nodiscard]] fiacre::Parsed read(const std::string& pattern) const {
    const auto whole = text + "\nmain\nproperty p is " + pattern + "\nassert p";
    auto parsed = fiacre::parse(whole);
    INFO(whole);
    for (const auto& problem : parsed.problems) FAIL(problem.message);
    for (const auto& problem : fiacre::check(parsed.program))
      FAIL(problem.place << ": " << problem.message);
    return parsed;
  }
  [[nodiscard]] bool answer(const std::string& pattern, const verify::Options& options) const {
    const auto parsed = read(pattern);
    const auto result = verify::verify(parsed.program, parsed.provenance, {{0}}, options);
    if (!result) FAIL(result.error().message);
    REQUIRE(result->answers[0].truth != verify::Truth::Unknown);
    const bool isFalse = result->answers[0].truth == verify::Truth::False;
    CHECK(result->answers[0].trace.has_value() == isFalse);
    return isFalse;
  }

  std::string text;
};

/// One process, alone.
Text process(const std::string& body) {
  return Text("type short is queue 2 of 0..3\nprocess P is\n" + body +
              "\ncomponent main is par * in P end");
}

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

TEST_CASE("an error of queues ends the exploration, and is told") {
  CHECK(process("states a var q: short := {|1, 2|} from a q := enqueue(q, 3); to a").failure() ==
        "`length of P_1.q` would get the value 3, outside of 0..2");
  CHECK(process("states a var q: short := {||} from a q := dequeue q; to a").failure() ==
        "`length of P_1.q` would get the value -1, outside of 0..2");
  CHECK(process("states a var q: short := {||}, x: 0..3 from a x := first q; to a").failure() ==
        "a division by zero");
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

TEST_CASE("a priority of what has to wait is refused, not guessed") {
  CHECK(process("states a, b, c from a select wait [1,2]; to b unless wait [1,2]; to c end")
            .failure() == "what has priority must have the interval [0,0] or [0,...[");
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
  CHECK(clocks("loop").reaches("main/1/state b"));
  CHECK(clocks("to a").reaches("main/1/state b"));
}
