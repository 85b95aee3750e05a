#include "tests/bridge/skillset_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace proskill::test {
namespace {

using namespace bridge::rl;

struct Moment {
  std::map<std::string, std::string> values; ///< by resource
  std::vector<bool> runs;                    ///< by skill

  friend auto operator<=>(const Moment&, const Moment&) = default;
};

bool holds(const Expr& expr, const Moment& now) {
  const auto& all = expr.operands;
  const auto isTrue = [&](const Expr& each) { return holds(each, now); };
  switch (expr.kind) {
  case ExprKind::True: return true;
  case ExprKind::False: return false;
  case ExprKind::Is: return now.values.at(expr.resource.text) == expr.state.text;
  case ExprKind::IsNot: return now.values.at(expr.resource.text) != expr.state.text;
  case ExprKind::Not: return !isTrue(all[0]);
  case ExprKind::And: return std::ranges::all_of(all, isTrue);
  case ExprKind::Or: return std::ranges::any_of(all, isTrue);
  case ExprKind::Implies: return !isTrue(all[0]) || isTrue(all[1]);
  }
  return false;
}

/// All moments that can follow each other, by breadth-first search.
class Runs {
public:
  explicit Runs(const Skillset& of) : skillset(of) {}

  std::set<std::string> explore() {
    Moment first;
    for (const auto& resource : skillset.resources)
      first.values[resource.name.text] = resource.initial.text;
    first.runs.resize(skillset.skills.size());
    reach(first);
    while (!open.empty()) {
      const Moment now = open.back();
      open.pop_back();
      follow(now);
    }
    return std::move(seen);
  }

private:
  void reach(const Moment& moment) {
    if (!known.insert(moment).second) return;
    open.push_back(moment);
    for (const auto& [resource, state] : moment.values) seen.insert(resource + " " + state);
    for (std::size_t i = 0; i < moment.runs.size(); ++i)
      if (moment.runs[i]) seen.insert("running " + skillset.skills[i].name.text);
  }

  static Moment after(Moment now, const Effects& effects) {
    for (const auto& effect : effects) now.values[effect.resource.text] = effect.state.text;
    return now;
  }

  void end(const Moment& now, std::size_t skill, const Effects& effects, const char* status) {
    auto next = after(now, effects);
    next.runs[skill] = false;
    seen.insert(fmt::format("ended {} {}", skillset.skills[skill].name.text, status));
    reach(next);
  }

  [[nodiscard]] bool someGuardFails(const Moment& now) const {
    for (std::size_t i = 0; i < now.runs.size(); ++i)
      for (const auto& invariant : skillset.skills[i].invariants)
        if (now.runs[i] && !holds(invariant.guard, now)) return true;
    return false;
  }

  void follow(const Moment& now) {
    for (const auto& event : skillset.events)
      if (!event.guard || holds(*event.guard, now)) reach(after(now, event.effects));
    for (std::size_t i = 0; i < now.runs.size(); ++i)
      if (now.runs[i])
        goOn(now, i);
      else
        call(now, i);
  }

  /// A call waits while another skill is about to end because of its invariant, and may be
  /// interrupted before it starts.
  void call(const Moment& now, std::size_t number) {
    const auto& skill = skillset.skills[number];
    if (skill.interrupt) seen.insert("ended " + skill.name.text + " interrupted");
    if (someGuardFails(now)) return;
    for (const auto& each : skill.preconditions)
      if (!holds(each.condition, now)) return;
    auto next = after(now, skill.start);
    next.runs[number] = true;
    reach(next);
  }

  void goOn(const Moment& now, std::size_t number) {
    const auto& skill = skillset.skills[number];
    for (const auto& each : skill.invariants)
      if (!holds(each.guard, now)) end(now, number, each.effects, "failed_inv");
    for (const auto& each : skill.successes) end(now, number, each.effects, "success");
    for (const auto& each : skill.failures) end(now, number, each.effects, "failure");
    if (skill.interrupt) end(now, number, skill.interrupt->effects, "interrupted");
  }

  const Skillset& skillset;
  std::set<Moment> known;
  std::vector<Moment> open;
  std::set<std::string> seen;
};

} // namespace

std::set<std::string> observe(const Skillset& skillset) { return Runs(skillset).explore(); }

std::set<std::string> allObservations(const Skillset& skillset) {
  std::set<std::string> all;
  for (const auto& resource : skillset.resources)
    for (const auto& state : resource.states) all.insert(resource.name.text + " " + state.text);
  for (const auto& skill : skillset.skills) {
    all.insert("running " + skill.name.text);
    for (const char* status : {"success", "failure", "failed_inv", "interrupted"})
      all.insert(fmt::format("ended {} {}", skill.name.text, status));
  }
  return all;
}

} // namespace proskill::test
