#include "verify/monitor/buchi.h"

#include "verify/unsupported.h"

#include <algorithm>
#include <map>
#include <set>

namespace proskill::verify {

using fiacre::Ltl;
using fiacre::LtlKind;

namespace {

using FormulaId = std::uint32_t;

enum class FormulaOp : std::uint8_t { Literal, And, Or, Next, Until, Release };

/// A formula in negation normal form.
struct Formula {
  FormulaOp op = FormulaOp::Literal;
  std::uint32_t a = 0; ///< of a literal: its condition
  std::uint32_t b = 0;
  friend auto operator<=>(const Formula&, const Formula&) = default;
};

/// Formulas without duplicates.
class Formulas {
public:
  Formulas(Nodes& in, const std::function<NodeId(const fiacre::Observable&)>& of)
      : nodes(in), atom(of) {}

  FormulaId literal(NodeId condition) { return make({FormulaOp::Literal, condition, 0}); }
  FormulaId truth() { return literal(nodes.number(1)); }
  FormulaId untruth() { return literal(nodes.number(0)); }

  /// The normal form of a formula or of its negation.
  FormulaId normal(const Ltl& ltl, bool negative) {
    const auto of = [&](std::size_t i, bool turned) { return normal(ltl.operands.at(i), turned); };
    switch (ltl.kind) {
    case LtlKind::Atom: {
      const NodeId condition = atom(ltl.atom);
      return literal(negative ? nodes.negation(condition) : condition);
    }
    case LtlKind::Not: return of(0, !negative);
    case LtlKind::Next: return make({FormulaOp::Next, of(0, negative), 0});
    case LtlKind::Globally:
      return negative ? make({FormulaOp::Until, truth(), of(0, true)})
                      : make({FormulaOp::Release, untruth(), of(0, false)});
    case LtlKind::Finally:
      return negative ? make({FormulaOp::Release, untruth(), of(0, true)})
                      : make({FormulaOp::Until, truth(), of(0, false)});
    case LtlKind::Until:
      return make(
          {negative ? FormulaOp::Release : FormulaOp::Until, of(0, negative), of(1, negative)});
    case LtlKind::Implies:
      return make({negative ? FormulaOp::And : FormulaOp::Or, of(0, !negative), of(1, negative)});
    case LtlKind::And:
    case LtlKind::Or: {
      const FormulaOp op = (ltl.kind == LtlKind::And) != negative ? FormulaOp::And : FormulaOp::Or;
      FormulaId all = of(0, negative);
      for (std::size_t i = 1; i < ltl.operands.size(); ++i) all = make({op, all, of(i, negative)});
      return all;
    }
    }
    unsupported("an unknown operator of LTL");
  }

  [[nodiscard]] const Formula& at(FormulaId id) const { return all[id]; }
  [[nodiscard]] std::size_t size() const { return all.size(); }
  [[nodiscard]] bool isFalse(FormulaId id) const {
    return all[id].op == FormulaOp::Literal && nodes.constant(all[id].a) == 0;
  }
  /// The literal of the negated condition. \pre it is a literal
  FormulaId opposite(FormulaId id) { return literal(nodes.negation(all[id].a)); }
  /// The conjunction of literals.
  NodeId label(const std::set<FormulaId>& literals) {
    NodeId every = nodes.number(1);
    for (auto id : literals) every = nodes.both(every, all[id].a);
    return every;
  }

private:
  FormulaId make(Formula formula) {
    auto [entry, added] = known.try_emplace(formula, static_cast<FormulaId>(all.size()));
    if (added) all.push_back(formula);
    return entry->second;
  }

  Nodes& nodes;
  const std::function<NodeId(const fiacre::Observable&)>& atom;
  std::vector<Formula> all;
  std::map<Formula, FormulaId> known;
};

/// The obligations for the current and for the next position.
struct Draft {
  std::set<FormulaId> todo;
  std::set<FormulaId> old;
  std::set<FormulaId> next;

  /// Whether it is an obligation for the current position anyway.
  [[nodiscard]] bool holds(FormulaId id) const { return todo.contains(id) || old.contains(id); }
};

/// States that agree in all of this accept the same runs.
struct State {
  std::set<FormulaId> literals;
  std::set<FormulaId> promised; ///< each `until` that is not fulfilled here
  std::set<FormulaId> next;
  friend auto operator<=>(const State&, const State&) = default;
};

/// Gerth, Peled, Vardi, Wolper, "Simple on-the-fly automatic verification of linear temporal
/// logic", PSTV 1995, without obligations that others imply: Daniele, Giunchiglia, Vardi, "Improved
/// automata generation for linear temporal logic", CAV 1999.
class Tableau {
public:
  Tableau(Formulas& of, FormulaId start) : formulas(of) {
    first = covers({start});
    for (std::uint32_t i = 0; i < states.size(); ++i) {
      const auto next = states[i].next;
      successors.push_back(covers(next));
      edges += successors.back().size();
      if (edges > kMostEdges) tooLarge();
    }
  }

  std::vector<State> states;
  std::vector<std::vector<std::uint32_t>> successors; ///< by state
  std::vector<std::uint32_t> first;
  std::size_t edges = 0;

  static constexpr std::size_t kMostEdges = 1'000'000;
  [[noreturn]] static void tooLarge() { unsupported("a formula of LTL that is too large"); }

private:
  static constexpr std::size_t kMostStates = 20'000;
  static constexpr std::size_t kMostDrafts = 300'000;

  /// The states in which all of `wanted` is promised.
  std::vector<std::uint32_t> covers(const std::set<FormulaId>& wanted) {
    auto [entry, added] = coversOf.try_emplace(wanted);
    if (!added) return entry->second;
    std::set<std::uint32_t> found;
    expand({wanted, {}, {}}, found);
    return coversOf[wanted] = {found.begin(), found.end()};
  }

  void expand(Draft draft, std::set<std::uint32_t>& found) {
    if (++drafts > kMostDrafts) tooLarge();
    while (!draft.todo.empty()) {
      const FormulaId id = *draft.todo.begin();
      draft.todo.erase(draft.todo.begin());
      if (formulas.isFalse(id)) return;
      if (!draft.old.insert(id).second) continue;
      const Formula formula = formulas.at(id);
      switch (formula.op) {
      case FormulaOp::Literal:
        if (draft.old.contains(formulas.opposite(id))) return;
        break;
      case FormulaOp::Next: draft.next.insert(formula.a); break;
      case FormulaOp::And:
        draft.todo.insert(formula.a);
        draft.todo.insert(formula.b);
        break;
      case FormulaOp::Or: {
        if (draft.holds(formula.a) || draft.holds(formula.b)) break;
        Draft other = draft;
        other.todo.insert(formula.a);
        expand(std::move(other), found);
        draft.todo.insert(formula.b);
        break;
      }
      case FormulaOp::Until: { // b, or a and next the same
        if (draft.holds(formula.b)) break;
        Draft other = draft;
        other.todo.insert(formula.a);
        other.next.insert(id);
        expand(std::move(other), found);
        draft.todo.insert(formula.b);
        break;
      }
      case FormulaOp::Release: { // b, and a or next the same
        draft.todo.insert(formula.b);
        if (draft.holds(formula.a)) break;
        Draft other = draft;
        other.next.insert(id);
        expand(std::move(other), found);
        draft.todo.insert(formula.a);
        break;
      }
      }
    }
    found.insert(stateOf(draft));
  }

  std::uint32_t stateOf(const Draft& draft) {
    State state{.literals = {}, .promised = {}, .next = draft.next};
    for (auto id : draft.old) {
      const auto& formula = formulas.at(id);
      if (formula.op == FormulaOp::Literal) state.literals.insert(id);
      if (formula.op == FormulaOp::Until && !draft.old.contains(formula.b))
        state.promised.insert(id);
    }
    auto [entry, added] = known.try_emplace(state, static_cast<std::uint32_t>(states.size()));
    if (added) states.push_back(std::move(state));
    if (states.size() > kMostStates) tooLarge();
    return entry->second;
  }

  Formulas& formulas;
  std::size_t drafts = 0;
  std::map<std::set<FormulaId>, std::vector<std::uint32_t>> coversOf;
  std::map<State, std::uint32_t> known;
};

} // namespace

/// Each promised `until` must be fulfilled infinitely often; a counter selects the one that is due.
Monitor negated(const Ltl& ltl, Nodes& nodes,
                const std::function<NodeId(const fiacre::Observable&)>& atom) {
  Formulas formulas(nodes, atom);
  Tableau tableau(formulas, formulas.normal(ltl, true));
  std::vector<FormulaId> promises;
  for (FormulaId id = 0; id < formulas.size(); ++id)
    if (formulas.at(id).op == FormulaOp::Until) promises.push_back(id);
  const auto turns = static_cast<std::uint32_t>(std::max<std::size_t>(promises.size(), 1));
  if (tableau.edges * turns > Tableau::kMostEdges) Tableau::tooLarge();
  const auto keeps = [&](const State& state, std::uint32_t turn) {
    return promises.empty() || !state.promised.contains(promises[turn]);
  };
  Monitor made;
  made.ofPoints = false;
  for (FormulaId id = 0; id < formulas.size(); ++id)
    made.ofStates = made.ofStates && formulas.at(id).op != FormulaOp::Next;
  for (std::size_t i = 0; i < tableau.states.size(); ++i) {
    const State& state = tableau.states[i];
    const NodeId label = formulas.label(state.literals);
    for (std::uint32_t turn = 0; turn < turns; ++turn) {
      const bool kept = keeps(state, turn);
      auto& location = made.locations.emplace_back();
      location.stay = nodes.number(1);
      location.accepting = turn == 0 && kept;
      for (auto next : tableau.successors[i])
        location.edges.push_back({.ofStep = true,
                                  .to = next * turns + (kept ? (turn + 1) % turns : turn),
                                  .condition = label});
    }
  }
  for (auto first : tableau.first) made.initial.push_back(first * turns);
  return made;
}

} // namespace proskill::verify
