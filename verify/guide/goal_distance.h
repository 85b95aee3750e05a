#pragma once

#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/model/system.h"

#include <map>
#include <vector>

namespace proskill::verify {

/// Estimates how many steps lead from a state to a goal, so that a search can begin with the states
/// next to it. The estimate ignores time, and assumes that a value, once reached, is never lost:
/// h_add of Bonet and Geffner, "Planning as heuristic search", Artificial Intelligence 129, 2001.
/// It may be too low or too high, so no verdict may depend on it.
class GoalDistance {
public:
  static constexpr std::uint32_t kFar = UINT32_MAX; ///< not even reached under these assumptions

  /// Whether there are estimates for a goal: it must ask for a state or for events.
  [[nodiscard]] static bool isFor(const Goal& goal);

  /// \param system without a state layout \param laidOut the same with its layout
  /// \param dropped transitions that the search skips \throw LimitMet
  GoalDistance(const System& system, const System& laidOut, const Goal& goal, const Bits& dropped,
               LimitWatch& limits);

  /// \param state of `laidOut`
  [[nodiscard]] std::uint32_t from(const Word* state);
  /// The transitions on the estimated way from a state to the goal. \param state of `laidOut`
  [[nodiscard]] Bits usefulSteps(const Word* state);

private:
  using RuleId = std::uint32_t;
  using FactId = std::uint32_t;

  /// Makes facts true if all that it needs are. A fact is that a cell has a value, or that a
  /// condition holds.
  struct Rule {
    std::vector<FactId> needs;
    std::vector<FactId> makes;
    TransitionId step = kNone; ///< kNone: follows without a step
  };
  /// A way through the code of a path.
  struct Way {
    std::size_t at = 0; ///< the next instruction
    std::vector<FactId> needs;
    std::vector<FactId> makes;
    Bits assigned;
  };
  struct TrackedCell {
    CellId cell = 0;
    FactId first = 0; ///< of its lowest value; the others follow
  };

  FactId newFact();
  void addRule(std::vector<FactId> needs, std::vector<FactId> makes, TransitionId step = kNone);
  [[nodiscard]] FactId factOf(CellId cell, std::int64_t value);
  [[nodiscard]] std::vector<FactId> factsOf(CellId cell);
  [[nodiscard]] FactId condition(NodeId node, bool isNegated);
  [[nodiscard]] FactId madeCondition(NodeId node, bool isNegated);
  [[nodiscard]] FactId comparison(NodeId node, bool isNegated);
  void addTransition(TransitionId id, const Goal& goal);
  void addWays(const Path& path, const Goal& goal, Way way, std::size_t& left);
  void addWay(Way way, std::size_t& left);
  void require(NodeId node, bool isNegated, Way& way);
  void assign(const Assignment& assignment, Way& way);
  void reach(FactId fact, std::uint32_t cost, RuleId by);
  void reachInitial(const Word* state);

  const System& system;
  const System& laidOut;
  LimitWatch& limits;
  std::vector<std::int64_t> values;      ///< by cell: those with which a comparison is tried
  std::vector<std::vector<RuleId>> uses; ///< by fact: the rules that need it
  std::vector<Rule> rules;
  std::vector<RuleId> always; ///< rules that need nothing
  std::map<CellId, FactId> firstOf;
  std::vector<TrackedCell> tracked;
  std::map<std::pair<NodeId, bool>, FactId> conditions;
  FactId wanted = 0;

  // of one estimate:
  std::vector<std::uint32_t> costs; ///< by fact
  std::vector<RuleId> makers;       ///< by fact: the rule of these costs; kNone: from the start
  std::vector<std::uint32_t> open;  ///< by rule: number of needs that are not met
  std::vector<std::uint32_t> sums;  ///< by rule: sum of the costs of its needs
  std::vector<std::vector<FactId>> byCost; ///< facts that were reached, each at least once
};

} // namespace proskill::verify
