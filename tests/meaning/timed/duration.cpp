#include "tests/meaning/timed/duration.h"

#include <algorithm>

namespace proskill::meaning {

namespace {

constexpr std::size_t kMostSituations = 12'000; ///< situations, each with the value of the watch

/// Follows all measurements at once, with the watch at 0 where they begin.
class Measurements {
public:
  Measurements(const syntax::Property& asked, const Runs& explored, const Seen& sees)
      : from(asked.operands[0]),
        to(asked.operands[1]),
        longest(asked.kind == syntax::PropertyKind::Longest),
        runs(explored),
        seen(sees) {}

  verify::Duration measure() {
    begin();
    while (!todo.empty()) {
      const std::size_t node = todo.back();
      todo.pop_back();
      follow(node);
    }
    if (!best) return {};
    verify::Duration made{.happens = true, .bounded = *best != kBeyond};
    if (!made.bounded) return made;
    made.value.strict = *best % 2 != 0;
    made.value.value = (*best + (longest ? 1 : 0)) / 2;
    return made;
  }

private:
  static constexpr std::int64_t kBeyond = INT64_MAX;

  [[nodiscard]] bool isSeen(const syntax::Expr& what, std::size_t node,
                            const std::vector<Fact>& facts = {}) const {
    return seen(what, runs.nodes()[node].situation, facts);
  }

  /// Whether one of the events of a condition occurs.
  [[nodiscard]] bool occurs(const syntax::Expr& what, std::size_t node,
                            const std::vector<Fact>& facts) const {
    if (what.kind == syntax::ExprKind::Occurs && isSeen(what, node, facts)) return true;
    return std::ranges::any_of(what.operands,
                               [&](const syntax::Expr& part) { return occurs(part, node, facts); });
  }

  void begin() {
    for (const auto node : runs.starts())
      if (isSeen(from, node)) enter(runs.nodes()[node].restarted);
    for (std::size_t i = 0; i < runs.nodes().size(); ++i)
      for (const auto& edge : runs.nodes()[i].edges) {
        const bool rises = !isSeen(from, i) && isSeen(from, edge.target);
        if (rises || (occurs(from, i, edge.facts) && isSeen(from, i, edge.facts)))
          enter(runs.nodes()[edge.target].restarted);
      }
  }

  void enter(std::size_t node) {
    if (during.insert(node).second) todo.push_back(node);
  }

  void follow(std::size_t node) {
    if (longest || isSeen(to, node)) note(node);
    if (isSeen(to, node)) return;
    const auto& now = runs.nodes()[node];
    if (now.later) enter(*now.later);
    for (const auto& edge : now.edges) {
      if (isSeen(to, node, edge.facts))
        note(node);
      else
        enter(edge.target);
    }
  }

  /// Counts half units: an odd number is between two units.
  void note(std::size_t node) {
    const Age& age = Runs::watch(runs.nodes()[node]);
    const bool beyond =
        age.beyond || age.whole > kMeasured || (age.whole == kMeasured && age.fraction > 0);
    const std::int64_t half = beyond ? kBeyond : 2 * age.whole + (age.fraction > 0 ? 1 : 0);
    if (!best || (longest ? half > *best : half < *best)) best = half;
  }

  const syntax::Expr& from;
  const syntax::Expr& to;
  bool longest;
  const Runs& runs;
  const Seen& seen;
  std::set<std::size_t> during;
  std::vector<std::size_t> todo;
  std::optional<std::int64_t> best;
};

} // namespace

std::optional<verify::Duration> durationOf(const syntax::Property& property, const Script& script,
                                           const Seen& seen) {
  const Runs runs(script, kMostSituations, kMeasured);
  if (!runs.complete()) return std::nullopt;
  return Measurements(property, runs, seen).measure();
}

} // namespace proskill::meaning
