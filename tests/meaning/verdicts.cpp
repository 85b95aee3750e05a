#include "tests/meaning/verdicts.h"

#include "tests/meaning/endless/fairness.h"
#include "tests/meaning/endless/ltl.h"
#include "tests/meaning/timed/duration.h"
#include "tests/meaning/timed/pattern.h"

#include <algorithm>
#include <functional>

namespace proskill::meaning {

using syntax::ExprKind;
using syntax::PropertyKind;

namespace {

const std::map<std::string_view, What>& kinds() {
  static const std::map<std::string_view, What> all{
      {"can_run", What::Runs},
      {"can_succeed", What::Succeeds},
      {"can_fail", What::Fails},
      {"invariant_may_fail", What::InvariantFails},
      {"can_be_interrupted", What::IsInterrupted},
      {"postcondition", What::PostconditionFails},
      {"never_busy", What::CallBusy},
      {"reachable", What::Reached},
      {"no_undershoot", What::Undershoot},
      {"no_overshoot", What::Overshoot},
  };
  return all;
}

} // namespace

std::optional<Fact> Verdicts::factOf(const codegen::Check& check,
                                     const fiacre::Origin& place) const {
  if (check.kind == "no_forbidden_transition")
    return Fact{What::Forbidden, script.variable(check.subject), 0};
  const int skill = script.skill(check.subject);
  const bool ofCall = place.begin != script.skills[skill].node->name.range.begin;
  if (check.kind == "never_refused")
    return ofCall ? Fact{What::CallRefused, skill, place.begin} : Fact{What::Refused, skill, 0};
  const auto found = kinds().find(check.kind);
  if (found == kinds().end()) return std::nullopt;
  return Fact{found->second, skill, place.begin};
}

std::optional<bool> Verdicts::isTrue(const codegen::Check& check,
                                     const fiacre::Origin& place) const {
  if (check.kind == "no_deadlock") return !runs.canStop();
  if (check.kind == "time_progress") return runs.timeCanGoOn();
  if (check.kind == "property")
    return isTrue(script.program->properties.find(check.subject)->node());
  const auto fact = factOf(check, place);
  if (!fact) return std::nullopt;
  return !runs.facts().contains(*fact);
}

std::optional<bool> Verdicts::isTrue(const syntax::Property& property) const {
  if (hasScopeOrTime(property))
    return isTrueInTime(property, script,
                        [this](const auto& wish, const auto& now, const auto& facts) {
                          return isTrueAt(wish, now, facts);
                        });
  switch (property.kind) {
  case PropertyKind::Always: return !sometimes(property.operands[0], false);
  case PropertyKind::Never:
  case PropertyKind::Absent:
  case PropertyKind::Reachable: return !sometimes(property.operands[0], true);
  case PropertyKind::Present: {
    const auto without = avoiding(property, property.operands[0]);
    return std::ranges::none_of(runs.starts(), [&](auto node) { return without[node]; });
  }
  case PropertyKind::InfinitelyOften:
    return std::ranges::none_of(avoiding(property, property.operands[0]), std::identity{});
  case PropertyKind::LeadsTo: return !canMiss(property);
  case PropertyKind::Precedes: return !canPrecede(property.operands[1], property.operands[0]);
  case PropertyKind::DeadlockFree: return !runs.canStop();
  case PropertyKind::Ltl:
    return holdsInRuns(property, script, runs,
                       [this](const auto& wish, const auto& now, const auto& facts) {
                         return isTrueAt(wish, now, facts);
                       });
  case PropertyKind::AlwaysReachable: return canAlwaysReach(property.operands[0]);
  case PropertyKind::Longest:
  case PropertyKind::Shortest:
  case PropertyKind::Missing: return std::nullopt;
  }
  return std::nullopt;
}

std::optional<verify::Duration> Verdicts::duration(const codegen::Check& check) const {
  if (check.kind != "property") return std::nullopt;
  const auto& property = script.program->properties.find(check.subject)->node();
  if (property.kind != PropertyKind::Longest && property.kind != PropertyKind::Shortest)
    return std::nullopt;
  return durationOf(property, script, [this](const auto& wish, const auto& now, const auto& facts) {
    return isTrueAt(wish, now, facts);
  });
}

bool Verdicts::isTrueAt(const syntax::Expr& wish, const Situation& now,
                        const std::vector<Fact>& facts) const {
  const auto part = [&](const syntax::Expr& operand) { return isTrueAt(operand, now, facts); };
  const auto& parts = wish.operands;
  const auto stateOf = [&]() -> const SkillState& {
    return now.skills[script.skill(wish.name.text)];
  };
  const bool isKnown = script.skill(wish.name.text) != kNobody;
  switch (wish.kind) {
  case ExprKind::And: return std::ranges::all_of(parts, part);
  case ExprKind::Or: return std::ranges::any_of(parts, part);
  case ExprKind::Not: return !part(parts[0]);
  case ExprKind::Implies: return !part(parts[0]) || part(parts[1]);
  case ExprKind::Equivalent: return part(parts[0]) == part(parts[1]);
  case ExprKind::Running: return isKnown && stateOf().phase == Phase::Running;
  case ExprKind::Called: return isKnown && stateOf().caller != kNobody;
  case ExprKind::Ended:
    if (!isKnown || stateOf().caller != kNobody) return false;
    return wish.member ? wordOf(stateOf().last.status) == wish.member.text
                       : stateOf().last.status != Status::None;
  case ExprKind::Occurs:
    return std::ranges::count(facts, Fact{What::Occurs, script.event(wish.name.text), 0}) > 0;
  case ExprKind::At: return isAt(wish.name.text, now);
  default: return Look(script, now).holds(wish);
  }
}

bool Verdicts::isAt(std::string_view label, const Situation& now) const {
  for (std::size_t i = 0; i < script.threads.size(); ++i) {
    const auto& labels = script.threads[i].labels;
    const auto found = labels.find(label);
    if (found == labels.end()) continue;
    const auto control = now.threads[i].control;
    const bool isThere =
        control == Control::Before || control == Control::Busy || control == Control::Within;
    if (isThere && now.threads[i].place == found->second) return true;
  }
  return false;
}

/// It has this value at a point of some run: in a situation, or after a step.
bool Verdicts::sometimes(const syntax::Expr& wish, bool value) const {
  return std::ranges::any_of(runs.nodes(), [&](const Node& node) {
    return isTrueAt(wish, node.situation, {}) == value ||
           std::ranges::any_of(node.edges, [&](const Edge& edge) {
             return isTrueAt(wish, node.situation, edge.facts) == value;
           });
  });
}

/// Whether some run leads to it from every situation, by steps and time.
bool Verdicts::canAlwaysReach(const syntax::Expr& wish) const {
  const auto& nodes = runs.nodes();
  std::vector<bool> good(nodes.size());
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = nodes.size(); i-- > 0;) {
      const auto& now = nodes[i].situation;
      const bool leads = std::ranges::any_of(nodes[i].edges, [&](const Edge& edge) {
        return good[edge.target] || isTrueAt(wish, now, edge.facts);
      });
      if (good[i] ||
          !(leads || (nodes[i].later && good[*nodes[i].later]) || isTrueAt(wish, now, {})))
        continue;
      good[i] = changed = true;
    }
  }
  return std::ranges::all_of(good, std::identity{});
}

/// The situations from which some counted run never reaches it.
std::vector<bool> Verdicts::avoiding(const syntax::Property& property,
                                     const syntax::Expr& wish) const {
  const auto& nodes = runs.nodes();
  std::vector<bool> without(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    without[i] = !isTrueAt(wish, nodes[i].situation, {});
  const auto misses = [&](std::size_t node, std::size_t edge) {
    return !isTrueAt(wish, nodes[node].situation, nodes[node].edges[edge].facts);
  };
  return goOn(countedBy(property), script, runs, without, misses);
}

/// Whether `cause` is true at some point, and `wish` is false from that point on.
bool Verdicts::canMiss(const syntax::Property& property) const {
  const auto& cause = property.operands[0];
  const auto& wish = property.operands[1];
  const auto& nodes = runs.nodes();
  const auto alive = avoiding(property, wish);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto& now = nodes[i].situation;
    if (alive[i] && isTrueAt(cause, now, {})) return true;
    const bool misses = std::ranges::any_of(nodes[i].edges, [&](const Edge& edge) {
      return alive[edge.target] && isTrueAt(cause, now, edge.facts) &&
             !isTrueAt(wish, now, edge.facts);
    });
    if (misses) return true;
  }
  return false;
}

/// Whether some run reaches `late` before `early`.
bool Verdicts::canPrecede(const syntax::Expr& late, const syntax::Expr& early) const {
  const auto& nodes = runs.nodes();
  std::vector<bool> seen(nodes.size());
  std::vector<std::size_t> todo;
  bool found = false;
  const auto visit = [&](std::size_t node) {
    const auto& now = nodes[node].situation;
    if (seen[node] || isTrueAt(early, now, {})) return;
    seen[node] = true;
    found = found || isTrueAt(late, now, {});
    todo.push_back(node);
  };
  for (const auto node : runs.starts()) visit(node);
  while (!todo.empty() && !found) {
    const auto& node = nodes[todo.back()];
    todo.pop_back();
    if (node.later) visit(*node.later);
    for (const auto& edge : node.edges) {
      if (isTrueAt(early, node.situation, edge.facts)) continue;
      found = found || isTrueAt(late, node.situation, edge.facts);
      visit(edge.target);
    }
  }
  return found;
}

} // namespace proskill::meaning
