#include "verify/guide/goal_distance.h"

#include "verify/model/nodes.h"
#include "verify/state/evaluate.h"

#include <algorithm>

namespace proskill::verify {

namespace {

constexpr std::int64_t kMostTracked = 256;      ///< of a cell; larger ones count as known
constexpr std::int64_t kMostCombinations = 256; ///< of a comparison
constexpr std::uint32_t kMostCost = 1U << 16U;
constexpr std::size_t kMostWays = 64;     ///< through the code of a path
constexpr std::size_t kLongestWay = 1000; ///< in instructions

std::int64_t sizeOf(const Cell& cell) { return cell.high - cell.low + 1; }

bool isTracked(const Cell& cell) { return sizeOf(cell) <= kMostTracked; }

} // namespace

bool GoalDistance::isFor(const Goal& goal) {
  switch (goal.kind) {
  case GoalKind::Events: return true;
  case GoalKind::Condition: return !goal.ofSteps;
  case GoalKind::Deadlock:
  case GoalKind::Stuck:
  case GoalKind::Error:
  case GoalKind::Run:
  case GoalKind::Lost:
  case GoalKind::Longest:
  case GoalKind::Shortest:
  case GoalKind::Unsupported: return false;
  }
  std::unreachable();
}

GoalDistance::GoalDistance(const System& of, const System& withLayout, const Goal& goal,
                           const Bits& dropped, LimitWatch& watch)
    : system(of), laidOut(withLayout), limits(watch), values(of.cells.size()) {
  wanted = goal.kind == GoalKind::Condition ? condition(goal.condition, false) : newFact();
  if (goal.kind == GoalKind::Condition) addGoals(goal.condition, false);
  for (TransitionId i = 0; i < system.transitions.size(); ++i)
    if (!dropped.contains(i)) addTransition(i, goal);
  keepRelevant();
  index();
  costs.resize(facts);
  makers.resize(facts);
}

GoalDistance::FactId GoalDistance::newFact() { return facts++; }

void GoalDistance::addRule(std::vector<FactId> needs, std::vector<FactId> to, TransitionId step) {
  rules.push_back({std::move(needs), std::move(to), step});
}

/// The facts from which rules lead to the goal.
Bits GoalDistance::relevantFacts() const {
  std::vector<std::vector<RuleId>> makersOf(facts);
  for (RuleId i = 0; i < rules.size(); ++i)
    for (auto fact : rules[i].makes) makersOf[fact].push_back(i);
  Bits relevant;
  std::vector<FactId> todo{wanted};
  while (!todo.empty()) {
    const FactId fact = todo.back();
    todo.pop_back();
    if (relevant.contains(fact)) continue;
    relevant.insert(fact);
    for (auto rule : makersOf[fact])
      todo.insert(todo.end(), rules[rule].needs.begin(), rules[rule].needs.end());
  }
  return relevant;
}

/// Forgets facts from which nothing leads to the goal. Estimates stay the same.
void GoalDistance::keepRelevant() {
  const Bits relevant = relevantFacts();
  for (auto& rule : rules)
    std::erase_if(rule.makes, [&](FactId it) { return !relevant.contains(it); });
  std::erase_if(rules, [](const Rule& it) { return it.makes.empty(); });
  std::erase_if(tracked, [&](const TrackedCell& it) {
    for (FactId i = 0; i < static_cast<FactId>(sizeOf(system.cells[it.cell])); ++i)
      if (relevant.contains(it.first + i)) return false;
    return true;
  });
}

void GoalDistance::index() {
  std::vector<std::vector<RuleId>> users(facts);
  for (RuleId i = 0; i < rules.size(); ++i) {
    for (auto fact : rules[i].needs) users[fact].push_back(i);
    if (rules[i].needs.empty()) always.push_back(i);
    makes.add(rules[i].makes);
    none.push_back({static_cast<std::uint32_t>(rules[i].needs.size()), rules[i].length()});
  }
  for (const auto& some : users) uses.add(some);
}

void GoalDistance::Lists::add(const std::vector<std::uint32_t>& list) {
  items.insert(items.end(), list.begin(), list.end());
  ends.push_back(static_cast<std::uint32_t>(items.size()));
}

/// \pre the cell is tracked
GoalDistance::FactId GoalDistance::factOf(CellId cell, std::int64_t value) {
  const auto [entry, isNew] = firstOf.try_emplace(cell, facts);
  if (isNew) {
    facts += static_cast<FactId>(sizeOf(system.cells[cell]));
    tracked.push_back({cell, entry->second});
  }
  return entry->second + static_cast<FactId>(value - system.cells[cell].low);
}

std::vector<GoalDistance::FactId> GoalDistance::factsOf(CellId cell) {
  std::vector<FactId> all;
  for (auto value = system.cells[cell].low; value <= system.cells[cell].high; ++value)
    all.push_back(factOf(cell, value));
  return all;
}

GoalDistance::FactId GoalDistance::condition(NodeId node, bool isNegated) {
  if (const auto known = conditions.find({node, isNegated}); known != conditions.end())
    return known->second;
  limits.check();
  const FactId made = madeCondition(node, isNegated);
  conditions.emplace(std::pair{node, isNegated}, made);
  return made;
}

GoalDistance::FactId GoalDistance::madeCondition(NodeId id, bool isNegated) {
  const Node& node = system.nodes[id];
  if (node.op == NodeOp::Not) return condition(node.a, !isNegated);
  if (node.op != NodeOp::And && node.op != NodeOp::Or) return comparison(id, isNegated);
  const FactId left = condition(node.a, isNegated);
  const FactId right = condition(node.b, isNegated);
  const FactId made = newFact();
  if ((node.op == NodeOp::And) != isNegated) {
    addRule({left, right}, {made});
  } else {
    addRule({left}, {made});
    addRule({right}, {made});
  }
  return made;
}

void GoalDistance::addGoals(NodeId id, bool isNegated) {
  const Node& node = system.nodes[id];
  if (node.op == NodeOp::Not) return addGoals(node.a, !isNegated);
  if (node.op != (isNegated ? NodeOp::Or : NodeOp::And))
    return goals.push_back(condition(id, isNegated));
  addGoals(node.a, isNegated);
  addGoals(node.b, isNegated);
}

/// Tries a condition with all values of its cells. One with too many of them counts as true.
GoalDistance::FactId GoalDistance::comparison(NodeId node, bool isNegated) {
  Bits read;
  addReads(system, node, read);
  std::vector<CellId> cells;
  std::int64_t combinations = 1;
  read.each([&](CellId cell) {
    cells.push_back(cell);
    combinations *= std::min(sizeOf(system.cells[cell]), kMostCombinations + 1);
    combinations = std::min(combinations, kMostCombinations + 1);
  });
  const FactId made = newFact();
  if (combinations > kMostCombinations) {
    addRule({}, {made});
    return made;
  }
  for (std::int64_t i = 0; i < combinations; ++i) {
    auto rest = i;
    for (auto cell : cells) {
      values[cell] = system.cells[cell].low + rest % sizeOf(system.cells[cell]);
      rest /= sizeOf(system.cells[cell]);
    }
    const auto result = evaluateUnpacked(system, node, values);
    if (!result || (*result != 0) == isNegated) continue;
    std::vector<FactId> needs;
    for (auto cell : cells) needs.push_back(factOf(cell, values[cell]));
    addRule(std::move(needs), {made});
  }
  return made;
}

void GoalDistance::addTransition(TransitionId id, const Goal& goal) {
  const Transition& transition = system.transitions[id];
  const FactId taken = newFact();
  std::vector<FactId> makes{taken};
  if (std::ranges::any_of(transition.events, [&](EventId it) { return goal.events.contains(it); }))
    makes.push_back(wanted);
  addRule({condition(transition.guard, false)}, std::move(makes), id);
  for (auto part : transition.parts) {
    Way way;
    way.needs = {taken};
    std::size_t left = kMostWays;
    addWays(system.paths[part], goal, std::move(way), left);
  }
}

/// Adds a rule for each way through the code of a path, from an instruction on. Conditions on what
/// the way itself assigns count as true.
/// \param left number of ways that may be added yet
void GoalDistance::addWays(const Path& path, const Goal& goal, Way way, std::size_t& left) {
  for (; left > 0 && way.length < kLongestWay && way.at < path.code.size(); ++way.length) {
    limits.check();
    const auto& instruction = path.code[way.at++];
    if (instruction.event != kNone && goal.events.contains(instruction.event))
      way.makes.push_back(wanted);
    switch (instruction.kind) {
    case InstructionKind::On: require(instruction.node, false, way); break;
    case InstructionKind::JumpUnless: {
      Way other = way;
      other.at = instruction.last;
      require(instruction.node, true, other);
      addWays(path, goal, std::move(other), left);
      require(instruction.node, false, way);
      break;
    }
    case InstructionKind::Assign:
    case InstructionKind::Store:
      for (auto i = instruction.first; i < instruction.last; ++i) assign(path.assignments[i], way);
      break;
    case InstructionKind::Jump: way.at = instruction.last; break;
    case InstructionKind::To: {
      const CellId location = system.instances[path.instance].location;
      if (isTracked(system.cells[location]))
        way.makes.push_back(factOf(location, instruction.last));
      return addWay(std::move(way), left);
    }
    case InstructionKind::Loop: return addWay(std::move(way), left);
    case InstructionKind::Fail: return;
    case InstructionKind::Tag:
    case InstructionKind::Origin: break;
    }
  }
}

void GoalDistance::addWay(Way way, std::size_t& left) {
  if (left == 0 || (way.makes.empty() && way.counting.empty())) return;
  --left;
  addCounting(way);
  if (way.makes.empty()) return;
  addRule(std::move(way.needs), std::move(way.makes));
}

void GoalDistance::require(NodeId node, bool isNegated, Way& way) {
  Bits read;
  addReads(system, node, read);
  if (!read.meets(way.assigned)) way.needs.push_back(condition(node, isNegated));
}

/// Adds a rule for each value that a cell is counted from.
void GoalDistance::addCounting(const Way& way) {
  for (const auto& [target, value, _] : way.counting) {
    const Cell& cell = system.cells[target];
    for (auto before = cell.low; before <= cell.high; ++before) {
      values[target] = before;
      const auto after = evaluateUnpacked(system, value, values);
      if (!after || *after == before || *after < cell.low || *after > cell.high) continue;
      auto needs = way.needs;
      needs.push_back(factOf(target, before));
      rules.push_back({std::move(needs), {factOf(target, *after)}, kNone, true});
    }
  }
}

/// Whether the new value depends on the old one alone.
bool GoalDistance::isCounting(const Assignment& assignment) const {
  Bits read;
  addReads(system, assignment.value, read);
  Bits own;
  own.insert(assignment.target);
  return read == own;
}

void GoalDistance::assign(const Assignment& assignment, Way& way) {
  const bool isFirst = !way.assigned.contains(assignment.target);
  way.assigned.insert(assignment.target);
  const Node& value = system.nodes[assignment.value];
  const Cell& cell = system.cells[assignment.target];
  if (!isTracked(cell)) return;
  if (isFirst && isCounting(assignment)) {
    way.counting.push_back(assignment);
    return;
  }
  if (value.op != NodeOp::Number)
    for (auto fact : factsOf(assignment.target)) way.makes.push_back(fact);
  else if (value.number >= cell.low && value.number <= cell.high)
    way.makes.push_back(factOf(assignment.target, value.number));
}

void GoalDistance::reach(FactId fact, std::uint32_t cost, RuleId by) {
  if (costs[fact] <= cost || cost > kMostCost) return;
  costs[fact] = cost;
  makers[fact] = by;
  if (fact == wanted || !uses.at(fact).empty()) queue.push(fact, cost);
}

void GoalDistance::Queue::clear() {
  entries.clear();
  lists.clear();
}

void GoalDistance::Queue::push(FactId fact, std::uint32_t cost) {
  const auto entry = static_cast<std::uint32_t>(entries.size());
  entries.push_back({fact});
  if (lists.size() <= cost) lists.resize(cost + 1);
  auto& [first, last] = lists[cost];
  (first == kNone ? first : entries[last].next) = entry;
  last = entry;
}

GoalDistance::FactId GoalDistance::Queue::take(std::uint32_t cost) {
  auto& first = lists[cost].first;
  if (first == kNone) return kNone;
  const Entry& taken = entries[first];
  first = taken.next;
  return taken.fact;
}

void GoalDistance::reachInitial(const Word* state) {
  for (const auto& [cell, first] : tracked) {
    const Cell& of = laidOut.cells[cell];
    if (of.mask != 0 || of.low == of.high)
      reach(first + static_cast<FactId>(readCell(laidOut, cell, state) - of.low), 0, kNone);
    else // not part of the state
      for (FactId i = 0; i < static_cast<FactId>(sizeOf(of)); ++i) reach(first + i, 0, kNone);
  }
}

/// Follows a rule all of whose needs are met.
void GoalDistance::apply(RuleId rule) {
  for (auto fact : makes.at(rule)) reach(fact, progress[rule].sum, rule);
}

/// Dijkstra's algorithm: facts in the order of their costs.
bool GoalDistance::reachGoal(const Word* state) {
  std::ranges::fill(costs, kFar);
  queue.clear();
  progress = none;
  reachInitial(state);
  for (auto rule : always) apply(rule);
  for (std::uint32_t cost = 0; cost < queue.end(); ++cost)
    for (FactId fact = queue.take(cost); fact != kNone; fact = queue.take(cost)) {
      if (costs[fact] != cost) continue; // reached at a lower cost
      if (fact == wanted) return true;
      for (auto rule : uses.at(fact)) {
        progress[rule].sum += cost;
        if (--progress[rule].open == 0) apply(rule);
      }
    }
  return false;
}

/// Calls `each` with each rule by which the goal was reached.
template <class Each> void GoalDistance::eachOfPlan(Each each) {
  isUsed.assign(rules.size(), false);
  todo.assign(1, wanted);
  while (!todo.empty()) {
    const RuleId rule = makers[todo.back()];
    todo.pop_back();
    if (rule == kNone || isUsed[rule]) continue;
    isUsed[rule] = true;
    each(rules[rule]);
    todo.insert(todo.end(), rules[rule].needs.begin(), rules[rule].needs.end());
  }
}

GoalDistance::Estimate GoalDistance::from(const Word* state) {
  if (!reachGoal(state)) return {};
  Estimate estimate{0, 0};
  eachOfPlan([&](const Rule& rule) {
    estimate.steps += rule.length();
    estimate.left += rule.counts ? 1 : 0;
  });
  for (auto goal : goals) estimate.left += costs[goal] == 0 ? 0 : 1;
  return estimate;
}

Bits GoalDistance::usefulSteps(const Word* state) {
  Bits steps;
  if (!reachGoal(state)) return steps;
  eachOfPlan([&](const Rule& rule) {
    if (rule.step != kNone) steps.insert(rule.step);
  });
  return steps;
}

} // namespace proskill::verify
