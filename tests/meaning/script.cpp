#include "tests/meaning/script.h"

#include "tests/meaning/inputs.h"

#include "syntax/tree/statements.h"

#include <algorithm>
#include <numeric>

namespace proskill::meaning {
namespace {

using syntax::Block;
using syntax::Statement;
using syntax::StatementKind;

template <class Nodes> int indexOf(const Nodes& nodes, std::string_view name) {
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i]->name.text == name) return static_cast<int>(i);
  return kNobody;
}

/// Places statements from the end of a body to its beginning, so that successors are known.
class Layout {
public:
  Layout(Script& made, int number) : script(made), me(number) {}

  void lay(const Block& body) {
    const int end = add(nullptr, 0);
    const int entry = block(body, end, end);
    auto& thread = script.threads[me];
    thread.entry = entry;
    for (auto& place : thread.places)
      if (place.statement && place.statement->kind == StatementKind::Goto)
        place.next = thread.labels.at(place.statement->name.text);
  }

private:
  int add(const Statement* statement, int next) {
    auto& places = script.threads[me].places;
    places.push_back({.statement = statement, .next = next});
    return static_cast<int>(places.size()) - 1;
  }

  int block(const Block& statements, int next, int afterLoop) {
    for (std::size_t i = statements.statements.size(); i-- > 0;) {
      const auto& statement = statements.statements[i];
      if (statement.kind == StatementKind::Label)
        script.threads[me].labels[statement.name.text] = next;
      else
        next = place(statement, next, afterLoop);
    }
    return next;
  }

  int place(const Statement& statement, int next, int afterLoop) {
    const int here = add(&statement, statement.kind == StatementKind::Break ? afterLoop : next);
    std::vector<int> targets;
    std::vector<int> branches;
    switch (statement.kind) {
    case StatementKind::If:
    case StatementKind::Case:
      for (const auto& arm : statement.arms) targets.push_back(block(arm.body, next, afterLoop));
      break;
    case StatementKind::While:
    case StatementKind::DoUntil: targets = {block(statement.branches[0], here, next)}; break;
    case StatementKind::WaitCondition:
    case StatementKind::Choose:
      for (const auto& each : statement.branches) targets.push_back(block(each, next, afterLoop));
      break;
    case StatementKind::Parallel:
    case StatementKind::Race:
      for (const auto& each : statement.branches) branches.push_back(branch(each));
      break;
    case StatementKind::Call: break;
    default: break;
    }
    if (statement.kind == StatementKind::Race) letCompete(branches);
    auto& made = script.threads[me].places[here];
    made.call = callOf(statement);
    if (made.call) noteCall(*made.call);
    made.targets = targets;
    made.branches = branches;
    return statement.kind == StatementKind::DoUntil ? targets[0] : here;
  }

  static const Statement* callOf(const Statement& statement) {
    if (statement.kind == StatementKind::Call) return &statement;
    const bool isCase = statement.kind == StatementKind::Case;
    return isCase ? &statement.branches[0].statements[0] : nullptr;
  }

  void letCompete(const std::vector<int>& branches) {
    for (const int each : branches)
      for (const int other : branches)
        if (other != each) script.threads[each].rivals.push_back(other);
  }

  int branch(const Block& body) {
    const int number = static_cast<int>(script.threads.size());
    auto& thread = script.threads.emplace_back();
    thread.skill = script.threads[me].skill;
    thread.parent = me;
    Layout(script, number).lay(body);
    return number;
  }

  void noteCall(const Statement& statement) {
    const int callee = script.skill(statement.head.text);
    script.threads[me].calls.insert(callee);
    script.skills[callee].callers.insert(me);
  }

  Script& script;
  int me;
};

class Reader {
public:
  explicit Reader(const analysis::Program& from) : program(from) { script.program = &from; }

  std::optional<Script> read() {
    for (const auto& each : program.stateVariables.all) script.variables.push_back(&each.node());
    for (const auto& each : program.events.all) script.events.push_back(&each.node());
    for (const auto& each : program.resources.all) script.resources.push_back(&each.node());
    const auto main = analysis::mainSkill(program);
    if (!main.skill && main.candidates.size() > 1) return std::nullopt;
    addSkills(main.skill ? main.skill->name() : std::string_view{});
    for (std::size_t i = 0; i < script.skills.size(); ++i)
      if (const auto& body = script.skills[i].node->body)
        script.skills[i].body = addThread(*body, static_cast<int>(i));
    if (!program.environments.all.empty())
      script.environment = addThread(program.environments.all[0]->body, kNobody);
    chooseUnit();
    findHoldOuts();
    findInputs(script);
    return std::move(script);
  }

private:
  void addSkills(std::string_view mission) {
    for (const auto& each : program.skills.all)
      if (each->isComposite() && (each->monitor || each.name() == mission)) runs(each.node());
    for (const auto& each : program.skills.all) {
      if (each->isComposite() && !running.contains(each.name())) continue;
      auto& entry = script.skills.emplace_back();
      entry.node = &each.node();
      entry.root = each->isComposite() && (each->monitor || each.name() == mission);
      entry.calledByAnyone = mission.empty() && !each->isComposite();
      if (each.name() == mission) script.mission = static_cast<int>(script.skills.size()) - 1;
    }
  }

  void runs(const syntax::Skill& skill) {
    if (!skill.isComposite() || !running.insert(skill.name.text).second) return;
    syntax::forEachStatement(*skill.body, [&](const Statement& statement) {
      if (statement.kind == StatementKind::Call)
        runs(program.skills.find(statement.head.text)->node());
    });
  }

  int addThread(const Block& body, int skill) {
    const int number = static_cast<int>(script.threads.size());
    script.threads.emplace_back().skill = skill;
    Layout(script, number).lay(body);
    return number;
  }

  void note(const syntax::Interval& interval) {
    note(interval.lower);
    if (interval.upper) note(*interval.upper);
  }
  void note(const syntax::Rational& seconds) {
    script.unitsPerSecond = std::lcm(script.unitsPerSecond, seconds.denominator);
  }

  void chooseUnit() {
    for (const auto& skill : script.skills)
      if (skill.node->timeInterval) note(*skill.node->timeInterval);
    for (const auto* event : script.events)
      if (event->every) note(*event->every);
    for (const auto& thread : script.threads)
      for (const auto& place : thread.places)
        if (place.statement && waitsForTime(*place.statement)) note(place.statement->duration);
    for (const auto& property : program.properties.all) {
      for (const auto& interval : {property->within, property->forDuration})
        if (interval) note(*interval);
      if (property->lasting) note(property->lasting->number);
    }
  }

  /// Marks skills that must not be stopped while they run, and their callers, transitively.
  void findHoldOuts() {
    for (auto& skill : script.skills) skill.holdsOut = skill.node->unstoppable;
    for (std::size_t rounds = script.threads.size(); rounds-- > 0;)
      for (auto& thread : script.threads) {
        for (const int callee : thread.calls) thread.holdsOut |= script.skills[callee].holdsOut;
        if (!thread.holdsOut || thread.skill == kNobody) continue;
        if (thread.isBranch())
          script.threads[thread.parent].holdsOut = true;
        else
          script.skills[thread.skill].holdsOut = true;
      }
  }

  const analysis::Program& program;
  Script script;
  std::set<std::string_view> running;
};

} // namespace

bool waitsForTime(const Statement& statement) {
  const bool hasTimeout =
      statement.kind == StatementKind::WaitCondition && !statement.branches.empty();
  return statement.kind == StatementKind::WaitTime || hasTimeout;
}

int Script::skill(std::string_view name) const {
  for (std::size_t i = 0; i < skills.size(); ++i)
    if (skills[i].node->name.text == name) return static_cast<int>(i);
  return kNobody;
}

int Script::variable(std::string_view name) const { return indexOf(variables, name); }
int Script::event(std::string_view name) const { return indexOf(events, name); }

std::optional<Script> scriptOf(const analysis::Program& program) { return Reader(program).read(); }

} // namespace proskill::meaning
