#include "tests/support/text_model.h"

#include <catch2/catch.hpp>

namespace proskill::test::slices_test {

namespace {

/// A process that takes one of three possible steps every `seconds`.
std::string walker(const std::string& name, const std::string& seconds) {
  return "process " + name + " is states a, b, c from a wait [" + seconds +
         "]; to b from b wait [" + seconds + "]; to c from c wait [" + seconds + "]; to a ";
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

} // namespace proskill::test::slices_test
