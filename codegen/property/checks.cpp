#include "codegen/property/checks.h"

#include "analysis/program/stop.h"
#include "codegen/plan/flow.h"
#include "codegen/process/body_process.h"
#include "codegen/property/outside_help.h"
#include "codegen/property/properties.h"
#include "codegen/property/statement_names.h"
#include "codegen/term/conditions.h"
#include "syntax/text/quote.h"
#include "syntax/tree/statements.h"

#include <fmt/format.h>

#include <set>

namespace proskill::codegen {
namespace {

using fiacre::Observable;
using fiacre::PatternKind;

fiacre::Pattern absent(Observable observable) {
  fiacre::Pattern pattern;
  pattern.kind = PatternKind::Absent;
  pattern.operands.push_back(std::move(observable));
  return pattern;
}

class Checks {
public:
  Checks(Context& context, Model& model)
      : context(context), model(model), observer(context, model.fiacre) {}

  void add() {
    for (const auto& variable : context.program.stateVariables.all) addStateVariable(variable);
    for (const auto& skill : context.plan.skills) addSkill(skill);
    addProgram();
    addProperties();
  }

  void addProperties() {
    for (const auto& property : context.program.properties.all) addProperty(property);
  }

private:
  // --- State variables

  void addStateVariable(const analysis::Definition<syntax::StateVariable>& variable) {
    const auto process = context.names.process({"sv", variable.name(), "automata"});
    const bool marked = context.alarmed.contains(variable.name());
    auto forbidden = marked ? observer.tag(context.names.tag({variable.name(), "forbidden"}))
                            : observer.state(process, "error");
    begin(variable.name(), {std::string(variable.name()), variable.file}, variable->name.range);
    holds("no_forbidden_transition", "",
          fmt::format("{} makes no forbidden move", syntax::backquoted(variable.name())),
          Weight::Error, absent(std::move(forbidden)));
  }

  // --- Skills

  void addSkill(const SkillPlan& skill) {
    const auto& node = skill.skill();
    begin(skill.name(), actorOf(skill), node.name.range);
    reachable("can_run", "", "can run", tag({skill.name(), "run"}));
    const auto& refused = context.names.tag({skill.name(), "refused"});
    if (skill.root && observer.hasTag(refused))
      holds("never_refused", "",
            syntax::backquoted(subject) + " is not refused when the program starts",
            Weight::Warning, absent(observer.tag(refused)));
    for (const auto& ending : endings(skill)) addEnding(skill, ending);
    for (const auto& invariant : node.invariants) addEnding(skill, failureOf(invariant));
    if (node.interrupt) addEnding(skill, interruptionOf(skill));
    if (!skill.body) return;
    if (skill.isWatched()) addWatchdog(skill);
    const StatementNames names(*skill.body);
    forEachThread(*skill.body,
                  [&](const BodyAutomaton& thread) { addStatements(skill, thread, names); });
  }

  /// The declared outcomes, and success without a tag if the end of the body is reachable.
  static std::vector<Ending> endings(const SkillPlan& skill) {
    auto all = outcomesOf(skill);
    if (skill.body && mayReachEnd(*skill.body)) all.push_back(successOf(skill, {}));
    return all;
  }

  void addEnding(const SkillPlan& skill, const Ending& ending) {
    place = context.origins.of(actorOf(skill), ending.range);
    const auto detail = std::string(ending.tag.text);
    auto happens = tag({skill.name(), ending.status, ending.tag.text});
    const auto with = ending.tag ? " with " + syntax::backquoted(ending.tag.text) : "";
    if (ending.status == "success")
      reachable("can_succeed", detail, "can succeed" + with, std::move(happens));
    else if (ending.status == "failure")
      reachable("can_fail", detail, "can fail" + with, std::move(happens));
    else if (ending.status == "failed_inv")
      reachable("invariant_may_fail", detail,
                fmt::format("can end because its invariant {} fails", syntax::backquoted(detail)),
                std::move(happens));
    else
      reachable("can_be_interrupted", "", "can be interrupted", std::move(happens));
    if (ending.postcondition) addPostcondition(skill, ending);
  }

  void addPostcondition(const SkillPlan& skill, const Ending& ending) {
    place = context.origins.of(actorOf(skill), ending.postcondition->range);
    holds("postcondition", std::string(ending.tag.text),
          fmt::format("the postcondition holds whenever {} {}", syntax::backquoted(subject),
                      ending.description),
          Weight::Warning,
          absent(tag({skill.name(), ending.status, ending.tag.text, "postcondition"})));
  }

  void addWatchdog(const SkillPlan& skill) {
    const auto& interval = *skill.skill().timeInterval;
    const auto process = context.names.process({"skill", skill.name(), "watchdog"});
    place = context.origins.of(actorOf(skill), interval.range);
    if (interval.lower.numerator > 0 || interval.lowerOpen)
      holds("no_undershoot", "",
            fmt::format("{} takes at least {} s from its start", syntax::backquoted(subject),
                        toString(interval.lower)),
            Weight::Error, absent(observer.state(process, "skill_undershoot")));
    if (interval.upper)
      holds("no_overshoot", "",
            fmt::format("{} takes at most {} s from its start", syntax::backquoted(subject),
                        toString(*interval.upper)),
            Weight::Error, absent(observer.state(process, "skill_overshoot")));
  }

  // --- Statements

  void addStatements(const SkillPlan& skill, const BodyAutomaton& thread,
                     const StatementNames& names) {
    const auto process = processOf(context, skill, thread);
    const auto reached = statesOnPaths(thread);
    const auto pointless = refusedArms(thread);
    for (const auto& state : thread.states) {
      if (!state.statement) continue;
      place = context.origins.of(actorOf(skill, thread), state.statement->range);
      const auto& statement = names.of(state.source());
      const auto text = excerpt(skill, state.source());
      if (state.statement->kind == syntax::StatementKind::Call)
        addCall(thread, state, statement, excerpt(skill, *state.statement));
      if (pointless.contains(&state.source()) || isSkippedTest(state, reached)) continue;
      question("reachable", statement, text + " can be reached", Expectation::Reachable,
               Weight::Warning, absent(observer.state(process, state.name)));
    }
  }

  [[nodiscard]] std::string excerpt(const SkillPlan& skill, const syntax::Statement& of) const {
    return syntax::backquoted(context.origins.excerpt(skill.file(), of.range));
  }

  /// The statements in arms for a refusal. `check` demands these arms, and `never_refused` asks
  /// whether they are taken.
  static std::set<const syntax::Statement*> refusedArms(const BodyAutomaton& thread) {
    std::set<const syntax::Statement*> all;
    for (const auto& state : thread.states) {
      if (!state.cases) continue;
      for (const auto& arm : state.cases->arms)
        if (arm.pattern.status.text == "refused")
          syntax::forEachStatement(arm.body, [&](const auto& each) { all.insert(&each); });
    }
    return all;
  }

  /// A `do` has its state at its test. If each round leaves the loop before, nobody has to change
  /// anything.
  static bool isSkippedTest(const BodyState& state, const std::set<std::string_view>& reached) {
    return state.statement->kind == syntax::StatementKind::DoUntil && !reached.contains(state.name);
  }

  /// Asks whether a call is ever refused or finds its skill busy, if that may be so.
  void addCall(const BodyAutomaton& thread, const BodyState& state, const std::string& statement,
               const std::string& text) {
    const auto ask = [&](std::string_view how, std::string_view kind, const std::string& words) {
      const auto& name = context.names.tag({thread.name, state.name, how});
      if (observer.hasTag(name))
        holds(kind, statement, words, Weight::Warning, absent(observer.tag(name)));
    };
    ask("refused", "never_refused", text + " is never refused");
    ask("busy", "never_busy", text + " never finds its skill busy");
  }

  // --- The program

  /// Asks for deadlocks if there is a skill that runs; otherwise the program may stop.
  void addNoDeadlock() {
    fiacre::Pattern deadlock;
    deadlock.kind = PatternKind::DeadlockFree;
    holds("no_deadlock", "", "the program never stops before its mission has ended", Weight::Error,
          std::move(deadlock));
    if (const auto help = alwaysPossible(context); !help.empty())
      model.checks.back().note =
          fmt::format("since {}; whether the mission can always end is the question "
                      "`(always_reachable (ended {}))`",
                      help, context.plan.mission->name());
  }

  void addProgram() {
    const auto* mission = context.plan.mission;
    begin("program", mission ? actorOf(*mission) : Actor{},
          mission ? mission->skill().name.range : syntax::Range{});
    if (!context.plan.skills.empty()) addNoDeadlock();
    fiacre::Pattern progress;
    progress.kind = PatternKind::Progress;
    holds("time_progress", "", "time can always go on", Weight::Error, std::move(progress));
  }

  void addProperty(const analysis::Definition<syntax::Property>& property) {
    begin(property.name(), {std::string(property.name()), property.file}, property->bodyRange);
    const bool asksToReach = property->kind == syntax::PropertyKind::Reachable;
    Check check;
    check.name = unique(std::string(property.name()));
    check.kind = "property";
    check.description = context.origins.excerpt(property.file, property->bodyRange);
    for (const auto& operand : property->operands)
      check.operands.push_back(context.origins.excerpt(property.file, operand.range));
    check.good = asksToReach ? Expectation::Reachable : Expectation::Holds;
    auto pattern = patternOf(context, observer, property.node());
    const bool isEndless = fiacre::isAboutEndlessRuns(pattern);
    check.fair = isEndless && property->fair.value_or(context.options.fairRuns);
    check.rests = isEndless && !check.fair;
    if (check.fair) check.exempt = exemptIn(property.node());
    check.isExecuted = !observer.takeMissing();
    put(std::move(check), std::move(pattern));
  }

  /// What may last for ever in the runs of a property.
  std::set<std::string> exemptIn(const syntax::Property& property) {
    std::set<std::string> exempt;
    if (property.fairSkills.empty()) return exempt;
    for (const auto& [process, of] : model.obliged)
      if (std::ranges::find(property.fairSkills, of.skill, &syntax::Name::text) ==
          property.fairSkills.end())
        exempt.insert(process);
    return exempt;
  }

  // --- Questions

  void begin(std::string_view of, const Actor& actor, syntax::Range range) {
    subject = of;
    place = context.origins.of(actor, range);
  }

  Observable tag(std::initializer_list<std::string_view> parts) {
    return observer.tag(context.names.tag(parts));
  }

  void holds(std::string_view kind, const std::string& detail, std::string words, Weight weight,
             fiacre::Pattern pattern) {
    question(kind, detail, std::move(words), Expectation::Holds, weight, std::move(pattern));
  }

  void reachable(std::string_view kind, const std::string& detail, std::string_view words,
                 Observable observable) {
    question(kind, detail, fmt::format("{} {}", syntax::backquoted(subject), words),
             Expectation::Reachable, Weight::Warning, absent(std::move(observable)));
  }

  void question(std::string_view kind, const std::string& detail, std::string words,
                Expectation good, Weight weight, fiacre::Pattern pattern) {
    Check check;
    check.name = unique(fmt::format("{}.{}{}{}", subject, kind, detail.empty() ? "" : ".", detail));
    check.kind = kind;
    check.description = std::move(words);
    check.good = good;
    check.weight = weight;
    put(std::move(check), std::move(pattern));
  }

  void put(Check check, fiacre::Pattern pattern) {
    analysis::stopIfAsked();
    check.subject = subject;
    check.origin = place;
    check.property = model.fiacre.properties.size();
    fiacre::Property property;
    property.name = context.names.property(sanitised(check.name));
    property.pattern = std::move(pattern);
    property.origin = place;
    property.comment = check.description;
    model.fiacre.properties.push_back(std::move(property));
    model.checks.push_back(std::move(check));
  }

  std::string unique(const std::string& name) {
    if (taken.insert(name).second) return name;
    for (std::size_t i = 2;; ++i)
      if (auto numbered = fmt::format("{}.{}", name, i); taken.insert(numbered).second)
        return numbered;
  }

  Context& context;
  Model& model;
  Observer observer;
  std::set<std::string> taken;
  std::string subject;
  OriginId place = 0;
};

} // namespace

void addChecks(Context& context, Model& model) {
  Checks(context, model).add();
  for (const auto& skill : context.plan.skills) {
    model.running.emplace_back(skill.name(), context.cellField(skill.name(), "inv_active"));
    model.threads.emplace_back(skill.name());
    if (!skill.body) continue;
    forEachThread(*skill.body, [&](const BodyAutomaton& thread) {
      if (!thread.path.empty()) model.threads.push_back(actorOf(skill, thread).name);
    });
  }
}

void addProperties(Context& context, Model& model) { Checks(context, model).addProperties(); }

} // namespace proskill::codegen
