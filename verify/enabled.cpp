#include "verify/enabled.h"

#include "verify/evaluate.h"

namespace proskill::verify {

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

void Enabling::evaluate(std::size_t k, Word candidates, const Word* state,
                        TransitionSet& enabled) const {
  for (; candidates != 0; candidates &= candidates - 1) {
    const auto bit = static_cast<std::size_t>(std::countr_zero(candidates));
    if (isEnabled(system, static_cast<TransitionId>(k * 64 + bit), state))
      enabled[k] |= Word{1} << bit;
  }
}

/// Of the k-th word of transitions, those whose instances are where they need them.
Word Enabling::here(std::size_t k, const Word* state) const {
  Word candidates = ~Word{0};
  for (InstanceId i = 0; i < system.instances.size() && candidates != 0; ++i)
    candidates &= possible[i][locationOf(i, state)][k];
  return candidates;
}

void Enabling::compute(const Word* state, TransitionSet& enabled) const {
  enabled.assign(urgent.size(), 0);
  for (std::size_t k = 0; k < enabled.size(); ++k) evaluate(k, here(k, state), state, enabled);
}

void Enabling::refresh(const TransitionSet& changed, const Word* state,
                       TransitionSet& enabled) const {
  for (std::size_t k = 0; k < enabled.size(); ++k) {
    enabled[k] &= ~changed[k];
    evaluate(k, changed[k], state, enabled);
  }
}

void Enabling::update(TransitionId fired, const Word* state, TransitionSet& enabled) const {
  const auto& parts = system.transitions[fired].parts;
  for (std::size_t k = 0; k < enabled.size(); ++k) {
    Word candidates = affected[fired][k];
    if (candidates == 0) continue;
    enabled[k] &= ~candidates;
    for (auto part : parts) {
      const InstanceId instance = system.paths[part].instance;
      candidates &= possible[instance][locationOf(instance, state)][k];
    }
    evaluate(k, candidates, state, enabled);
  }
}

std::size_t Enabling::locationOf(InstanceId instance, const Word* state) const {
  return static_cast<std::size_t>(readCell(system, system.instances[instance].location, state));
}

bool Enabling::isUrgent(const TransitionSet& enabled) const {
  for (std::size_t k = 0; k < enabled.size(); ++k)
    if ((enabled[k] & urgent[k]) != 0) return true;
  return false;
}

SignatureId Enabling::signature(const TransitionSet& enabled, bool isUrgent, Timing& timing) const {
  return timing.signature(isUrgent, enabled, clocked);
}

} // namespace proskill::verify
