#include "tests/support/text_model.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace proskill::test::slices_test {

namespace {

/// A process that takes one of three possible steps every `seconds`.
std::string walker(const std::string& name, const std::string& seconds) {
  return "process " + name + " is states a, b, c from a wait [" + seconds +
         "]; to b from b wait [" + seconds + "]; to c from c wait [" + seconds + "]; to a ";
}

/// Users of one place that each take, at different times, and give back; before and after they do
/// something else.
std::string users(std::size_t count, const std::string& giveBack) {
  std::string text;
  std::string all;
  for (std::size_t i = 0; i < count; ++i) {
    text += fmt::format("process U{} (&taken: bool) is states before, want, has, after "
                        "from before wait [{},9]; to want "
                        "from want wait [0,0]; on not taken; taken := true; to has "
                        "from has wait [1,{}]; {} to after from after wait [2,3]; to before ",
                        i, i + 1, i + 2, giveBack);
    all += fmt::format("{}U{}(&taken)", i == 0 ? "" : " || ", i);
  }
  return text + "component main is var taken: bool := false par * in " + all + " end";
}

/// A mission that calls one helper after the other, and waits for each. All use a tool, the mission
/// at last.
std::string calls(std::size_t count) {
  std::string text = fmt::format("type flags is array {} of 0..1 ", count);
  std::string all = "M(&busy, &tool)";
  std::string states;
  std::string steps;
  for (std::size_t i = 0; i < count; ++i) {
    text += fmt::format("process H{0} (&busy: flags, &tool: 0..1) is states idle, called, has "
                        "from idle on busy[{0}] = 1; to called "
                        "from called wait [1,2]; tool := 1; to has "
                        "from has wait [1,2]; tool := 0; busy[{0}] := 0; to idle ",
                        i);
    all += fmt::format(" || H{}(&busy, &tool)", i);
    states += fmt::format("s{0}, w{0}, ", i);
    steps += fmt::format("from s{0} busy[{0}] := 1; to w{0} from w{0} on busy[{0}] = 0; to s{1} ",
                         i, i + 1);
  }
  return fmt::format("{0}process M (&busy: flags, &tool: 0..1) is states {1}s{2}, done, broken "
                     "{3}from s{2} if tool = 0 then to done else to broken end "
                     "component main is var busy: flags := [{4}], tool: 0..1 := 0 "
                     "par * in {5} end",
                     text, states, count, steps, fmt::join(std::vector<int>(count, 0), ", "), all);
}

} // namespace

TEST_CASE("a slice leaves out what has nothing to do with the question") {
  const Text model(walker("P", "1,2") + walker("Q", "1,3") + walker("R", "2,3") +
                   "component main is par * in P || Q || R end");
  CHECK(model.reaches("main/1/state c"));
  CHECK(model.sliced("absent main/1/state c") == 1);
  const auto trace = model.trace("absent main/1/state c");
  CHECK(trace.steps.back().date == 2);
  CHECK(model.sliced("absent ((main/1/state c) and (main/2/state c))") == 1);
  CHECK(model.sliced("absent ((main/1/state c) and (main/2/state c) and (main/3/state c))") == 0);
}

TEST_CASE("a run of a slice does not count where the whole has no such run") {
  // the urgent loop stops time before P can move
  const Text model(walker("P", "1,2") + walker("Q", "1,3") +
                   "process Spinner is states a from a wait [0,0]; to a "
                   "component main is par * in P || Q || Spinner end");
  CHECK_FALSE(model.reaches("main/1/state b"));
  CHECK(model.sliced("absent main/1/state b") == 0);
}

TEST_CASE("what others have to do at once is done before the steps of a slice") {
  // P starts when no alarm is on; Q clears its alarm at once
  const Text model(
      "process P (&alarm: bool) is states idle, run, over from idle wait [0,0]; on not alarm; "
      "to run from run wait [2,2]; to over from over wait [1,1]; to idle "
      "process Q (&alarm: bool) is states calm, warned from calm wait [1,1]; alarm := true; "
      "to warned from warned wait [0,0]; on alarm; alarm := false; to calm " +
      walker("R", "1,3") +
      "component main is var alarm: bool := false par * in P(&alarm) || Q(&alarm) || R end");
  CHECK(model.reaches("main/1/state over"));
  CHECK(model.sliced("absent main/1/state over") == 1);
  CHECK(model.trace("absent main/1/state over").steps.back().date == 2);
}

TEST_CASE("a condition that stays false is not left out") {
  const Text model(
      "process P (&alarm: bool) is states idle, run, over from idle wait [0,0]; on not alarm; "
      "to run from run wait [2,2]; to over from over wait [1,1]; to idle "
      "process Q (&alarm: bool) is states calm, warned from calm wait [0,0]; alarm := true; "
      "to warned from warned wait [3,3]; alarm := false; to calm " +
      walker("R", "1,3") +
      "component main is var alarm: bool := true par * in P(&alarm) || Q(&alarm) || R end");
  CHECK(model.reaches("main/1/state over"));
  CHECK(model.trace("absent main/1/state over").steps.back().date == 5);
}

TEST_CASE("a process that ends early may do so late in a slice, and the whole says when") {
  // P waits for both; that Q is slow does not matter to what R observes of P
  const Text model("process P (&go: bool, &done: bool) is states start, wait_, end_, over "
                   "from start wait [0,0]; go := true; to wait_ "
                   "from wait_ wait [0,0]; on done; to end_ from end_ wait [0,0]; to over "
                   "process Q (&done: bool) is states a, b from a wait [5,5]; done := true; to b "
                   "process R (&go: bool) is states a, b from a wait [1,1]; on go; to b "
                   "component main is var go: bool := false, done: bool := false "
                   "par * in P(&go, &done) || Q(&done) || R(&go) end");
  CHECK(model.reaches("main/3/state b"));
  CHECK(model.sliced("absent main/3/state b") == 1);
  CHECK(model.sliced("absent main/1/state over") == 1);
  CHECK(model.trace("absent main/1/state over").steps.back().date == 5);
}

TEST_CASE("questions about all processes are answered where one of them is enough to tell") {
  const Text model("process Event is states a from a to a " + walker("P", "1,2") +
                   walker("Q", "1,3") + "component main is par * in Event || P || Q end");
  CHECK(model.isTrue("deadlockfree"));
}

TEST_CASE("a deadlock is searched for in parts") {
  const auto worker = [](const std::string& name, const std::string& flag) {
    return "process " + name + " (&" + flag +
           ": bool) is states idle, a, b from idle wait [0,0]; on " + flag +
           "; to a from a wait [1,2]; to b from b wait [1,3]; " + flag + " := false; to idle ";
  };
  const std::string workers = worker("P", "p") + worker("Q", "q") + worker("R", "r");
  const auto with = [&](const std::string& end) {
    return Text(workers +
                "process M (&p: bool, &q: bool, &r: bool) is states start, wait_, over "
                "from start wait [0,0]; p := true; q := true; r := true; to wait_ "
                "from wait_ wait [0,0]; on not (p or q or r); to over from over " +
                end +
                " component main is var p: bool := false, q: bool := false, r: bool := false "
                "par * in P(&p) || Q(&q) || R(&r) || M(&p, &q, &r) end");
  };
  const auto stays = with("wait [0,...[; loop");
  CHECK(stays.isTrue("deadlockfree"));
  CHECK(stays.sliced("deadlockfree") == 1);
  const auto repeats = with("wait [1,1]; to start");
  CHECK(repeats.isTrue("deadlockfree"));
  CHECK(repeats.sliced("deadlockfree") == 1);
  CHECK(with("wait [0,0]; on p; to start").isFalse("deadlockfree"));
}

TEST_CASE("a deadlock is searched for in parts that one location of a process calls") {
  std::string text;
  std::string calls;
  std::string flags;
  std::string workers;
  for (int i = 0; i < 4; ++i) {
    text +=
        fmt::format("process W{0} (&f: bool) is states idle, a from idle wait [0,0]; on f; to a "
                    "from a wait [1,{1}]; f := false; to idle ",
                    i, i + 2);
    calls += fmt::format("{0} on not f{1}; wait [0,...[; f{1} := true; loop ", i ? "[]" : "", i);
    flags += fmt::format("{}&f{}", i ? ", " : "", i);
    workers += fmt::format(" || W{0}(&f{0})", i);
  }
  const Text model(text + "process Caller (" + flags + ": bool) is states s from s select " +
                   calls + " end component main is var f0, f1, f2, f3: bool := false par * in " +
                   "Caller(" + flags + ")" + workers + " end");
  CHECK(model.isTrue("deadlockfree"));
  CHECK(model.sliced("deadlockfree") == 1);
}

TEST_CASE("a variable matters to the steps that only end the relevant part of a process") {
  // Y may leave l only while c is true; nobody asks whether it does, but c is true for an instant
  const Text model(
      "process X (&c: bool, &v: bool) is states a, b, done, over from a wait [1,1]; c := true; to "
      "b "
      "from b wait [0,0]; on c; v := true; to done from done wait [0,0]; c := false; to over "
      "process Y (&c: bool, &w: bool) is states l, m, k "
      "from l select wait [0,0]; on c; to m [] wait [3,3]; w := true; to k end " +
      walker("P", "1,2") + walker("Q", "1,3") + walker("R", "2,3") +
      "component main is var c: bool := false, v: bool := false, w: bool := false "
      "par * in X(&c, &v) || Y(&c, &w) || P || Q || R end");
  CHECK(model.sliced("absent (main/value w and main/value v)") == 1);
  CHECK(model.reaches("main/value w and main/value v"));
}

// --- Refinement

TEST_CASE("a test that only decides about an event matters to questions about this event") {
  // each step of Q adds to what P reads when it warns, but P does the same afterwards
  const Text model("process P (&n: 0..2) is states a, b from a wait [1,2]; "
                   "if n > 1 then #many end; to b from b wait [1,1]; to a "
                   "process Q (&n: 0..2) is states a, b from a wait [1,3]; n := (n + 1) % 3; to b "
                   "from b wait [2,2]; to a " +
                   walker("R", "1,2") +
                   "component main is var n: 0..2 := 0 par * in P(&n) || Q(&n) || R end");
  CHECK(model.reaches("main/1/tag many"));
  CHECK(model.sliced("absent main/1/tag many") == 1);
  CHECK(model.sliced("absent main/1/state b") == 1);
  CHECK(model.isFalse("absent ((main/1/state b) and (main/2/state b))"));
}

TEST_CASE("a bounded response is shown by the part that responds") {
  const Text model(walker("P", "1,2") + walker("Q", "1,3") + walker("R", "2,3") +
                   "component main is par * in P || Q || R end");
  CHECK(model.refined("main/1/state b leadsto main/1/state c within [0,2]") == 1);
  CHECK_FALSE(model.isFalse("main/1/state b leadsto main/1/state c within [0,2]"));
  CHECK(model.refined("main/1/state b leadsto main/1/state c within [0,1]") == 0);
  CHECK(model.isFalse("main/1/state b leadsto main/1/state c within [0,1]"));
}

TEST_CASE("a response that needs another part is shown once the slice has it") {
  // P waits for Q, which gives it what it needs after 3 at the latest
  const std::string waiter = "process P (&free: bool) is states idle, waits, over from idle "
                             "wait [1,1]; to waits from waits wait [0,0]; on free; free := false; "
                             "to over from over wait [4,4]; to idle ";
  const Text model(waiter +
                   "process Q (&free: bool) is states a, b from a wait [1,3]; free := "
                   "true; to b from b wait [0,0]; on not free; to a " +
                   walker("R", "1,3") +
                   "component main is var free: bool := false par * in P(&free) || Q(&free) || R "
                   "end");
  CHECK(model.refined("main/1/state waits leadsto main/1/state over within [0,2]") == 1);
  CHECK_FALSE(model.isFalse("main/1/state waits leadsto main/1/state over within [0,2]"));
  CHECK(model.isFalse("main/1/state waits leadsto main/1/state over within [0,1]"));
}

TEST_CASE("two never have what they take in turn, whatever else happens") {
  const Text model(users(3, "taken := false;"));
  const std::string both = "((main/1/state has) and (main/2/state has))";
  CHECK_FALSE(model.reaches(both));
  CHECK(model.sliced("absent " + both) == 0); // each has an influence on all
  CHECK(model.refined("absent " + both) == 1);
}

TEST_CASE("what a slice has to know about one call it has to know about the others") {
  const Text model(calls(30)); // if the mission did not wait for them, they would have 3^30 states
  CHECK_FALSE(model.reaches("main/1/state broken"));
  CHECK(model.sliced("absent main/1/state broken") == 0);
  CHECK(model.refined("absent main/1/state broken") == 1);
}

TEST_CASE("who gives back too early lets another in") {
  // the second place is given back by whoever passes `after`
  const Text model(users(3, ""));
  CHECK_FALSE(model.reaches("((main/1/state has) and (main/2/state has))"));
  CHECK(model.reaches("((main/1/state after) and (main/2/state want))"));
  CHECK(model.refined("absent ((main/1/state after) and (main/2/state want))") == 1);
}

TEST_CASE("a run of a part is completed by what others have to do at its dates") {
  // P waits for Q, which takes 4 to 5 s; R makes steps every second
  const Text model("process P (&called, &ready: bool) is states a, b, c "
                   "from a wait [0,0]; called := true; to b "
                   "from b wait [0,0]; on ready; if called then to c else to a end "
                   "process Q (&called, &ready: bool) is states idle, busy "
                   "from idle wait [0,0]; on called and not ready; to busy "
                   "from busy wait [4,5]; ready := true; to idle "
                   "process R is states s, t from s wait [1,1]; to t from t wait [1,1]; to s "
                   "component main is var called: bool := false, ready: bool := false "
                   "par * in P(&called, &ready) || Q(&called, &ready) || R end");
  CHECK(model.reaches("main/1/state c"));
  CHECK(model.refined("absent main/1/state c") == 1);
  CHECK(model.trace("absent main/1/state c").steps.back().date == 4);
}

TEST_CASE("time decides where conditions do not") {
  // Q is always first
  const std::string text = "process P (&x: 0..2) is states a, b from a wait [5,6]; x := 1; to b "
                           "process Q (&x: 0..2) is states a, b from a wait [1,{}]; "
                           "on x = 0; x := 2; to b "
                           "process R (&x: 0..2) is states a, b from a wait [9,9]; on x = 2; to b "
                           "component main is var x: 0..2 := 0 "
                           "par * in P(&x) || Q(&x) || R(&x) end";
  const std::string asked = "((main/1/state b) and (main/2/state a))";
  CHECK_FALSE(Text(fmt::format(fmt::runtime(text), 4)).reaches(asked));
  CHECK(Text(fmt::format(fmt::runtime(text), 5)).reaches(asked));
  CHECK(Text(fmt::format(fmt::runtime(text), 4)).refined("absent " + asked) == 1);
}

TEST_CASE("a location that nobody notices is passed at once, with what it writes") {
  // from b to d leads a way on which v is written, and one on which it is not
  const Text model("process P (&v: 0..3, &w: bool) is states a, b, c, d, e "
                   "from a wait [0,0]; to b "
                   "from b select wait [1,2]; v := 1; to c [] wait [2,3]; to c end "
                   "from c wait [0,...[; to d from d wait [0,...[; w := not w; to e "
                   "from e wait [1,1]; to a "
                   "process Q (&w: bool) is states a, b from a wait [1,2]; on w; to b "
                   "from b wait [1,2]; on not w; to a "
                   "component main is var v: 0..3 := 0, w: bool := false "
                   "par * in P(&v, &w) || Q(&w) end");
  CHECK(model.reaches("main/value v = 1"));
  CHECK(model.reaches("((main/value v = 0) and (main/2/state b))"));
  CHECK_FALSE(model.reaches("main/value v = 2"));
  CHECK(model.refined("absent main/value v = 2") == 1);
}

TEST_CASE("steps that two take together read no old values") {
  // B reads c for the last time before it sets c, which A waits for
  const Text model("process A [p: none] (&c: bool) is states a, b from a on c; p; to b "
                   "process B [p: none] (&c: bool, &x: bool) is states l0, l1, l2 "
                   "from l0 x := c; to l1 from l1 select c := true; loop [] p; to l2 end "
                   "component main is var c: bool := false, x: bool := false port p: none "
                   "par p -> A[p](&c) || p -> B[p](&c, &x) end");
  CHECK(model.reaches("((main/2/state l2) and (main/value (not x)))"));
}

TEST_CASE("an error before a test needs no test to be true") {
  const Text model("process P (&x: 0..3, &z: 0..3) is states s, t "
                   "from s x := x + z; on z = 0; to t "
                   "process Q (&z: 0..3) is states s, t from s wait [0,1]; z := 1; to t "
                   "process R is states s, t from s wait [1,1]; to t from t wait [1,2]; to s "
                   "component main is var x: 0..3 := 3, z: 0..3 := 0 "
                   "par * in P(&x, &z) || Q(&z) || R end");
  CHECK_FALSE(model.error().empty());
}

} // namespace proskill::test::slices_test
