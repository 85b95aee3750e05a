#include "tests/support/models.h"

#include <catch2/catch.hpp>

namespace proskill::test::urgent_cycles_test {

using verify::Reduction;

TEST_CASE("Dead variables: a watchdog is left out whose urgent steps need others to move") {
  const auto running = [] { return on(name("running")); };
  const auto resting = [] { return on(unary(fiacre::Op::Not, name("running"))); };
  const auto worker = [] {
    Model model;
    model.variable("running", boolean(), truth(true));
    model.add(
        process("worker", {"run", "rest"},
                {from("run", {waitIn({1, 3}), assign(name("running"), truth(false)), to("rest")}),
                 from("rest", {wait(1, 1), assign(name("running"), truth(true)), to("run")})}));
    return model;
  };
  Model watched = worker();
  watched.add(
      process("watchdog", {"idle", "on_time", "late"},
              {from("idle", {now(), running(), to("on_time")}),
               from("on_time",
                    {select({sequence({now(), resting(), to("idle")}),
                             sequence({waitIn({2, std::nullopt, true, false}), to("late")})})})}));
  const auto progress = plain(fiacre::PatternKind::Progress);
  const auto alone = classesToProve(worker(), progress, {Reduction::DeadVariables});
  CHECK(classesToProve(watched, progress, {Reduction::DeadVariables}) == alone);
  CHECK(classesToProve(watched, progress, {}) > alone);
  CHECK(watched.reaches(2, "late"));
}

TEST_CASE("Dead variables: watchers that move each other for ever are not left out") {
  Model model;
  model.variable("x", boolean(), truth(true)).variable("y", boolean(), truth(false));
  const auto follows = [](const char* read, const char* written, bool same) {
    const auto is = on(name(read));
    const auto isNot = on(unary(fiacre::Op::Not, name(read)));
    return process(std::string("sets_") + written, {"a", "b"},
                   {from("a", {now(), is, assign(name(written), truth(same)), to("b")}),
                    from("b", {now(), isNot, assign(name(written), truth(!same)), to("a")})});
  };
  model.add(follows("x", "y", true)).add(follows("y", "x", false));
  model.add(process("p", {"a", "b"}, {from("a", {wait(1, 1), to("b")})}));
  CHECK_FALSE(model.reaches(3, "b"));
}

} // namespace proskill::test::urgent_cycles_test
