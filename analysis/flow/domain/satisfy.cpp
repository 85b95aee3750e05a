#include "analysis/flow/domain/satisfy.h"

#include <algorithm>

namespace proskill::analysis::flow {

namespace {

constexpr std::size_t kMostStates = 4096;

/// Gives one variable after the other each of its values, and stops where a condition is false.
class Enumeration {
public:
  Enumeration(std::span<const Condition> conditions, const std::set<Slot>& slots,
              const std::function<bool(const State&)>& wanted)
      : conditions(conditions), slots(slots.begin(), slots.end()), wanted(wanted) {}

  bool find(const State& state, std::size_t next) {
    if (++tried > kMostStates) return true;
    const auto mayBeTrue = [&](const Condition& each) { return mayHold(state, each); };
    if (!std::ranges::all_of(conditions, mayBeTrue)) return false;
    if (next == slots.size()) return wanted(state);
    bool found = false;
    forEach(state.values[slots[next]], [&](unsigned value) {
      if (found) return;
      State narrowed = state;
      narrowed.values[slots[next]] = ValueSet::of(value);
      found = find(narrowed, next + 1);
    });
    return found;
  }

private:
  std::span<const Condition> conditions;
  std::vector<Slot> slots;
  const std::function<bool(const State&)>& wanted;
  std::size_t tried = 0;
};

} // namespace

void collectSlots(const Condition& condition, std::set<Slot>& slots) {
  if (condition.kind == Condition::Kind::Member) slots.insert(condition.slot);
  slots.insert(condition.slots.begin(), condition.slots.end());
  for (const Condition& operand : condition.operands) collectSlots(operand, slots);
}

bool isPossible(const State& within, std::span<const Condition> conditions, std::set<Slot> slots,
                const std::function<bool(const State&)>& wanted) {
  if (!within.reachable) return false;
  for (const Condition& each : conditions) collectSlots(each, slots);
  return Enumeration(conditions, slots, wanted).find(within, 0);
}

bool mayHoldTogether(const State& within, std::span<const Condition> conditions) {
  return isPossible(within, conditions, {}, [](const State&) { return true; });
}

bool mayFailBeside(const State& within, std::span<const Condition> held,
                   const Condition& condition) {
  std::set<Slot> slots;
  collectSlots(condition, slots);
  return isPossible(within, held, std::move(slots),
                    [&](const State& state) { return mayFail(state, condition); });
}

} // namespace proskill::analysis::flow
