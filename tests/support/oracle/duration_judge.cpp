#include "tests/support/oracle/duration_judge.h"

#include <algorithm>

namespace proskill::oracle {

using fiacre::Observable;
using fiacre::ObservableKind;

namespace {

bool isOfSteps(ObservableKind kind) {
  return kind == ObservableKind::Tag || kind == ObservableKind::Event ||
         kind == ObservableKind::Enter || kind == ObservableKind::Leave;
}

class DurationJudge {
public:
  DurationJudge(const Interpreter& of, const RegionGraph& in, const fiacre::Pattern& asked)
      : model(of),
        graph(in),
        from(asked.operands[0]),
        to(asked.operands[1]),
        longest(asked.kind == fiacre::PatternKind::Longest) {}

  verify::Duration judge() {
    begin();
    while (!todo.empty()) {
      const std::size_t node = todo.back();
      todo.pop_back();
      measureFrom(node);
    }
    if (!best) return {};
    verify::Duration made{.happens = true};
    if (*best == kBeyond) {
      made.bounded = false;
      return made;
    }
    made.value.strict = *best % 2 != 0;
    made.value.value = (longest ? *best + 1 : *best) / 2;
    return made;
  }

private:
  using Limit = std::int64_t;

  static constexpr Limit kBeyond = INT64_MAX;

  [[nodiscard]] bool seen(const Observable& what, std::size_t node,
                          const Firing* firing = nullptr) const {
    const auto& state = graph.discrete(graph.nodes()[node].discrete);
    return observed(model, what, {&state.store, firing});
  }

  /// Whether one of the events or changes that a condition reads happens.
  [[nodiscard]] bool happens(const Observable& what, std::size_t node, const Firing& firing) const {
    if (isOfSteps(what.kind) && seen(what, node, &firing)) return true;
    return std::ranges::any_of(what.operands,
                               [&](const Observable& part) { return happens(part, node, firing); });
  }

  /// A measurement begins in the initial node, after steps with which the condition becomes true,
  /// and after steps that show it by what happens in them.
  void begin() {
    if (seen(from, 0)) open(graph.nodes()[0].restarted);
    for (std::size_t i = 0; i < graph.nodes().size(); ++i)
      for (const auto& edge : graph.nodes()[i].edges) {
        const auto& firing = graph.discrete(graph.nodes()[i].discrete).firings[edge.firing];
        const bool rises = !seen(from, i) && seen(from, edge.target);
        if (rises || (happens(from, i, firing) && seen(from, i, &firing)))
          open(graph.nodes()[edge.target].restarted);
      }
  }

  void open(std::size_t node) {
    if (during.insert(node).second) todo.push_back(node);
  }

  void measureFrom(std::size_t node) {
    const auto& at = graph.nodes()[node];
    if (longest) note(node);
    if (seen(to, node)) {
      note(node);
      return;
    }
    if (at.later) open(*at.later);
    for (const auto& edge : at.edges) {
      if (seen(to, node, &graph.discrete(at.discrete).firings[edge.firing]))
        note(node);
      else
        open(edge.target);
    }
  }

  void note(std::size_t node) {
    const auto& region = graph.nodes()[node].region;
    const Age& age = *std::ranges::find(region, kWatch, &Age::clock);
    const Limit limit = age.beyond ? kBeyond : 2 * age.whole + (age.rank > 0 ? 1 : 0);
    if (!best || (longest ? limit > *best : limit < *best)) best = limit;
  }

  const Interpreter& model;
  const RegionGraph& graph;
  const Observable& from;
  const Observable& to;
  bool longest;
  std::set<std::size_t> during; ///< nodes in a measurement
  std::vector<std::size_t> todo;
  std::optional<Limit> best; ///< twice the age; odd: between this and the next unit
};

} // namespace

verify::Duration durationOf(const Interpreter& model, const RegionGraph& graph,
                            const fiacre::Pattern& pattern) {
  return DurationJudge(model, graph, pattern).judge();
}

} // namespace proskill::oracle
