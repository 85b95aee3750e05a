#include "codegen/process/executed_action.h"

#include "codegen/process/environment.h"
#include "fiacre/print/print.h"

#include <algorithm>

namespace proskill::codegen {

using fiacre::Statement;

ExecutedAction::ExecutedAction(Context& context, const SkillPlan& skill, SkillFrame& frame)
    : context(context), skill(skill), frame(frame) {
  made.skill = skill.name();
  made.unknownPort = context.names.foreign({skill.name(), "unknown"});
  if (!skill.skill().timeInterval) return;
  const auto& interval = *skill.skill().timeInterval;
  made.interval = context.times.interval(interval);
  made.intervalOrigin = frame.origin(interval.range, "takes its time");
}

void ExecutedAction::addTo(fiacre::Process& process) {
  made.process = process.name;
  frame.addStart(process, "run");
  auto alternatives = breaks();
  alternatives.insert(alternatives.begin(),
                      sequence({select(results()), frame.giveBack(), to("idle")}));
  const auto& action = skill.skill().action;
  addState(process, "run", frame.place(), select(std::move(alternatives)),
           action ? "Action: " + context.origins.excerpt(skill.file(), action->range) : "");
  for (const auto& [state, ending] : stopping)
    addState(process, state, frame.place(), sequence({stopped(), frame.end(ending)}),
             "Its action was asked to stop.");
  frame.addRest(process);
  if (context.isExecuted()) context.performed.push_back(std::move(made));
}

std::vector<Statement> ExecutedAction::results() {
  return context.isExecuted() ? reportedResults() : timedResults();
}

std::vector<Statement> ExecutedAction::timedResults() {
  std::vector<Statement> all;
  for (const auto& outcome : outcomesOf(skill))
    all.push_back(
        sequence({wait(made.interval.value_or(fiacre::Interval{})), frame.outcome(outcome)}));
  return all;
}

/// The results that the platform may report; any other counts as an interruption.
std::vector<Statement> ExecutedAction::reportedResults() {
  std::vector<Statement> all;
  made.results = resultsOf(skill);
  auto result = made.results.begin();
  for (const auto& outcome : outcomesOf(skill)) {
    result->port = context.names.foreign({skill.name(), outcome.status, outcome.tag.text});
    all.push_back(sequence({synchronise(result->port), frame.outcome(outcome)}));
    ++result;
  }
  const auto words =
      frame.origin(skill.skill().name.range, "its action ends without a known result");
  context.alarms.emplace(words, Alarm::UnknownResult);
  auto unknown = tag(context.names.tag({skill.name(), "unknown_result"}));
  all.push_back(sequence({synchronise(made.unknownPort), at(words, std::move(unknown)),
                          frame.outcome(interruptionOf(skill))}));
  return all;
}

std::vector<Statement> ExecutedAction::breaks() {
  const auto& node = skill.skill();
  std::vector<Statement> all;
  if (node.interrupt)
    all.push_back(breakOff(synchronise(context.names.interruptPort(skill.name())), "outside",
                           outsideInterruptionOf(skill)));
  if (skill.obeysStops())
    all.push_back(breakOff(sequence({atOnce(), on(frame.stop())}), "asked", interruptionOf(skill)));
  for (const auto& invariant : node.invariants)
    all.push_back(breakOff(sequence({atOnce(), on(frame.fails(invariant))}),
                           "failed_inv_" + std::string(invariant.tag.text), failureOf(invariant)));
  return all;
}

Statement ExecutedAction::breakOff(Statement trigger, const std::string& reason,
                                   const Ending& ending) {
  const auto state = "stopping_" + reason;
  const auto known = [&](const auto& each) { return each.first == state; };
  if (std::ranges::none_of(stopping, known)) stopping.emplace_back(state, ending);
  const auto words = frame.origin(ending.range, "asks its action to stop");
  return sequence({std::move(trigger), at(words, to(state))});
}

/// Waits for the end of an action that was asked to stop.
Statement ExecutedAction::stopped() {
  if (!context.isExecuted()) return atOnce();
  if (made.stoppedPort.empty()) made.stoppedPort = context.names.foreign({skill.name(), "stopped"});
  return synchronise(made.stoppedPort);
}

std::vector<Performed::Result> resultsOf(const SkillPlan& skill) {
  std::vector<Performed::Result> results;
  for (const auto& outcome : outcomesOf(skill))
    results.push_back({outcome.status, std::string(outcome.tag.text), ""});
  return results;
}

std::vector<Signal> signalsOf(const analysis::Program& program, const GenerationPlan& plan) {
  std::vector<Signal> signals;
  for (const auto& skill : plan.skills)
    if (skill.skill().interrupt) signals.push_back({std::string(skill.name()), true, ""});
  for (const auto& event : program.events.all)
    signals.push_back({std::string(event.name()), false, "", event->guard.has_value()});
  return signals;
}

namespace {

void tellEvent(Context& context, Signal& signal, Model& model) {
  const auto& event = *context.program.events.find(signal.name);
  signal.port = context.names.event(event.name());
  if (!event->every) return;
  signal.every = context.times.interval(*event->every);
  signal.everyOrigin = context.origins.of({signal.name, event.file}, event->every->range, "comes");
  if (comesByItself(context, event.node()))
    model.drawnProcesses.push_back(context.names.process({"event", event.name(), "automata"}));
}

void tellSignals(Context& context, Model& model) {
  model.signals = signalsOf(context.program, context.plan);
  for (auto& signal : model.signals)
    if (signal.interrupts)
      signal.port = context.names.interruptPort(signal.name);
    else
      tellEvent(context, signal, model);
}

} // namespace

void tellExecutor(Context& context, Model& model) {
  for (auto& action : context.performed)
    action.numberCell = fiacre::printLvalue(context.cellField(action.skill, "ArgIndex"));
  for (const auto& skill : context.plan.skills) {
    const auto& interval = skill.skill().timeInterval;
    if (!skill.body || !interval) continue;
    model.measured.push_back(
        {std::string(skill.name()), context.names.process({"skill", skill.name()}),
         context.times.interval(*interval),
         context.origins.of(actorOf(skill), interval->range, "takes its time")});
  }
  tellSignals(context, model);
  if (context.plan.mission)
    model.missionProcess = context.names.process({"skill", context.plan.mission->name()});
  if (context.options.environment && context.plan.environment) {
    model.drawnProcesses.push_back(
        context.names.process({"environment", context.plan.environment->name()}));
    model.hasEnvironment = true;
  }
  if (context.options.environment && context.plan.hasGeneralCaller())
    model.drawnProcesses.emplace_back("most_general_caller");
  model.performed = std::move(context.performed);
  model.alarms = std::move(context.alarms);
  model.messages = std::move(context.messages);
}

} // namespace proskill::codegen
