#include "tests/support/models.h"

#include <catch2/catch.hpp>

using namespace proskill;
using namespace proskill::test;
using verify::Reduction;

TEST_CASE("Dead variables: what nobody reads does not tell states apart") {
  Model model;
  model.variable("note", range(0, 9), number(0));
  model.add(
      process("p", {"a"},
              {from("a", {wait(1, 1),
                          ifElse(binary(fiacre::Op::Less, name("note"), number(9)),
                                 assign(name("note"), number(9)), assign(name("note"), number(3))),
                          to("a")})}));
  Model unread;
  unread.variable("note", range(0, 9), number(0));
  unread.add(process("p", {"a", "b"},
                     {from("a", {wait(1, 1), assign(name("note"), number(4)), to("b")}),
                      from("b", {wait(1, 1), assign(name("note"), number(5)), to("a")})}));
  const auto progress = plain(fiacre::PatternKind::Progress);
  CHECK(classesToProve(model, progress, {}) == 3);
  CHECK(classesToProve(unread, progress, {}) == 3);
  CHECK(classesToProve(unread, progress, {Reduction::DeadVariables}) == 2);
}

TEST_CASE("Dead variables: a process that can stop time is not left out") {
  Model model;
  model.add(process("spinner", {"a"}, {from("a", {now(), to("a")})}));
  model.add(process("p", {"a", "b"}, {from("a", {wait(1, 1), to("b")})}));
  CHECK_FALSE(model.reaches(2, "b"));
}

TEST_CASE("Live variables: a value that is written before it is read again is forgotten") {
  Model model;
  model.variable("x", range(0, 9), number(0));
  model.add(
      process("p", {"choose", "use", "rest"},
              {from("choose", {select({sequence({assign(name("x"), number(1)), to("use")}),
                                       sequence({assign(name("x"), number(2)), to("use")})})}),
               from("use", {on(binary(fiacre::Op::Less, number(0), name("x"))), to("rest")}),
               from("rest", {to("choose")})}));
  const auto stops = plain(fiacre::PatternKind::DeadlockFree);
  CHECK(classesToProve(model, stops, {}) == 7);
  CHECK(classesToProve(model, stops, {Reduction::LiveVariables}) == 4);
}

TEST_CASE("Live variables: a process that can never go on reads nothing") {
  Model model;
  model.variable("go", boolean(), truth(false)).variable("x", range(0, 9), number(0));
  model.add(process("waits", {"a", "b"},
                    {from("a", {on(name("go")), on(equals(name("x"), number(3))), to("b")})}));
  model.add(process("writes", {"a"},
                    {from("a", {select({sequence({assign(name("x"), number(1)), to("a")}),
                                        sequence({assign(name("x"), number(2)), to("a")})})})}));
  const auto never = absentState(1, "b");
  CHECK(classesToProve(model, never, {}) == 3);
  CHECK(classesToProve(model, never, {Reduction::LiveVariables}) == 1);
}

TEST_CASE("Live variables: what one way out of a state reads is forgotten until that way is open") {
  Model model;
  model.variable("busy", boolean(), truth(false)).variable("stop", boolean(), truth(false));
  model.variable("status", range(0, 3), number(0));
  std::vector<fiacre::Statement> outcomes;
  for (std::int64_t value = 1; value <= 3; ++value)
    outcomes.push_back(
        sequence({wait(1, 1), on(name("busy")), assign(name("status"), number(value)),
                  assign(name("busy"), truth(false)), to("idle")}));
  model.add(process("callee", {"idle"}, {from("idle", {select(outcomes)})}));
  model.add(
      process("caller", {"call", "wait", "stopping"},
              {from("call", {now(), assign(name("busy"), truth(true)), to("wait")}),
               from("wait", {select({sequence({now(), on(unary(fiacre::Op::Not, name("busy"))),
                                               ifElse(equals(name("status"), number(1)), to("call"),
                                                      to("stopping"))}),
                                     sequence({now(), on(name("stop")), to("stopping")})})})}));
  model.add(process("stopper", {"a"}, {from("a", {assign(name("stop"), truth(true)), to("a")})}));
  const auto never = plain(fiacre::PatternKind::Progress);
  CHECK(classesToProve(model, never, {Reduction::LiveVariables}) == 13);
  CHECK(classesToProve(model, never, {}) > 20);
}

TEST_CASE("Safe steps: independent chains of urgent steps are run one after the other") {
  Model model;
  for (const char* text : {"p", "q", "r"})
    model.add(process(text, {"a", "b", "c", "d"},
                      {from("a", {wait(1, 1), to("b")}), from("b", {now(), to("c")}),
                       from("c", {now(), to("d")})}));
  const auto progress = plain(fiacre::PatternKind::Progress);
  CHECK(classesToProve(model, progress, {Reduction::StubbornSets}) <
        classesToProve(model, progress, {}) / 3);
}

TEST_CASE("Safe steps: what a question looks at is not skipped") {
  Model model;
  model.variable("x", range(0, 2), number(0)).variable("y", range(0, 2), number(0));
  for (const char* text : {"x", "y"})
    model.add(process(std::string("p") + text, {"a", "b", "c"},
                      {from("a", {now(), assign(name(text), number(1)), to("b")}),
                       from("b", {now(), assign(name(text), number(2)), to("c")})}));
  const auto both = [](std::int64_t x, std::int64_t y) {
    return absentValue(
        binary(fiacre::Op::And, equals(name("x"), number(x)), equals(name("y"), number(y))));
  };
  for (std::int64_t x = 0; x <= 2; ++x)
    for (std::int64_t y = 0; y <= 2; ++y) CHECK(model.isFalse(both(x, y)));
}

TEST_CASE("Safe steps: a cycle of them does not put others off for ever") {
  Model model;
  model.add(
      process("cycle", {"a", "b"}, {from("a", {now(), to("b")}), from("b", {now(), to("a")})}));
  model.add(process("p", {"a", "b"}, {from("a", {now(), to("b")})}));
  CHECK(model.reaches(2, "b"));
}

namespace {

/// `weather` is set to 0, 1 or 2 at any time; it starts with 3, which is never set again.
Model weather() {
  Model model;
  model.variable("weather", range(0, 3), number(3)).variable("x", range(0, 3), number(0));
  for (std::int64_t value = 0; value < 3; ++value) {
    const std::string text = "to" + std::to_string(value);
    model.channel(text);
    model.add(process("event_" + text, {"a"},
                      {from("a", {port(text), assign(name("weather"), number(value)), to("a")})}));
  }
  std::vector<fiacre::Statement> any;
  for (std::int64_t value = 0; value < 3; ++value)
    any.push_back(port("to" + std::to_string(value)));
  model.add(process("environment", {"a"}, {from("a", {select(any), to("a")})}));
  return model;
}

} // namespace

TEST_CASE("Open variables: one value stands for all that the environment may set") {
  Model model = weather();
  model.add(process("p", {"a", "b", "c"},
                    {from("a", {on(equals(name("weather"), number(2))), to("b")}),
                     from("b", {wait(1, 1), to("a")})}));
  const auto progress = plain(fiacre::PatternKind::Progress);
  CHECK(classesToProve(model, progress, {}) == 3 * 2 + 1);
  CHECK(classesToProve(model, progress, {Reduction::FreeInputs}) == 2 + 1);
}

TEST_CASE("Open variables: each value, and the first one, leads where it leads") {
  Model model = weather();
  std::vector<fiacre::Statement> choices;
  for (std::int64_t value = 0; value <= 3; ++value)
    choices.push_back(sequence({on(equals(name("weather"), number(value))), wait(0, 0),
                                to("saw" + std::to_string(value))}));
  model.add(process("p", {"a", "saw0", "saw1", "saw2", "saw3"}, {from("a", {select(choices)})}));
  for (std::int64_t value = 0; value <= 3; ++value)
    CHECK(model.reaches(5, "saw" + std::to_string(value)));
}

TEST_CASE("Open variables: time passes if it may for one of the values") {
  Model model = weather();
  model.add(process(
      "p", {"a", "b", "c"},
      {from("a", {select({sequence({now(), on(binary(fiacre::Op::Less, name("weather"), number(2))),
                                    to("c")}),
                          sequence({wait(3, 3), to("b")})})})}));
  CHECK(model.reaches(5, "b"));
  auto trace = model.answer(absentState(5, "b")).trace.value();
  CHECK(trace.steps.size() == 1); // the weather may stay as it is
}

TEST_CASE(
    "Open variables: a condition over many inputs is decided without trying all their values") {
  Model model;
  auto all = truth(true);
  for (int i = 0; i < 24; ++i) {
    const std::string text = "w" + std::to_string(i);
    model.variable(text, range(0, 2), number(0));
    std::vector<fiacre::Statement> values;
    for (std::int64_t value = 0; value < 3; ++value)
      values.push_back(sequence({assign(name(text), number(value)), to("a")}));
    model.add(process("sets_" + text, {"a"}, {from("a", {select(values)})}));
    all = binary(fiacre::Op::And, all, equals(name(text), number(i % 3)));
  }
  model.add(process("p", {"a", "b", "c"},
                    {from("a", {now(), on(all), to("b")}),
                     from("b", {now(), on(unary(fiacre::Op::Not, all)), to("c")})}));
  CHECK(model.answer(absentState(25, "c")).truth == verify::Truth::False);
  CHECK(classesToProve(model, plain(fiacre::PatternKind::Progress), {Reduction::FreeInputs}) == 3);
}

TEST_CASE("Open variables: a number that is counted up and down at any time has any value") {
  Model model;
  model.variable("n", range(0, 5), number(0)).variable("m", range(0, 5), number(0));
  const auto counts = [&](const char* process_, const char* text, std::int64_t by, int limit) {
    const auto bound = by > 0 ? binary(fiacre::Op::Less, name(text), number(limit))
                              : binary(fiacre::Op::Less, number(limit), name(text));
    model.add(process(
        process_, {"a"},
        {from("a", {on(bound), assign(name(text), sum(name(text), number(by))), to("a")})}));
  };
  counts("up", "n", 1, 5);
  counts("down", "n", -1, 0);
  counts("once", "m", 1, 3); // m never returns: it is not open
  model.add(process(
      "p", {"a", "b", "c"},
      {from("a", {wait(1, 1), to("b")}), from("b", {now(), on(equals(name("n"), number(4))),
                                                    on(equals(name("m"), number(2))), to("c")})}));
  CHECK(model.reaches(4, "c"));
  const auto progress = plain(fiacre::PatternKind::Progress);
  CHECK(classesToProve(model, progress, {}) > 50);
  CHECK(classesToProve(model, progress, {Reduction::FreeInputs}) <= 3 * 4);
}

TEST_CASE("Open variables: what one value of an input breaks does not hide what others lead to") {
  Model model;
  model.variable("w", range(0, 2), number(0));
  std::vector<fiacre::Statement> values;
  for (std::int64_t value = 0; value < 3; ++value)
    values.push_back(sequence({assign(name("w"), number(value)), to("a")}));
  model.add(process("sets", {"a"}, {from("a", {select(values)})}));
  const auto quotient = binary(fiacre::Op::Divide, number(2), name("w"));
  model.add(
      process("p", {"start", "a", "b", "c"},
              {from("start", {on(equals(name("w"), number(1))), to("a")}),
               from("a", {now(), on(binary(fiacre::Op::Less, number(1), quotient)), to("b")})}));
  model.ask(absentState(2, "b")).ask(plain(fiacre::PatternKind::NoError));
  for (const auto& options : reductionChoices()) {
    const auto answers = model.answers(options).answers;
    CHECK(answers[0].truth == verify::Truth::False);
    CHECK(answers[1].truth == verify::Truth::False);
  }
}

TEST_CASE("Open variables: a trace sets what it needs, and no more") {
  Model model = weather();
  model.add(process("p", {"a", "b", "c"},
                    {from("a", {wait(1, 1), to("b")}),
                     from("b", {on(equals(name("weather"), number(1))), to("c")})}));
  auto trace = model.answer(absentState(5, "c")).trace.value();
  REQUIRE(trace.steps.size() == 3);
  CHECK_THAT(trace.steps[0].transitions.at(0) + trace.steps[1].transitions.at(0),
             Catch::Contains("event_to1"));
}

TEST_CASE("Open variables and safe steps are nothing to a monitor that does not see them") {
  Model model = weather();
  model.variable("y", range(0, 1), number(0));
  model.add(process("p", {"a", "b", "c"},
                    {from("a", {on(equals(name("weather"), number(2))), to("b")}),
                     from("b", {wait(1, 1), to("a")})}));
  for (const char* other : {"q", "r"})
    model.add(process(other, {"a", "b", "c"},
                      {from("a", {now(), to("b")}), from("b", {now(), to("c")}),
                       from("c", {wait(2, 2), to("a")})}));
  auto returns = plain(fiacre::PatternKind::LeadsTo);
  returns.pattern.operands = {{.path = {5}, .name = "b"}, {.path = {5}, .name = "a"}};
  returns.pattern.within = fiacre::Interval{.lower = 0, .upper = 1};
  const auto unreduced = classesToProve(model, returns, {});
  CHECK(classesToProve(model, returns, {Reduction::FreeInputs}) < unreduced / 2);
  CHECK(classesToProve(model, returns, {Reduction::StubbornSets}) < unreduced * 2 / 3);
}

TEST_CASE("Open variables: a step of the environment that a monitor reads stays in the trace") {
  Model model = weather();
  model.add(process("p", {"a", "b", "c"},
                    {from("a", {now(), on(equals(name("weather"), number(2))), to("b")})}));
  auto ends = plain(fiacre::PatternKind::LeadsTo);
  ends.pattern.operands = {{.path = {5}, .name = "b"}, {.path = {5}, .name = "c"}};
  model.ask(ends);
  const std::vector<verify::Question> fair{{.property = 0, .fair = true}};
  for (const auto& options : reductionChoices()) {
    const auto result = verify::verify(model.program(), {}, fair, options);
    REQUIRE(result.has_value());
    CHECK(result->answers[0].reason == "");
    REQUIRE(result->answers[0].trace.has_value());
    CHECK(result->answers[0].trace->steps.size() >= 2);
  }
}

TEST_CASE("A monitor that counts an event of the environment sees each of them") {
  Model model = weather();
  auto late = plain(fiacre::PatternKind::LeadsTo);
  late.pattern.operands = {{.kind = fiacre::ObservableKind::Event, .name = "to1"},
                           {.kind = fiacre::ObservableKind::Event, .name = "to2"}};
  late.pattern.within = fiacre::Interval{.lower = 0, .upper = 3};
  model.ask(late);
  for (const auto& options : reductionChoices())
    CHECK(model.answers(options).answers[0].truth == verify::Truth::False);
}

TEST_CASE("Inclusion: a smaller zone of the same state is not explored") {
  Model model;
  model.add(process(
      "p", {"a", "b"},
      {from("a", {select({sequence({wait(0, 5), to("b")}), sequence({wait(2, 5), to("b")})})})}));
  model.add(process("q", {"a", "b"}, {from("a", {wait(9, 9), to("b")})}));
  const auto progress = plain(fiacre::PatternKind::Progress);
  CHECK(classesToProve(model, progress, {Reduction::Inclusion}) <
        classesToProve(model, progress, {}));
}

TEST_CASE("Extrapolation: how long ago something ripened is forgotten") {
  Model model;
  model.add(process("p", {"a", "b"}, {from("a", {wait(1, 100), to("b")})}));
  model.add(process("q", {"a"}, {from("a", {wait(2, 2), to("a")})}));
  const auto progress = plain(fiacre::PatternKind::Progress);
  CHECK(classesToProve(model, progress, {Reduction::Inclusion, Reduction::Extrapolation}) <
        classesToProve(model, progress, {Reduction::Inclusion}) / 3);
}

namespace {

constexpr int kWatchers = 4;

/// Each process watches an alarm: it reports the alarm, then waits for its end.
Model watchers(bool alarmIsShared) {
  Model model;
  model.variable("heard", range(0, 1), number(0));
  const auto alarm = [&](int i) { return "alarm" + std::to_string(alarmIsShared ? 0 : i); };
  for (int i = 0; i < (alarmIsShared ? 1 : kWatchers); ++i) {
    model.variable(alarm(i), range(0, 1), number(0));
    model.add(
        process("sets_" + alarm(i), {"a"},
                {from("a", {select({sequence({assign(name(alarm(i)), number(0)), to("a")}),
                                    sequence({assign(name(alarm(i)), number(1)), to("a")})})})}));
  }
  for (int i = 0; i < kWatchers; ++i)
    model.add(process("watcher" + std::to_string(i), {"quiet", "rings", "loud", "again"},
                      {from("again", {now(), to("quiet")}),
                       from("quiet", {now(), on(equals(name(alarm(i)), number(1))), to("rings")}),
                       from("rings", {wait(0, 2), assign(name("heard"), number(1)), to("loud")}),
                       from("loud", {now(), on(equals(name(alarm(i)), number(0))), to("again")})}));
  return model;
}

const std::set<Reduction> kFree{Reduction::FreeInputs, Reduction::Extrapolation,
                                Reduction::Inclusion};
const std::set<Reduction> kPrivate{Reduction::FreeInputs, Reduction::PrivateMoves,
                                   Reduction::Extrapolation, Reduction::Inclusion};

} // namespace

TEST_CASE("Private moves: where a process waits on inputs of its own makes no difference") {
  const auto progress = plain(fiacre::PatternKind::Progress);
  CHECK(classesToProve(watchers(false), progress, kPrivate) <
        classesToProve(watchers(false), progress, kFree) / 2);
  CHECK(watchers(false).reaches(kWatchers + 1, "loud"));
  CHECK(watchers(false).reaches(2 * kWatchers, "quiet"));
}

TEST_CASE("Private moves: none on an input that others read") {
  const auto progress = plain(fiacre::PatternKind::Progress);
  CHECK(classesToProve(watchers(true), progress, kPrivate) ==
        classesToProve(watchers(true), progress, kFree));
}

TEST_CASE("Private moves: none to where something comes by itself") {
  Model model = weather();
  model.add(process("p", {"a", "b", "c"},
                    {from("a", {now(), on(equals(name("weather"), number(2))), to("b")}),
                     from("b", {wait(3, 3), to("c")}),
                     from("c", {now(), on(equals(name("weather"), number(1))), to("a")})}));
  model.add(process("clock", {"a", "b"}, {from("a", {wait(5, 5), to("b")})}));
  const auto progress = plain(fiacre::PatternKind::Progress);
  CHECK(classesToProve(model, progress, kPrivate) <
        classesToProve(model, progress, kFree)); // `c` is left at once, `a` is not
  CHECK(model.reaches(6, "b"));
}
