#include "codegen/process/environment.h"

#include "codegen/process/body_process.h"
#include "codegen/term/conditions.h"
#include "codegen/term/effects.h"
#include "codegen/term/grounds.h"
#include "codegen/term/inputs.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::codegen {
namespace {

using fiacre::Statement;

/// The environment of a program as an automaton.
class EnvironmentBody : public BodyProcess {
public:
  EnvironmentBody(Context& context, const analysis::Definition<syntax::Environment>& environment)
      : BodyProcess(context, *context.plan.environmentBody, {"environment", environment.file},
                    name("root")),
        environment(environment) {}

  fiacre::Process make() {
    fiacre::Process process;
    process.name = context.names.process({"environment", environment.name()});
    process.origin = origin(environment->name.range);
    process.comment = context.definitionOf(environment);
    addBody(process);
    return process;
  }

private:
  std::vector<Statement> abortStatements(const std::vector<std::string_view>& running,
                                         bool joining) override {
    static_cast<void>(running);
    static_cast<void>(joining);
    return {};
  }

  std::optional<Statement> atEnd() override { return std::nullopt; }

  Statement conclude(const syntax::Statement& statement) override {
    static_cast<void>(statement);
    return stay(); // an environment has no outcome; `check` rejects the statement
  }

  /// Interrupts a skill through its port. Does nothing if the skill is not running.
  Statement interrupt(const BodyState& state) override {
    const auto& statement = *state.statement;
    const auto target = statement.name.text;
    const auto skips =
        origin(statement.range, fmt::format("does not interrupt `{}`: it is not running", target));
    if (!context.plan.find(target)) return sequence({atOnce(), at(skips, to(state.next))});
    const auto isRunning = calls.isOutstanding(target);
    const auto words = origin(statement.range, fmt::format("interrupts `{}`", target));
    return select(
        {sequence({on(isRunning), at(words, synchronise(context.names.interruptPort(target))),
                   to(state.next)}),
         sequence({atOnce(), on(negation(isRunning)), at(skips, to(state.next))})});
  }

  const analysis::Definition<syntax::Environment>& environment;
};

fiacre::Process basicEnvironment(Context& context) {
  const auto stem = sanitised(context.program.files[0].path.stem().string());
  fiacre::Process process;
  process.name = context.names.process({"basic_environment", stem});
  process.comment = "Every event and every interrupt from outside, at any time.";
  process.origin = context.origins.of({"environment", 0}, {});
  std::vector<Statement> choices;
  for (const auto& port : environmentPorts(context)) choices.push_back(synchronise(port));
  if (choices.empty())
    process.states.push_back({"start_", process.origin});
  else
    addState(process, "start_", process.origin,
             sequence({select(std::move(choices)), to("start_")}));
  return process;
}

class EventAutomaton {
public:
  EventAutomaton(Context& context, const analysis::Definition<syntax::Event>& event)
      : context(context),
        event(event),
        actor{std::string(event.name()), event.file},
        place(context.origins.of(actor, event->name.range)) {}

  fiacre::Process make() {
    process.name = context.names.process({"event", event.name(), "automata"});
    process.origin = place;
    process.comment = context.definitionOf(event);
    if (context.isRuntime() && event->every)
      addMeasured();
    else if (context.isExpanded() && comesByItself(context, event.node()))
      addDue();
    else
      addState(process, "start_", place, sequence({occurs(), to("start_")}));
    return std::move(process);
  }

private:
  Statement occurs() {
    const auto words = context.origins.of(actor, event->name.range, "occurs");
    auto step = at(words, synchronise(context.names.event(event.name())));
    auto set = effects(context, actor, event->effects);
    if (!event->guard) return sequence({std::move(step), std::move(set)});
    auto guard = condition(context, *event->guard);
    decidedBy(context, words, guard, true);
    return sequence({on(std::move(guard)), std::move(step), std::move(set)});
  }

  /// Puts the time limit on a path of its own, since the rest may contain tests.
  void addDue() {
    const auto words = context.origins.of(actor, event->every->range, "is due");
    addState(process, "start_", place,
             sequence({wait(context.times.interval(*event->every)), at(words, to("due"))}));
    addState(process, "due", place, sequence({occurs(), to("start_")}));
  }

  /// The platform reports the event, and the model measures in ticks. An event that is one tick
  /// early may be missed, but there is no false alarm.
  void addMeasured() {
    const auto ticks = context.times.interval(*event->every);
    const auto least = std::max<std::int64_t>(0, ticks.lower - (ticks.lowerOpen ? 0 : 1));
    const auto first = least > 0 ? "early" : "on_time";
    if (least > 0)
      addState(process, "early", place,
               select({sequence({occurs(), warning("too early", "undershoot"), to("early")}),
                       sequence({wait({.lower = least, .upper = least}), to("on_time")})}));
    std::vector<Statement> all{sequence({occurs(), to(first)})};
    if (ticks.upper) {
      const auto rest = *ticks.upper - (ticks.upperOpen ? 1 : 0) + 1 - least;
      all.push_back(sequence(
          {wait({.lower = rest, .upper = rest}), warning("too late", "overshoot"), to("late")}));
    }
    addState(process, "on_time", place, select(std::move(all)));
    if (ticks.upper) addState(process, "late", place, sequence({occurs(), to(first)}));
  }

  Statement warning(std::string_view what, std::string_view kind) {
    const auto words =
        context.origins.of(actor, event->every->range, fmt::format("comes {}", what));
    return at(words, saying(fmt::format("WARNING: {}", kind),
                            tag(context.names.tag({event.name(), kind}))));
  }

  Context& context;
  const analysis::Definition<syntax::Event>& event;
  Actor actor;
  OriginId place;
  fiacre::Process process;
};

} // namespace

bool comesByItself(const Context& context, const syntax::Event& event) {
  const bool isModel =
      context.hasEnvironment() && (!context.isExecuted() || context.plan.environment);
  return event.every && isModel;
}

fiacre::Process eventProcess(Context& context, const analysis::Definition<syntax::Event>& event) {
  return EventAutomaton(context, event).make();
}

std::vector<std::string> environmentPorts(Context& context) {
  std::vector<std::string> ports;
  for (const auto& event : context.program.events.all)
    if (!comesByItself(context, event.node())) ports.push_back(context.names.event(event.name()));
  for (const auto& skill : context.plan.skills)
    if (skill.skill().interrupt) ports.push_back(context.names.interruptPort(skill.name()));
  return ports;
}

std::vector<fiacre::Port> everyPorts(Context& context) {
  std::vector<fiacre::Port> ports;
  for (const auto& event : context.program.events.all) {
    if (!comesByItself(context, event.node())) continue;
    auto& port = ports.emplace_back();
    port.name = context.names.event(event.name());
    port.interval = context.isExpanded() ? fiacre::Interval{.lower = 0, .upper = 0}
                                         : context.times.interval(*event->every);
  }
  return ports;
}

fiacre::Process environmentProcess(Context& context) {
  if (context.plan.environment) return EnvironmentBody(context, *context.plan.environment).make();
  return basicEnvironment(context);
}

fiacre::Process generalCaller(Context& context) {
  const Actor actor{"most general caller", 0};
  fiacre::Process process;
  process.name = "most_general_caller";
  process.comment = "There is no mission: any basic skill may be called at any time.";
  process.origin = context.origins.of(actor, {});
  Calls calls(context, name("root"));
  std::vector<Statement> choices;
  for (const auto& skill : context.plan.skills) {
    if (!skill.generalCaller) continue;
    const auto words = context.origins.of({actor.name, skill.file()}, skill.skill().name.range,
                                          fmt::format("calls `{}`", skill.name()));
    choices.push_back(
        sequence({on(calls.isFree(skill.name())), wait({}), at(words, calls.take(skill.name())),
                  chooseInputs(context, skill)}));
  }
  addState(process, "start_", process.origin, sequence({select(std::move(choices)), to("start_")}));
  return process;
}

} // namespace proskill::codegen
