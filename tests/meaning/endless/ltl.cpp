#include "tests/meaning/endless/ltl.h"

#include "graph/components.h"
#include "tests/meaning/endless/fairness.h"

#include <algorithm>
#include <map>
#include <set>

namespace proskill::meaning {
namespace {

using syntax::Expr;
using syntax::ExprKind;

constexpr std::size_t kMostPlaces = 60'000;

/// A formula that has to be true, or false.
struct Wish {
  const Expr* formula = nullptr;
  bool value = true;
  friend auto operator<=>(const Wish&, const Wish&) = default;
};
using Wishes = std::set<Wish>;

/// The obligations after a step, and what it postponed.
struct Rest {
  Wishes next;
  Wishes late;
  friend auto operator<=>(const Rest&, const Rest&) = default;
};

bool isTemporal(const Expr& formula) {
  return formula.kind >= ExprKind::Globally || std::ranges::any_of(formula.operands, isTemporal);
}

bool hasNext(const Expr& formula) {
  return formula.kind == ExprKind::Next || std::ranges::any_of(formula.operands, hasNext);
}

/// Whether a formula is about the first step, as it is outside `[]` and `<>`.
bool asksFirstStep(const Expr& formula) {
  if (formula.kind == ExprKind::Globally || formula.kind == ExprKind::Finally) return false;
  return formula.operands.empty() || std::ranges::any_of(formula.operands, asksFirstStep);
}

/// How a formula is tested: whether it should be true, and at each of the steps or at one.
struct Aspect {
  bool value = true;
  bool each = true;
};

/// Whether a formula is about a step at which some event does not occur.
bool asksForSilence(const Expr& formula, Aspect now) {
  const auto asks = [&](std::size_t i, Aspect aspect) {
    return asksForSilence(formula.operands[i], aspect);
  };
  const auto any = [&](Aspect aspect) {
    return std::ranges::any_of(formula.operands,
                               [&](const Expr& each) { return asksForSilence(each, aspect); });
  };
  const Aspect opposite{!now.value, now.each};
  const Aspect atEach{now.value, now.value}; // of `not [] P`, P is false at one step
  const Aspect atOne{now.value, !now.value};
  switch (formula.kind) {
  case ExprKind::Occurs: return now.value == now.each;
  case ExprKind::Not: return any(opposite);
  case ExprKind::Implies: return asks(0, opposite) || asks(1, now);
  case ExprKind::Equivalent: return any(now) || any(opposite);
  case ExprKind::Globally: return any(atEach);
  case ExprKind::Finally: return any(atOne);
  case ExprKind::Until:
  case ExprKind::WeakUntil: return asks(0, atEach) || asks(1, atOne);
  case ExprKind::Release:
  case ExprKind::StrongRelease: return asks(0, atOne) || asks(1, atEach);
  default: return any(now);
  }
}

/// Whether the translation makes steps that the interpreter does not: choices of initial values,
/// and steps of processes that observe durations and moves.
bool hasOtherSteps(const Script& script) {
  const auto isObserved = [](const syntax::StateVariable* variable) {
    return variable->isNatural() || !variable->otherInits.empty() ||
           variable->transitionsKind == syntax::Transitions::Listed;
  };
  return std::ranges::any_of(script.variables, isObserved) ||
         std::ranges::any_of(script.skills, [](const SkillEntry& skill) {
           return skill.isComposite() && skill.node->timeInterval;
         });
}

/// All ways to fulfil some obligations at one point.
class Point {
public:
  explicit Point(std::function<bool(const Expr&)> holds) : holds(std::move(holds)) {}

  std::set<Rest> ways(const Wishes& wishes) {
    found.clear();
    choose({wishes.begin(), wishes.end()}, {});
    return std::move(found);
  }

private:
  using List = std::vector<Wish>;

  static List with(List list, std::initializer_list<Wish> more) {
    list.insert(list.end(), more);
    return list;
  }

  void choose(List todo, Rest rest) {
    if (todo.empty()) {
      found.insert(std::move(rest));
      return;
    }
    const Wish wish = todo.back();
    todo.pop_back();
    if (isTemporal(*wish.formula))
      unfold(wish, std::move(todo), std::move(rest));
    else if (holds(*wish.formula) == wish.value)
      choose(std::move(todo), std::move(rest));
  }

  void unfold(Wish wish, List todo, Rest rest) {
    const auto& parts = wish.formula->operands;
    const bool value = wish.value;
    switch (wish.formula->kind) {
    case ExprKind::Not: return choose(with(todo, {{&parts[0], !value}}), rest);
    case ExprKind::And: return value ? all(parts, true, todo, rest) : any(parts, false, todo, rest);
    case ExprKind::Or: return value ? any(parts, true, todo, rest) : all(parts, false, todo, rest);
    case ExprKind::Implies:
      if (!value) return choose(with(todo, {{&parts[0], true}, {&parts[1], false}}), rest);
      choose(with(todo, {{&parts[0], false}}), rest);
      return choose(with(todo, {{&parts[1], true}}), rest);
    case ExprKind::Equivalent:
      choose(with(todo, {{&parts[0], true}, {&parts[1], value}}), rest);
      return choose(with(todo, {{&parts[0], false}, {&parts[1], !value}}), rest);
    case ExprKind::Globally:
    case ExprKind::Finally: return unfoldOften(wish, todo, rest);
    case ExprKind::Until:
    case ExprKind::WeakUntil:
    case ExprKind::Release:
    case ExprKind::StrongRelease: return unfoldUntil(wish, todo, rest);
    case ExprKind::Next:
      rest.next.insert({&parts[0], value});
      return choose(std::move(todo), std::move(rest));
    default: return; // no other operator is temporal
    }
  }

  void all(const syntax::List<Expr>& parts, bool value, List todo, const Rest& rest) {
    for (const auto& part : parts) todo.push_back({&part, value});
    choose(std::move(todo), rest);
  }
  void any(const syntax::List<Expr>& parts, bool value, const List& todo, const Rest& rest) {
    for (const auto& part : parts) choose(with(todo, {{&part, value}}), rest);
  }

  void unfoldOften(Wish wish, const List& todo, Rest rest) {
    const Wish part{&wish.formula->operands[0], wish.value};
    const bool always = (wish.formula->kind == ExprKind::Globally) == wish.value;
    if (!always) choose(with(todo, {part}), rest);
    rest.next.insert(wish);
    if (always) return choose(with(todo, {part}), rest);
    rest.late.insert(wish);
    choose(todo, rest);
  }

  /// `a R b` is `not (not a U not b)`, and `a M b` is `not (not a W not b)`.
  void unfoldUntil(Wish wish, const List& todo, Rest rest) {
    const auto& parts = wish.formula->operands;
    const auto kind = wish.formula->kind;
    const bool dual = kind == ExprKind::Release || kind == ExprKind::StrongRelease;
    const bool weak = kind == ExprKind::WeakUntil || kind == ExprKind::StrongRelease;
    const bool value = wish.value != dual; // of the `until`
    const Wish first{&parts[0], wish.value};
    const Wish second{&parts[1], wish.value};
    if (value)
      choose(with(todo, {second}), rest);
    else
      choose(with(todo, {first, second}), rest);
    rest.next.insert(wish);
    if (value != weak) rest.late.insert(wish);
    choose(with(todo, {value ? first : second}), rest);
  }

  std::function<bool(const Expr&)> holds;
  std::set<Rest> found;
};

/// Searches for a run that violates the formula: a cycle on which nothing is postponed for ever.
class Search {
public:
  Search(const Counted& which, const Script& from, const Runs& of, const Seen& in)
      : counted(which), script(from), runs(of), seen(in) {}

  /// nullopt if there are too many places
  std::optional<bool> findsRun(const Wish& wish) {
    for (const auto node : runs.starts()) visit(node, {wish}, false);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (places.size() > kMostPlaces) return std::nullopt;
      expand(i);
    }
    return hasGoodCircle();
  }

private:
  struct Arc {
    std::size_t target = 0;
    bool step = true; ///< time alone is not a cycle
    Wishes late;
  };
  struct Place {
    std::size_t node = 0;
    Wishes wishes;
    bool rests = false; ///< no further step is possible
    std::vector<Arc> arcs;
  };

  std::size_t visit(std::size_t node, const Wishes& wishes, bool rests) {
    const auto [known, isNew] = numbers.try_emplace({node, wishes, rests}, places.size());
    if (isNew) places.push_back({node, wishes, rests, {}});
    return known->second;
  }

  void expand(std::size_t place) {
    const std::size_t at = places[place].node;
    if (places[place].rests) return step(place, at, {}, true);
    const auto& node = runs.nodes()[at];
    for (const auto& edge : node.edges) step(place, edge.target, edge.facts, false);
    const Wishes wishes = places[place].wishes;
    const auto goOn = [&](std::size_t next, bool rests) {
      const auto target = visit(next, wishes, rests);
      places[place].arcs.push_back({target, false, {}});
    };
    if (node.later) goOn(*node.later, false);
    if (mayRest(counted, script, runs, at)) goOn(at, true);
  }

  void step(std::size_t place, std::size_t next, const std::vector<Fact>& facts, bool rests) {
    const auto& now = runs.nodes()[places[place].node].situation;
    Point point([&](const Expr& condition) { return seen(condition, now, facts); });
    const Wishes wishes = places[place].wishes;
    for (const auto& way : point.ways(wishes)) {
      const auto target = visit(next, way.next, rests);
      places[place].arcs.push_back({target, true, way.late});
    }
  }

  [[nodiscard]] bool hasGoodCircle() const {
    const auto component = graph::componentsOf(places.size(), [&](std::size_t at, std::size_t i) {
      return i < places[at].arcs.size() ? static_cast<std::uint32_t>(places[at].arcs[i].target)
                                        : graph::kNoNode;
    });
    std::map<std::size_t, Wishes> late; ///< by component: what each of its steps postpones
    std::map<std::size_t, Circle> circles;
    for (std::size_t i = 0; i < places.size(); ++i)
      for (const auto& arc : places[i].arcs) {
        if (component[arc.target] != component[i]) continue;
        auto& circle = circles[component[i]];
        circle.nodes.insert({places[i].node, places[arc.target].node});
        circle.timeGoesOn = circle.timeGoesOn || !arc.step;
        circle.hasStep = circle.hasStep || arc.step;
        if (!arc.step) continue;
        const auto [entry, first] = late.try_emplace(component[i], arc.late);
        if (!first)
          std::erase_if(entry->second, [&](const Wish& wish) { return !arc.late.contains(wish); });
      }
    return std::ranges::any_of(late, [&](const auto& entry) {
      return entry.second.empty() && counts(counted, script, runs, circles[entry.first]);
    });
  }

  Counted counted;
  const Script& script;
  const Runs& runs;
  const Seen& seen;
  std::vector<Place> places;
  std::map<std::tuple<std::size_t, Wishes, bool>, std::size_t> numbers;
};

} // namespace

std::optional<bool> holdsInRuns(const syntax::Property& property, const Script& script,
                                const Runs& runs, const Seen& seen) {
  const Expr& formula = property.operands[0];
  if (hasNext(formula) && hasOtherSteps(script)) return std::nullopt;
  if (script.eventsMakeSteps && (asksFirstStep(formula) || asksForSilence(formula, {})))
    return std::nullopt;
  const auto violated = Search(countedBy(property), script, runs, seen).findsRun({&formula, false});
  if (!violated) return std::nullopt;
  return !*violated;
}

} // namespace proskill::meaning
