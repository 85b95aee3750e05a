#include "codegen/process/skill_frame.h"

#include "codegen/process/invariants.h"
#include "codegen/term/conditions.h"
#include "codegen/term/effects.h"
#include "codegen/term/grounds.h"

#include <algorithm>

namespace proskill::codegen {
namespace {

/// `failed_success_postcondition_T` for `success_T`.
std::string failedPostcondition(std::string_view state) {
  const auto end = state.find('_');
  std::string result = "failed_" + std::string(state.substr(0, end)) + "_postcondition";
  if (end != std::string_view::npos) result += state.substr(end);
  return result;
}

} // namespace

using fiacre::Expr;
using fiacre::Op;
using fiacre::Statement;

void addState(fiacre::Process& process, std::string_view name, OriginId origin, Statement statement,
              std::string comment) {
  process.states.push_back({std::string(name), origin});
  statement.origin = origin;
  process.transitions.push_back({std::string(name), std::move(statement), std::move(comment)});
}

SkillFrame::SkillFrame(Context& context, const SkillPlan& skill)
    : context(context), skill(skill), actor(actorOf(skill)) {}

// --- Start

void SkillFrame::addStart(fiacre::Process& process, std::string_view first) {
  if (!context.isExpanded()) {
    const auto rest = restingState();
    auto begin = sequence({atOnce(), on(isCalled()), entry(first, rest, rest)});
    return addState(process, "idle", place(), orInterrupted(std::move(begin), rest));
  }
  const auto called = origin(skill.skill().name.range, "is called");
  addState(process, "start_", place(),
           sequence({atOnce(), at(called, on(isCalled())), to("check_precondition")}));
  if (!skill.skill().armed && !isTrue(precondition(context, skill)))
    noteEndState("precondition_unsatisfied", {});
  if (skill.mayBeStopped() || skill.skill().interrupt) noteEndState("interrupted", {});
  auto begin = sequence(
      {atOnce(), entry("precondition_satisfied", "precondition_unsatisfied", "interrupted")});
  addState(process, "check_precondition", place(), orInterrupted(std::move(begin), "interrupted"));
  step(process, "precondition_satisfied", first, "");
}

Expr SkillFrame::isCalled() {
  auto called = negation(equal(cell("caller"), name("None")));
  return skill.shared() ? conjunction({called, negation(cell("returned"))}) : called;
}

/// Whether no failed invariant is pending, the watchdog has seen the last end, and the resources
/// are free.
Expr SkillFrame::isReady() {
  std::vector<Expr> all{negation(someInvariantFails(context))};
  if (skill.isWatchedAgain()) all.push_back(negation(cell("watched")));
  for (const auto& resource : skill.skill().resources) all.push_back(isFree(resource.text));
  return conjunction(std::move(all));
}

Expr SkillFrame::isFree(std::string_view resource) const {
  return binary(Op::Less, name(context.names.used(resource)), number(context.capacity(resource)));
}

/// Notes at the start what a called skill may wait for, and who may have it.
OriginId SkillFrame::waitsOf(OriginId begins) {
  for (const auto& resource : skill.skill().resources) {
    waitsFor(context, begins, isFree(resource.text),
             "the resource `" + std::string(resource.text) + "`", resource.text);
    for (const auto& other : context.plan.skills)
      if (std::ranges::find(other.skill().resources, resource.text, &syntax::Name::text) !=
          other.skill().resources.end())
        heldBy(context, begins, context.cellField(other.name(), "inv_active"), other.name(),
               resource.text);
  }
  if (!skill.skill().armed) return begins;
  for (const auto& each : skill.skill().preconditions)
    waitsFor(context, begins, condition(context, each.condition), quote(each.condition.range));
  return begins;
}

/// An interrupt from outside also ends a call that has not started.
Statement SkillFrame::orInterrupted(Statement entry, std::string_view stopped) {
  if (!skill.skill().interrupt) return entry;
  auto outside =
      sequence({context.isExpanded() ? sequence({}) : on(isCalled()),
                synchronise(context.names.interruptPort(skill.name())), interruptEarly(stopped)});
  return select({std::move(entry), std::move(outside)});
}

/// The transition from the call to the run, or back.
Statement SkillFrame::entry(std::string_view satisfied, std::string_view refused,
                            std::string_view stopped) {
  auto holds = precondition(context, skill);
  auto begin = skill.skill().armed
                   ? sequence({on(conjunction({isReady(), std::move(holds)})), start(satisfied)})
                   : sequence({on(isReady()),
                               ifThenElse(std::move(holds), start(satisfied), refuse(refused))});
  if (!skill.mayBeStopped()) return begin;
  return ifThenElse(stop(), stopEarly(stopped), std::move(begin));
}

Statement SkillFrame::start(std::string_view next) {
  const auto& node = skill.skill();
  const auto begins = causedBy(context, origin(node.name.range, "starts"), isCalled());
  std::vector<Statement> all{at(waitsOf(begins), tag(context.names.tag({skill.name(), "run"}))),
                             changeResources(Op::Add), effects(context, actor, node.start),
                             assign(cell("inv_active"), boolean(true))};
  if (skill.isWatchedAgain()) all.push_back(assign(cell("watched"), boolean(true)));
  all.push_back(to(next));
  return sequence(std::move(all));
}

Statement SkillFrame::refuse(std::string_view next) {
  const auto& all = skill.skill().preconditions;
  const syntax::Range range = all.empty()
                                  ? skill.skill().name.range
                                  : syntax::Range{all.front().range.begin, all.back().range.end};
  const auto words = origin(range, "is refused because of its precondition");
  for (const auto& each : all)
    decidedBy(context, words, condition(context, each.condition), false, quote(each.range));
  return sequence({at(words, refusal()), returnControl(), to(next)});
}

/// Marks the refusal of a skill that nobody calls, such as the mission: no caller would notice it.
Statement SkillFrame::refusal() {
  if (!skill.root || isTrue(precondition(context, skill))) return sequence({});
  auto refused = tag(context.names.tag({skill.name(), "refused"}));
  if (skill.startsItself()) return refused;
  return ifThen(equal(cell("caller"), name("root")), std::move(refused));
}

Statement SkillFrame::stopEarly(std::string_view next) {
  return returnInterrupted("is stopped before it starts", next);
}

Statement SkillFrame::interruptEarly(std::string_view next) {
  return returnInterrupted("is interrupted from outside before it starts", next);
}

/// Returns without the effects of `:interrupt`, since the skill has not run.
Statement SkillFrame::returnInterrupted(std::string_view words, std::string_view next) {
  std::vector<Statement> all;
  if (skill.skill().interrupt)
    all.push_back(tag(context.names.tag({skill.name(), "interrupted", ""})));
  if (skill.mayBeStopped()) all.push_back(assign(stop(), boolean(false)));
  all.push_back(
      at(origin(skill.skill().name.range, words), assign(cell("status"), name("interrupted"))));
  all.push_back(returnControl());
  all.push_back(to(next));
  return sequence(std::move(all));
}

// --- End

Statement SkillFrame::end(const Ending& ending) {
  if (!context.isExpanded()) return sequence({outcome(ending), giveBack(), to(restingState())});
  const auto state = stateAfter(ending);
  noteEndState(state, ending);
  return sequence({outcome(ending), giveBack(), to(state)});
}

Statement SkillFrame::outcome(const Ending& ending) {
  std::vector<Statement> all{happens(ending)};
  if (ending.postcondition) all.push_back(checkPostcondition(ending));
  all.push_back(report(ending));
  return sequence(std::move(all));
}

Statement SkillFrame::happens(const Ending& ending) {
  const auto& name = context.names.tag({skill.name(), ending.status, ending.tag.text});
  const auto words = groundsOf(ending);
  Statement marked = at(words, tag(name));
  if (!ending.effects) return marked;
  return sequence({std::move(marked), effects(context, actor, *ending.effects)});
}

/// The grounds of an ending: a basic skill notices a failed invariant or a stop request in the same
/// transition.
OriginId SkillFrame::groundsOf(const Ending& ending) {
  const auto words = origin(ending.range, ending.description);
  if (ending.status == "failed_inv") {
    for (const auto& invariant : skill.skill().invariants)
      if (invariant.tag.text == ending.tag.text) failsAt(words, invariant);
    if (!ending.wasNoticed) context.alarms.emplace(words, Alarm::FailedInvariant);
  }
  if (ending.status == "interrupted" && skill.mayBeStopped()) causedBy(context, words, stop());
  return words;
}

OriginId SkillFrame::failsAt(OriginId words, const syntax::Invariant& invariant) {
  return decidedBy(context, words, condition(context, invariant.guard), false,
                   quote(invariant.guard.range));
}

std::string SkillFrame::quote(syntax::Range range) const {
  return "`" + context.origins.excerpt(actor.file, range) + "`";
}

/// Marks a failed postcondition by a tag in the transition of the outcome itself. The expanded
/// edition stores the test's value for the next state: Fiacre's compiler makes a separate
/// transition of a tag after a test. That transition would have a clock of its own, which a
/// transition with a time must not have.
Statement SkillFrame::checkPostcondition(const Ending& ending) {
  auto broken = negation(condition(context, *ending.postcondition));
  if (context.isExpanded()) return assign(name("broken"), std::move(broken));
  return ifThen(std::move(broken), postconditionFails(ending));
}

Statement SkillFrame::postconditionFails(const Ending& ending) {
  const auto words = ending.description + ", but its postcondition does not hold";
  const auto& mark =
      context.names.tag({skill.name(), ending.status, ending.tag.text, "postcondition"});
  const auto place = falseAfterwards(context, origin(ending.postcondition->range, words),
                                     condition(context, *ending.postcondition),
                                     quote(ending.postcondition->range));
  context.alarms.emplace(place, Alarm::FailedPostcondition);
  return at(place, tag(mark));
}

Statement SkillFrame::report(const Ending& ending) {
  return sequence(
      {setResult(ending.status, ending.tag.text), assign(cell("status"), name(ending.status))});
}

/// Sets `val` if something reads it. Without a tag there is no result.
Statement SkillFrame::setResult(std::string_view status, std::string_view tag) {
  if (!skill.resultIsRead) return sequence({});
  return assign(cell("val"),
                tag.empty() ? name("no_result") : context.result(skill.name(), status, tag));
}

Statement SkillFrame::giveBack() {
  std::vector<Statement> all{assign(cell("inv_active"), boolean(false))};
  if (skill.mayBeStopped()) all.push_back(assign(stop(), boolean(false)));
  if (skill.mayLinger()) all.push_back(assign(cell("ending"), boolean(false)));
  all.push_back(changeResources(Op::Subtract));
  all.push_back(returnControl());
  return sequence(std::move(all));
}

/// A skill with several callers stays busy until its caller has seen the return, so that nobody
/// else can change its status meanwhile.
Statement SkillFrame::returnControl() {
  auto free = assign(cell("caller"), name("None"));
  if (!skill.shared()) return free;
  auto returned = assign(cell("returned"), boolean(true));
  if (!skill.root && !skill.generalCaller) return returned;
  return ifThenElse(equal(cell("caller"), name("root")), std::move(free), std::move(returned));
}

Statement SkillFrame::changeResources(Op op) {
  std::vector<Statement> all;
  for (const auto& resource : skill.skill().resources) {
    const auto& used = context.names.used(resource.text);
    all.push_back(assign(name(used), binary(op, name(used), number(1))));
  }
  return sequence(std::move(all));
}

// --- After the end

std::string SkillFrame::restingState() const {
  if (skill.startsItself()) return "ended";
  return context.isExpanded() ? "start_" : "idle";
}

std::string SkillFrame::stateAfter(const Ending& ending) {
  if (ending.status == "interrupted") return "interrupted";
  if (ending.status == "failed_inv") return "failed_invariant";
  return ending.status + (ending.tag ? "_" + std::string(ending.tag.text) : "");
}

void SkillFrame::addRest(fiacre::Process& process, std::string_view start) {
  if (context.isExpanded()) {
    addEndStates(process);
    step(process, "done", skill.startsItself() ? "ended" : "ether", "Control was returned.");
    if (!skill.startsItself()) step(process, "ether", start, "");
  }
  if (skill.startsItself()) addEnded(process, context.isExpanded() ? start : "idle");
}

void SkillFrame::addEnded(fiacre::Process& process, std::string_view start) {
  std::vector<Statement> all;
  if (skill.rearms()) all.push_back(rearm(start));
  // once the mission has ended, nothing more is required of the program, so this is not a deadlock
  const bool ends = &skill == context.plan.mission || !context.plan.mission;
  if (ends && !context.isPerformed()) all.push_back(sequence({wait({}), stay()}));
  if (all.empty()) return process.states.push_back({"ended", place()});
  const auto* words = skill.rearms()
                          ? "Waits until the precondition is false, and then for it again."
                          : "The end. The loop distinguishes it from a deadlock.";
  addState(process, "ended", place(), select(std::move(all)), words);
}

/// As at the start of the program, once the precondition does not hold.
Statement SkillFrame::rearm(std::string_view start) {
  auto words = origin(skill.skill().name.range, "waits for its precondition again");
  auto waits = negation(precondition(context, skill));
  for (const auto& each : skill.skill().preconditions)
    decidedBy(context, words, condition(context, each.condition), false, quote(each.range));
  return sequence({atOnce(), on(std::move(waits)), at(words, assign(cell("caller"), name("root"))),
                   assign(cell("status"), name("no_status")), setResult("no_status", ""),
                   to(start)});
}

void SkillFrame::noteEndState(const std::string& state, const Ending& ending) {
  if (std::ranges::find(endStates, state, &std::pair<std::string, Ending>::first) ==
      endStates.end())
    endStates.emplace_back(state, ending);
}

void SkillFrame::addEndStates(fiacre::Process& process) {
  bool checks = false;
  for (const auto& [state, ending] : endStates) {
    if (!ending.postcondition) {
      step(process, state, "done", "");
      continue;
    }
    checks = true;
    const auto broken = failedPostcondition(state);
    auto fail = sequence({postconditionFails(ending), to(broken)});
    addState(process, state, place(),
             sequence({atOnce(), ifThenElse(name("broken"), std::move(fail), to("done"))}));
    step(process, broken, "done", "");
  }
  if (checks)
    process.variables.push_back(
        {"broken", boolType(), boolean(false), "the postcondition did not hold"});
}

void SkillFrame::step(fiacre::Process& process, std::string_view from, std::string_view next,
                      std::string_view comment) {
  addState(process, from, place(), sequence({atOnce(), to(next)}), std::string(comment));
}

Expr SkillFrame::fails(const syntax::Invariant& invariant) {
  return negation(condition(context, invariant.guard));
}

} // namespace proskill::codegen
