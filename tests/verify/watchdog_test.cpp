#include "tests/support/models.h"

#include <catch2/catch.hpp>

#include <ostream>

using namespace proskill;
using namespace proskill::test;

namespace {

/// A worker that takes `work`, with a watchdog for 2 to 4, as the code generator makes it.
Model watched(fiacre::Interval work) {
  Model model;
  model.variable("running", boolean(), truth(true));
  model.add(
      process("worker", {"run", "done"},
              {from("run", {waitIn(work), assign(name("running"), truth(false)), to("done")})}));
  const auto ended = [] { return on(unary(fiacre::Op::Not, name("running"))); };
  model.add(process(
      "watchdog", {"early", "on_time", "good", "undershoot", "overshoot"},
      {from("early", {select({sequence({wait(2, 2), to("on_time")}),
                              sequence({ended(), waitIn({0, std::nullopt, true, false}),
                                        to("undershoot")})})}),
       from("on_time",
            {select({sequence({now(), ended(), to("good")}),
                     sequence({waitIn({2, std::nullopt, true, false}), to("overshoot")})})})}));
  return model;
}

struct Verdicts {
  bool undershoot = false;
  bool overshoot = false;
  friend bool operator==(const Verdicts&, const Verdicts&) = default;
};

std::ostream& operator<<(std::ostream& out, const Verdicts& verdicts) {
  return out << (verdicts.undershoot ? "undershoot " : "")
             << (verdicts.overshoot ? "overshoot" : "");
}

Verdicts verdicts(fiacre::Interval work) {
  auto model = watched(work);
  return {model.reaches(2, "undershoot"), model.reaches(2, "overshoot")};
}

} // namespace

TEST_CASE("A watchdog is exact at its bounds") {
  CHECK(verdicts({2, 4}) == Verdicts{false, false});
  CHECK(verdicts({2, 2}) == Verdicts{false, false});
  CHECK(verdicts({4, 4}) == Verdicts{false, false});
}

TEST_CASE("A watchdog can strike as soon as a bound is left, however little") {
  CHECK(verdicts({1, 2, false, true}) == Verdicts{true, false});
  CHECK(verdicts({1, 2}) == Verdicts{true, false});
  CHECK(verdicts({4, 5, true, false}) == Verdicts{false, true});
  CHECK(verdicts({4, 5}) == Verdicts{false, true});
  CHECK(verdicts({3, 4, true, true}) == Verdicts{false, false});
}

TEST_CASE("A watchdog sees an end without bounds on every side") {
  CHECK(verdicts({0, std::nullopt}) == Verdicts{true, true});
}
