#include "codegen/property/observe.h"

#include "codegen/process/body_process.h"
#include "codegen/process/state_variables.h"
#include "codegen/term/conditions.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace proskill::codegen {
namespace {

using fiacre::Observable;
using fiacre::ObservableKind;
using syntax::ExprKind;

template <class Visit> void forEachTag(const fiacre::Statement& statement, Visit&& visit) {
  if (statement.kind == fiacre::StatementKind::Tag) visit(statement.name);
  for (const auto& child : statement.children) forEachTag(child, visit);
}

/// Whether it consists of conditions only, without atoms of properties.
bool isPlain(const syntax::Expr& expr) {
  constexpr std::array kAtoms{ExprKind::Running, ExprKind::Called, ExprKind::Ended,
                              ExprKind::Occurs, ExprKind::At};
  return std::ranges::find(kAtoms, expr.kind) == kAtoms.end() &&
         std::ranges::all_of(expr.operands, isPlain);
}

/// Any of these; false if there are none.
Observable anyOf(std::vector<Observable> operands) {
  if (operands.empty()) return Observer::value(boolean(false));
  if (operands.size() == 1) return std::move(operands[0]);
  Observable any;
  any.kind = ObservableKind::Or;
  any.operands = std::move(operands);
  return any;
}

} // namespace

Observer::Observer(Context& context, const fiacre::Program& program)
    : context(context), places(placesOf(program)) {
  for (const auto& process : program.processes)
    for (const auto& from : process.transitions)
      forEachTag(from.statement, [&](const std::string& tag) {
        tags[tag].insert(places.find(process.name)->second);
      });
}

Observable Observer::state(std::string_view process, std::string_view state) const {
  Observable observable;
  observable.kind = ObservableKind::State;
  observable.path = {places.find(process)->second};
  observable.name = state;
  return observable;
}

std::optional<Observable> Observer::begun() const {
  if (!context.hasInitialChoice()) return std::nullopt;
  return state(context.names.process({"initial", "values"}), kChosen);
}

Observable Observer::tag(const std::string& tag) const {
  std::vector<Observable> all;
  if (const auto found = tags.find(tag); found != tags.end())
    for (const auto place : found->second) {
      auto& observable = all.emplace_back();
      observable.kind = ObservableKind::Tag;
      observable.path = {place};
      observable.name = tag;
    }
  return anyOf(std::move(all));
}

Observable Observer::value(fiacre::Expr condition) {
  Observable observable;
  observable.kind = ObservableKind::Value;
  observable.value = std::move(condition);
  return observable;
}

Observable Observer::condition(const syntax::Expr& expr) {
  if (isPlain(expr)) return value(codegen::condition(context, expr));
  switch (expr.kind) {
  case ExprKind::And: return compound(ObservableKind::And, expr);
  case ExprKind::Or: return compound(ObservableKind::Or, expr);
  case ExprKind::Not: return compound(ObservableKind::Not, expr);
  case ExprKind::Implies: return compound(ObservableKind::Implies, expr);
  case ExprKind::Equivalent: return bothWays(expr);
  case ExprKind::Running: return running(expr.name.text);
  case ExprKind::Called: return called(expr.name.text);
  case ExprKind::Ended: return ended(expr);
  case ExprKind::At: return atLabel(expr.name.text);
  case ExprKind::Occurs: return event(expr.name.text);
  case ExprKind::Missing:
  case ExprKind::True:
  case ExprKind::False:
  case ExprKind::Number:
  case ExprKind::Symbol:
  case ExprKind::String:
  case ExprKind::Parameter:
  case ExprKind::Access:
  case ExprKind::Test:
  case ExprKind::Equal:
  case ExprKind::NotEqual:
  case ExprKind::Less:
  case ExprKind::LessEqual:
  case ExprKind::Greater:
  case ExprKind::GreaterEqual:
  case ExprKind::Add:
  case ExprKind::Subtract:
  case ExprKind::Value:
  case ExprKind::Globally:
  case ExprKind::Finally:
  case ExprKind::Next:
  case ExprKind::Until:
  case ExprKind::WeakUntil:
  case ExprKind::Release:
  case ExprKind::StrongRelease: break;
  }
  assert(false && "not a condition of a property");
  return value(boolean(false));
}

Observable Observer::event(std::string_view name) const {
  Observable observable;
  observable.kind = ObservableKind::Event;
  observable.name = context.names.event(name);
  return observable;
}

Observable Observer::bothWays(const syntax::Expr& equivalence) {
  const auto& a = equivalence.operands[0];
  const auto& b = equivalence.operands[1];
  const auto implies = [this](const syntax::Expr& from, const syntax::Expr& to) {
    Observable one;
    one.kind = ObservableKind::Implies;
    one.operands = {condition(from), condition(to)};
    return one;
  };
  Observable both;
  both.kind = ObservableKind::And;
  both.operands = {implies(a, b), implies(b, a)};
  return both;
}

Observable Observer::compound(ObservableKind kind, const syntax::Expr& expr) {
  Observable observable;
  observable.kind = kind;
  for (const auto& operand : expr.operands) observable.operands.push_back(condition(operand));
  return observable;
}

Observable Observer::running(std::string_view skill) const {
  if (!context.plan.find(skill)) return value(boolean(false));
  return value(context.cellField(skill, "inv_active"));
}

Observable Observer::called(std::string_view skill) const {
  if (!context.plan.find(skill)) return value(boolean(false));
  return value(negation(equal(context.cellField(skill, "caller"), name("None"))));
}

/// The skill's last call has ended with this status, or with any.
Observable Observer::ended(const syntax::Expr& expr) const {
  const auto skill = expr.name.text;
  if (!context.plan.find(skill)) return value(boolean(false));
  const auto status = context.cellField(skill, "status");
  auto isOver = expr.member ? equal(status, name(expr.member.text))
                            : negation(equal(status, name("no_status")));
  return value(
      conjunction({equal(context.cellField(skill, "caller"), name("None")), std::move(isOver)}));
}

/// Control is before or in the statement after the label.
Observable Observer::atLabel(std::string_view label) {
  std::vector<Observable> found;
  for (const auto& skill : context.plan.skills) {
    if (!skill.body) continue;
    forEachThread(*skill.body, [&](const BodyAutomaton& thread) {
      addStatesAt(found, thread, processOf(context, skill, thread), label);
    });
  }
  if (context.plan.environmentBody)
    addStatesAt(found, *context.plan.environmentBody,
                context.names.process({"environment", context.plan.environment->name()}), label);
  return anyOf(std::move(found));
}

void Observer::addStatesAt(std::vector<Observable>& found, const BodyAutomaton& thread,
                           std::string_view process, std::string_view label) {
  const auto entry = thread.labels.find(label);
  if (entry == thread.labels.end()) return;
  if (!places.contains(process)) { // the environment, if it is not executed
    isMissing = true;
    return;
  }
  const auto at = std::ranges::find(thread.states, entry->second, &BodyState::name);
  if (at == thread.states.end()) return; // the end is unreachable
  for (const auto& name : statesOf(context, *at)) found.push_back(state(process, name));
}

} // namespace proskill::codegen
