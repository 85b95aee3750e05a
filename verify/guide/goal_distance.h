#pragma once

#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/model/system.h"

#include <map>
#include <span>
#include <vector>

namespace proskill::verify {

/// Estimates how many steps lead from a state to a goal, so that a search can begin with the states
/// next to it: the length of a plan that ignores time and assumes that a value, once reached, is
/// never lost. A step that several parts of the goal need counts once. Hoffmann and Nebel, "The FF
/// planning system", JAIR 14, 2001; the plan follows the costs of Bonet and Geffner, "Planning as
/// heuristic search", Artificial Intelligence 129, 2001. It may be too long or too short, so no
/// verdict may depend on it.
class GoalDistance {
public:
  static constexpr std::uint32_t kFar = UINT32_MAX; ///< not even reached under these assumptions

  /// Whether there are estimates for a goal: it must ask for a state or for events.
  [[nodiscard]] static bool isFor(const Goal& goal);

  /// \param system without a state layout \param laidOut the same with its layout
  /// \param dropped transitions that the search skips \throw LimitMet
  GoalDistance(const System& system, const System& laidOut, const Goal& goal, const Bits& dropped,
               LimitWatch& limits);

  struct Estimate {
    std::uint32_t steps = kFar;
    std::uint32_t left = kFar; ///< conditions of the goal that do not hold, and changes of numbers
  };
  /// \param state of `laidOut`
  [[nodiscard]] Estimate from(const Word* state);
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
    bool counts = false;       ///< it is one of a cell's changes by an assignment that counts

    [[nodiscard]] std::uint32_t length() const { return step != kNone || counts ? 1 : 0; }
  };
  /// What an estimate reads most often: a part of an array for each number.
  struct Lists {
    std::vector<std::uint32_t> ends; ///< by number: where its part ends; the next one begins there
    std::vector<std::uint32_t> items;

    void add(const std::vector<std::uint32_t>& list);
    [[nodiscard]] std::span<const std::uint32_t> at(std::uint32_t number) const {
      const std::uint32_t first = number == 0 ? 0 : ends[number - 1];
      return {items.data() + first, items.data() + ends[number]};
    }
  };
  /// How far a rule has come in an estimate.
  struct Progress {
    std::uint32_t open = 0; ///< number of needs that are not met
    std::uint32_t sum = 0;  ///< of the costs of those that are, and of its step
  };
  /// Facts by the costs at which they were reached, each at least once; first in, first out.
  class Queue {
  public:
    void clear();
    void push(FactId fact, std::uint32_t cost);
    /// The next fact of these costs; kNone if there is none now.
    [[nodiscard]] FactId take(std::uint32_t cost);
    [[nodiscard]] std::uint32_t end() const { return static_cast<std::uint32_t>(lists.size()); }

  private:
    struct Entry {
      FactId fact = 0;
      std::uint32_t next = kNone; ///< of the same costs
    };
    struct List {
      std::uint32_t first = kNone;
      std::uint32_t last = kNone;
    };
    std::vector<Entry> entries;
    std::vector<List> lists; ///< by costs
  };
  /// A way through the code of a path.
  struct Way {
    std::size_t at = 0; ///< the next instruction
    std::size_t length = 0;
    std::vector<FactId> needs;
    std::vector<FactId> makes;
    Bits assigned;
    std::vector<Assignment> counting; ///< whose values depend on their targets alone
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
  void addGoals(NodeId node, bool isNegated);
  void addTransition(TransitionId id, const Goal& goal);
  void addWays(const Path& path, const Goal& goal, Way way, std::size_t& left);
  void addWay(Way way, std::size_t& left);
  void require(NodeId node, bool isNegated, Way& way);
  void assign(const Assignment& assignment, Way& way);
  [[nodiscard]] bool isCounting(const Assignment& assignment) const;
  void addCounting(const Way& way);
  [[nodiscard]] Bits relevantFacts() const;
  void keepRelevant();
  void index();
  void apply(RuleId rule);
  void reach(FactId fact, std::uint32_t cost, RuleId by);
  void reachInitial(const Word* state);
  [[nodiscard]] bool reachGoal(const Word* state);
  template <class Each> void eachOfPlan(Each each);

  const System& system;
  const System& laidOut;
  LimitWatch& limits;
  std::vector<std::int64_t> values; ///< by cell: those with which a comparison is tried
  FactId facts = 0;                 ///< number of facts
  std::vector<Rule> rules;
  Lists uses;                 ///< by fact: the rules that need it
  Lists makes;                ///< by rule
  std::vector<RuleId> always; ///< rules that need nothing
  std::vector<Progress> none; ///< by rule: before an estimate
  std::map<CellId, FactId> firstOf;
  std::vector<TrackedCell> tracked;
  std::map<std::pair<NodeId, bool>, FactId> conditions;
  FactId wanted = 0;
  std::vector<FactId> goals; ///< `wanted` is the conjunction of these

  // of one estimate:
  std::vector<std::uint32_t> costs; ///< by fact
  std::vector<RuleId> makers;       ///< by fact: the rule of these costs; kNone: from the start
  std::vector<Progress> progress;   ///< by rule
  Queue queue;
  std::vector<bool> isUsed; ///< by rule: whether it is in the plan
  std::vector<FactId> todo; ///< needs of the plan
};

} // namespace proskill::verify
