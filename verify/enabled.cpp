#include "verify/enabled.h"

#include "verify/evaluate.h"

namespace proskill::verify {

namespace {

void insert(TransitionSet& set, TransitionId id) { set[id / 64] |= Word{1} << (id % 64); }

} // namespace

Enabling::Enabling(const System& of, const Bits& dropped) : system(of) {
  const TransitionSet none((system.transitions.size() + 63) / 64);
  urgent = clocked = none;
  affected.assign(system.transitions.size(), none);
  for (const auto& instance : system.instances)
    possible.emplace_back(instance.locations.size(), none);
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    if (dropped.contains(i)) continue;
    const Transition& transition = system.transitions[i];
    if (transition.urgent) insert(urgent, i);
    if (transition.clock != kNone) insert(clocked, i);
    for (TransitionId j = 0; j < system.transitions.size(); ++j)
      if (transition.writes.meets(system.transitions[j].guardReads)) insert(affected[i], j);
    for (InstanceId instance = 0; instance < system.instances.size(); ++instance) {
      const Path* own = nullptr;
      for (auto part : transition.parts)
        if (system.paths[part].instance == instance) own = &system.paths[part];
      for (std::uint32_t at = 0; at < system.instances[instance].locations.size(); ++at)
        if (!own || own->location == at) insert(possible[instance][at], i);
    }
  }
}

void Enabling::evaluate(const TransitionSet& candidates, const Word* state,
                        TransitionSet& enabled) const {
  eachIn(candidates, [&](TransitionId id) {
    if (isEnabled(system, id, state)) insert(enabled, id);
  });
}

void Enabling::compute(const Word* state, TransitionSet& enabled) const {
  TransitionSet candidates((system.transitions.size() + 63) / 64, ~Word{0});
  if (system.transitions.size() % 64 != 0)
    candidates.back() = ~Word{0} >> (64 - system.transitions.size() % 64);
  for (InstanceId i = 0; i < system.instances.size(); ++i) {
    const auto& here = possible[i][readCell(system, system.instances[i].location, state)];
    for (std::size_t k = 0; k < candidates.size(); ++k) candidates[k] &= here[k];
  }
  enabled.assign(candidates.size(), 0);
  evaluate(candidates, state, enabled);
}

void Enabling::update(TransitionId fired, const Word* state, TransitionSet& enabled) const {
  TransitionSet candidates = affected[fired];
  for (std::size_t k = 0; k < candidates.size(); ++k) enabled[k] &= ~candidates[k];
  for (auto part : system.transitions[fired].parts) {
    const InstanceId instance = system.paths[part].instance;
    const auto& here =
        possible[instance][readCell(system, system.instances[instance].location, state)];
    for (std::size_t k = 0; k < candidates.size(); ++k) candidates[k] &= here[k];
  }
  evaluate(candidates, state, enabled);
}

bool Enabling::isUrgent(const TransitionSet& enabled) const {
  for (std::size_t k = 0; k < enabled.size(); ++k)
    if ((enabled[k] & urgent[k]) != 0) return true;
  return false;
}

SignatureId Enabling::signature(const TransitionSet& enabled, Timing& timing) const {
  std::vector<TransitionId> timed;
  for (std::size_t k = 0; k < enabled.size(); ++k)
    for (Word rest = enabled[k] & clocked[k]; rest != 0; rest &= rest - 1)
      timed.push_back(static_cast<TransitionId>(k * 64 + std::countr_zero(rest)));
  return timing.signature(isUrgent(enabled), std::move(timed));
}

} // namespace proskill::verify
