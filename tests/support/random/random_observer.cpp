#include "tests/support/random/random_observer.h"

#include "tests/fiacre/build.h"

namespace proskill::test {

using namespace fiacre;
using namespace fiacre::test;

Observable stateOf(std::uint32_t instance, std::string state) {
  return {.path = {instance}, .name = std::move(state)};
}

namespace {

/// States or steps to observe, among those that the properties cover.
Observable seen(RandomSource& random, const Program& program, bool ofSteps) {
  std::vector<Observable> all;
  for (const auto& property : program.properties)
    for (const auto& operand : property.pattern.operands)
      if (watchesSteps(operand) == ofSteps) all.push_back(operand);
  Observable made = random.pick(all);
  if (ofSteps && random.chance(30))
    made = {.kind = ObservableKind::Or, .operands = {made, random.pick(all)}};
  if (ofSteps && random.chance(20))
    made = {.kind = ObservableKind::Enter, .operands = {stateOf(1, "s1")}};
  if (random.chance(30))
    made = {.kind = ObservableKind::And, .operands = {made, seen(random, program, false)}};
  if (random.chance(10)) made = {.kind = ObservableKind::Not, .operands = {made}};
  return made;
}

Statement timed(std::int64_t from, std::int64_t to) {
  return {.kind = StatementKind::Wait, .interval = {.lower = from, .upper = to}};
}

Process watcher(RandomSource& random, const std::string& named) {
  const auto passes = [&](const std::string& by) {
    return sequence({port(by), random.chance(30) ? tag("seen") : null(),
                     random.chance(30) ? Statement{.kind = StatementKind::Loop}
                                       : to("w" + std::to_string(random.below(3)))});
  };
  Process made{.name = named, .ports = {{.name = "p"}, {.name = "q"}}};
  for (int i = 0; i < 3; ++i) {
    made.states.push_back({"w" + std::to_string(i), 0});
    std::vector<Statement> branches{passes(random.chance(50) ? "p" : "q")};
    if (random.chance(60)) branches.push_back(passes("q"));
    if (random.chance(30)) branches.push_back(sequence({timed(1, 2), to("w0")}));
    made.transitions.push_back(
        {"w" + std::to_string(i), branches.size() == 1 ? branches[0] : select(branches), {}});
  }
  return made;
}

} // namespace

void addRandomObserver(RandomSource& random, Program& program) {
  Component made{.name = "watch"};
  made.ports.push_back({.name = "p", .probe = seen(random, program, false)});
  made.ports.back().interval = Interval{.lower = 0, .upper = 0};
  if (random.chance(30)) made.ports.back().interval = Interval{.lower = 1, .upper = 1};
  made.ports.push_back({.name = "q", .probe = seen(random, program, true)});
  if (random.chance(30)) made.ports.push_back({.name = "r", .probe = seen(random, program, true)});
  const auto third = made.ports.back().name;
  for (const auto* each : {"W", "V"}) program.processes.push_back(watcher(random, each));
  Instance first{.process = "W", .ports = {"p", "q"}};
  Instance second{.process = "V", .ports = {"p", third}};
  made.instances = {{.parts = {first}}};
  if (random.chance(50)) made.instances[0].parts.push_back(second);
  program.components.push_back(std::move(made));
  program.observers.push_back({"watch", program.main});
  const auto ask = [&](Observable what) {
    what.observer = "watch";
    program.properties.push_back(
        {.name = "w" + std::to_string(program.properties.size()),
         .pattern = {.kind = PatternKind::Absent, .operands = {std::move(what)}}});
  };
  for (int i = 0; i < 3; ++i) ask({.path = {1, 1}, .name = "w" + std::to_string(i)});
  for (const auto* port : {"p", "q"}) ask({.kind = ObservableKind::Event, .name = port});
}

} // namespace proskill::test
