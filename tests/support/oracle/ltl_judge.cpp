#include "tests/support/oracle/point_judge.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace proskill::oracle {

using fiacre::Ltl;
using fiacre::LtlKind;

namespace {

/// A state with the step that leaves it; a last state has none.
struct Position {
  std::size_t discrete = 0;
  std::size_t node = 0;
  const Firing* firing = nullptr;
  std::vector<std::size_t> next;
};

/// Positions in a region graph: delays between steps are not visible.
class Positions {
public:
  explicit Positions(const RegionGraph& in) : graph(in) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> numbers;
    const auto& nodes = graph.nodes();
    for (std::size_t node = 0; node < nodes.size(); ++node) {
      const auto& state = graph.discrete(nodes[node].discrete);
      if (state.firings.empty()) {
        numbers[{node, 0}] = all.size();
        all.push_back({nodes[node].discrete, node, nullptr, {all.size()}});
      }
      for (std::size_t i = 0; i < nodes[node].edges.size(); ++i) {
        numbers[{node, i}] = all.size();
        all.push_back(
            {nodes[node].discrete, node, &state.firings[nodes[node].edges[i].firing], {}});
      }
    }
    const auto at = [&](std::size_t node) {
      std::set<std::size_t> seen;
      std::vector<std::size_t> found;
      for (std::optional<std::size_t> now = node; now && seen.insert(*now).second;
           now = nodes[*now].later) {
        const bool last = graph.discrete(nodes[*now].discrete).firings.empty();
        for (std::size_t i = 0; i < (last ? 1 : nodes[*now].edges.size()); ++i)
          found.push_back(numbers.at({*now, i}));
        if (last) break;
      }
      return found;
    };
    for (const auto& [key, number] : numbers)
      if (all[number].firing) all[number].next = at(nodes[key.first].edges[key.second].target);
    first = at(0);
  }

  std::vector<Position> all;
  std::vector<std::size_t> first;

private:
  const RegionGraph& graph;
};

class LtlJudge {
public:
  LtlJudge(const Interpreter& of, const RegionGraph& in, const Ltl& asked)
      : model(of), graph(in), positions(in), formula(asked) {
    collect(formula);
  }

  /// Whether some run violates the formula.
  [[nodiscard]] bool isViolated() {
    const std::size_t guesses = std::size_t{1} << elementary.size();
    const std::size_t count = positions.all.size() * guesses;
    values.resize(count);
    for (std::size_t i = 0; i < count; ++i) value(formula, i / guesses, i % guesses, &values[i]);
    std::vector<std::vector<std::size_t>> next(count);
    std::vector<std::vector<std::size_t>> before(count);
    for (std::size_t i = 0; i < count; ++i)
      for (auto position : positions.all[i / guesses].next)
        for (std::size_t guess = 0; guess < guesses; ++guess) {
          const std::size_t target = position * guesses + guess;
          if (!fits(i % guesses, values[target])) continue;
          next[i].push_back(target);
          before[target].push_back(i);
        }
    // The positions that can go on for ever and fulfil every promise infinitely often: a greatest
    // fixed point.
    std::vector<bool> fair(count, true);
    for (bool changed = true; changed;) {
      changed = false;
      const auto narrow = [&](const std::function<bool(std::size_t)>& keeps) {
        std::vector<bool> reaches(count); // in one step or more
        std::vector<std::size_t> todo;
        for (std::size_t i = 0; i < count; ++i)
          if (fair[i] && keeps(i)) todo.push_back(i);
        while (!todo.empty()) {
          const std::size_t at = todo.back();
          todo.pop_back();
          for (auto source : before[at])
            if (fair[source] && !reaches[source]) {
              reaches[source] = true;
              todo.push_back(source);
            }
        }
        for (std::size_t i = 0; i < count; ++i)
          if (fair[i] && !reaches[i]) {
            fair[i] = false;
            changed = true;
          }
      };
      narrow([](std::size_t) { return true; });
      for (const auto* threat : threats)
        narrow([&](std::size_t i) {
          return values[i].at(threat) || !values[i].at(&threat->operands[0]);
        });
      for (const auto* promise : promises)
        narrow([&](std::size_t i) {
          return !values[i].at(promise) || values[i].at(&promise->operands.back());
        });
    }
    for (auto position : positions.first)
      for (std::size_t guess = 0; guess < guesses; ++guess) {
        const std::size_t at = position * guesses + guess;
        if (fair[at] && !values[at].at(&formula)) return true;
      }
    return false;
  }

private:
  using Values = std::map<const Ltl*, bool>;

  /// A guess at a position: the truth of `next f`, and of each promise at the next position.
  void collect(const Ltl& of) {
    for (const auto& operand : of.operands) collect(operand);
    const bool temporal = of.kind == LtlKind::Next || of.kind == LtlKind::Until ||
                          of.kind == LtlKind::Finally || of.kind == LtlKind::Globally;
    if (temporal) elementary.push_back(&of);
    if (of.kind == LtlKind::Until || of.kind == LtlKind::Finally) promises.push_back(&of);
    // a `globally` that is false promises the negation of its operand
    if (of.kind == LtlKind::Globally) threats.push_back(&of);
  }

  bool value(const Ltl& of, std::size_t position, std::size_t guess, Values* all) {
    std::vector<bool> inner;
    for (const auto& operand : of.operands) inner.push_back(value(operand, position, guess, all));
    const auto later = [&] {
      const auto at = std::ranges::find(elementary, &of) - elementary.begin();
      return (guess >> at & 1) != 0;
    };
    bool result = false;
    switch (of.kind) {
    case LtlKind::Atom: {
      const Position& at = positions.all[position];
      result = observed(model, of.atom, {&graph.discrete(at.discrete).store, at.firing});
      break;
    }
    case LtlKind::Not: result = !inner[0]; break;
    case LtlKind::And: result = std::ranges::all_of(inner, std::identity{}); break;
    case LtlKind::Or: result = std::ranges::any_of(inner, std::identity{}); break;
    case LtlKind::Implies: result = !inner[0] || inner[1]; break;
    case LtlKind::Next: result = later(); break;
    case LtlKind::Until: result = inner[1] || (inner[0] && later()); break;
    case LtlKind::Finally: result = inner[0] || later(); break;
    case LtlKind::Globally: result = inner[0] && later(); break;
    }
    (*all)[&of] = result;
    return result;
  }

  /// Whether the guess is true at the next position.
  [[nodiscard]] bool fits(std::size_t guess, const Values& next) const {
    for (std::size_t i = 0; i < elementary.size(); ++i) {
      const auto* of = elementary[i];
      const bool there = next.at(of->kind == LtlKind::Next ? &of->operands[0] : of);
      if (((guess >> i & 1) != 0) != there) return false;
    }
    return true;
  }

  const Interpreter& model;
  const RegionGraph& graph;
  Positions positions;
  const Ltl& formula;
  std::vector<const Ltl*> elementary;
  std::vector<const Ltl*> promises;
  std::vector<const Ltl*> threats;
  std::vector<Values> values;
};

} // namespace

bool isTrueOfRuns(const Interpreter& model, const RegionGraph& graph, const Ltl& formula) {
  return !LtlJudge(model, graph, formula).isViolated();
}

} // namespace proskill::oracle
