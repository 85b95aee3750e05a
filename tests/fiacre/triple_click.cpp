#include "tests/fiacre/build.h"

namespace proskill::fiacre::test {
namespace {

Process clicker() {
  auto made = process(
      "clicker", {"wait_click", "make_click"},
      {from("wait_click", {with("any time from zero to infinity", wait(0, {})), to("make_click")}),
       from("make_click", {with("issue a click", port("click")), to("wait_click")})});
  made.comment = "Makes clicks at any time.";
  made.ports = {{.name = "click"}};
  return made;
}

/// Within 0.2 s: the next click, or back to the first.
From clickWithin(std::string state, std::string next) {
  return from(std::move(state), {select({sequence({wait(2, 2), with("too late", to("wait_first"))}),
                                         sequence({port("click"), to(std::move(next))})})});
}

Process detector() {
  auto made =
      process("detect_triple_click", {"wait_first", "wait_second", "wait_third", "detected"},
              {from("wait_first", {with("first click", port("click")), to("wait_second")}),
               clickWithin("wait_second", "wait_third"), clickWithin("wait_third", "detected"),
               from("detected", {port("triple_click"), to("wait_first")})});
  made.ports = {{.name = "click"}, {.name = "triple_click"}};
  return made;
}

Process receiver() {
  auto made =
      process("triple_click_receiver", {"waiting_tc", "received_tc"},
              {from("waiting_tc", {port("triple_click"), to("received_tc")}),
               from("received_tc", {comment("do what needs to be done"), to("waiting_tc")})});
  made.ports = {{.name = "triple_click"}};
  return made;
}

} // namespace

Program tripleClick() {
  const Interval atOnce{.lower = 0, .upper = 0};
  Component main{
      .name = "comp_tc",
      .ports = {{.name = "click", .interval = atOnce},
                {.name = "triple_click", .interval = atOnce}},
      .instances = {{.process = "detect_triple_click", .ports = {"click", "triple_click"}},
                    {.process = "clicker", .ports = {"click"}},
                    {.process = "triple_click_receiver", .ports = {"triple_click"}}}};
  Observable received{.kind = ObservableKind::State, .path = {3}, .name = "received_tc"};
  return {.comment = "A triple click detector. The unit of time is 0.1 s.",
          .processes = {clicker(), detector(), receiver()},
          .components = {main},
          .main = "comp_tc",
          .properties = {{.name = "ddlf", .pattern = {.kind = PatternKind::DeadlockFree}},
                         {.name = "cannot_receive_tc",
                          .pattern = {.kind = PatternKind::Absent, .operands = {received}},
                          .comment = "violated: a triple click can be received"}}};
}

} // namespace proskill::fiacre::test
