#include "codegen/process/runtime_action.h"

#include <fmt/format.h>

namespace proskill::codegen {
namespace {

using fiacre::Statement;

const std::string& taskOf(Context& context, std::string_view skill) {
  return context.names.foreign({"Fiacre", skill, "action_task"});
}

const std::string& interruptionCall(Context& context, std::string_view skill) {
  return context.names.foreign({"Fiacre", skill, "interrupt_action"});
}

} // namespace

RuntimeAction::RuntimeAction(Context& context, const SkillPlan& skill, SkillFrame& frame)
    : context(context), skill(skill), frame(frame), task(taskOf(context, skill.name())) {
  if (!skill.skill().timeInterval) return;
  const auto ticks = context.times.interval(*skill.skill().timeInterval);
  const auto first = ticks.lower + (ticks.lowerOpen ? 1 : 0);
  if (first > 0) least = first;
  if (ticks.upper) late = *ticks.upper + (ticks.upperOpen ? 0 : 1);
}

void RuntimeAction::addTo(fiacre::Process& process) {
  process.variables = {{"ret_val", namedType("skill_result"), name("no_result"), ""},
                       {"ignoreb", boolType(), boolean(false), ""}};
  if (least) process.variables.push_back({"undershoot", boolType(), boolean(false), ""});
  if (late) process.variables.push_back({"overshoot", boolType(), boolean(false), ""});
  frame.addStart(process, "action");

  Statement start;
  start.kind = fiacre::StatementKind::Start;
  start.name = task;
  start.values.push_back(element(name("skill"), name(context.names.cell(skill.name()))));
  std::vector<Statement> action; // without a wait: tasks start when they are idle
  if (late) action.push_back(assign(name("overshoot"), boolean(false)));
  if (least) action.push_back(assign(name("undershoot"), boolean(true)));
  action.push_back(at(frame.origin(skill.skill().name.range, "starts its action"), start));
  action.push_back(to("action_sync"));
  addState(process, "action", frame.place(), sequence(std::move(action)));

  addState(process, "action_sync", frame.place(), select(alternatives()));
  if (late)
    addState(process, "action_sync_overshoot", frame.place(),
             sequence({atOnce(), assign(name("overshoot"), boolean(true)), to("action_sync")}));
  if (least)
    addState(process, "action_sync_not_undershoot", frame.place(),
             sequence({atOnce(), assign(name("undershoot"), boolean(false)), to("action_sync")}));
  addDispatch(process);
  addStopping(process);
  frame.addRest(process);
}

std::vector<Statement> RuntimeAction::alternatives() {
  const auto& node = skill.skill();
  std::vector<Statement> all{returned()};
  addTiming(all);
  for (const auto& invariant : node.invariants)
    all.push_back(sequence({atOnce(), on(frame.fails(invariant)), breakOff(failureOf(invariant))}));
  if (node.interrupt)
    all.push_back(sequence(
        {synchronise(context.names.interruptPort(skill.name())), breakOff(interruptionOf(skill))}));
  if (skill.obeysStops())
    all.push_back(sequence({atOnce(), on(frame.stop()), breakOff(interruptionOf(skill))}));
  return all;
}

Statement RuntimeAction::returned() {
  if (!least) return sequence({awaitTask(), to("action_dispatch")});
  const auto words =
      frame.origin(skill.skill().timeInterval->range, "its action returns too early");
  auto warning = ifThen(name("undershoot"),
                        at(words, saying("WARNING: undershoot",
                                         tag(context.names.tag({skill.name(), "undershoot"})))));
  return sequence({awaitTask(), std::move(warning), to("action_dispatch")});
}

/// Waits for the task's result, and branches on it.
Statement RuntimeAction::awaitTask() {
  Statement sync;
  sync.kind = fiacre::StatementKind::Sync;
  sync.name = task;
  sync.targets.push_back(name("ret_val"));
  sync.origin = frame.origin(skill.skill().name.range, "its action returns");
  return sync;
}

/// Adds the lower bound, then the upper one. As in the paper, leaving `action_sync` restarts the
/// clocks.
void RuntimeAction::addTiming(std::vector<Statement>& all) {
  if (least)
    all.push_back(sequence({on(name("undershoot")), wait({.lower = *least, .upper = *least}),
                            to("action_sync_not_undershoot")}));
  if (!late) return;
  const auto rest = *late - least.value_or(0);
  auto isOpen = negation(name("overshoot"));
  if (least) isOpen = conjunction({negation(name("undershoot")), std::move(isOpen)});
  const auto words = frame.origin(skill.skill().timeInterval->range, "its action takes too long");
  all.push_back(sequence(
      {on(std::move(isOpen)), wait({.lower = rest, .upper = rest}),
       at(words, saying("WARNING: overshoot", tag(context.names.tag({skill.name(), "overshoot"})))),
       to("action_sync_overshoot")}));
}

/// Asks the platform to stop. The skill keeps its resources until its task has returned.
Statement RuntimeAction::breakOff(const Ending& ending) {
  const auto state =
      "stopping_" + ending.status + (ending.tag ? "_" + std::string(ending.tag.text) : "");
  stopping.emplace(state, ending);
  return sequence(
      {assign(name("ignoreb"), call(interruptionCall(context, skill.name()), {})),
       at(frame.origin(skill.skill().name.range, "asks its action to stop"), to(state))});
}

/// Waits for the task to return; its result is ignored.
void RuntimeAction::addStopping(fiacre::Process& process) {
  for (const auto& [state, ending] : stopping) {
    addState(process, state, frame.place(), sequence({awaitTask(), frame.end(ending)}),
             "The action was asked to stop.");
  }
}

/// Maps the task's result to the outcome. Any other result is an error.
void RuntimeAction::addDispatch(fiacre::Process& process) {
  auto outcomes = outcomesOf(skill);
  outcomes.push_back(interruptionOf(skill));
  auto chain = to("error");
  for (auto outcome = outcomes.rbegin(); outcome != outcomes.rend(); ++outcome)
    chain = ifThenElse(
        equal(name("ret_val"), context.result(skill.name(), outcome->status, outcome->tag.text)),
        frame.end(*outcome), std::move(chain));
  addState(process, "action_dispatch", frame.place(), sequence({atOnce(), std::move(chain)}));
  const auto words = frame.origin(skill.skill().name.range, "its action returns an unknown result");
  addState(process, "error", frame.place(),
           sequence({atOnce(), at(words, tag(context.names.tag({skill.name(), "unknown_result"}))),
                     frame.end(interruptionOf(skill))}),
           "Not a result of the skill.");
}

void declareActions(Context& context, fiacre::Program& program) {
  for (const auto& skill : context.plan.skills) {
    if (skill.body) continue;
    program.tasks.push_back({taskOf(context, skill.name()),
                             {namedType("skill_record")},
                             namedType("skill_result"),
                             context.names.foreign({skill.name(), "action"})});
    const auto& node = skill.skill();
    if (node.interrupt || skill.obeysStops() || !node.invariants.empty())
      program.externs.push_back({interruptionCall(context, skill.name()),
                                 {},
                                 boolType(),
                                 context.names.foreign({skill.name(), "interrupt_action"})});
  }
}

} // namespace proskill::codegen
