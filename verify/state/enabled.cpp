#include "verify/state/enabled.h"

#include "verify/state/evaluate.h"

#include <utility>

namespace proskill::verify {

Enabling::Enabling(const System& of, const Bits& dropped) : system(of) {
  urgent = clocked = TransitionSet((system.transitions.size() + 63) / 64);
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    if (dropped.contains(i)) continue;
    if (system.transitions[i].urgent) insert(urgent, i);
    if (system.transitions[i].clock != kNone) insert(clocked, i);
  }
  findPlaces(dropped);
  findAffected(dropped);
}

void Enabling::findPlaces(const Bits& dropped) {
  for (const auto& instance : system.instances) takingPart.emplace_back(instance.locations.size());
  starting = takingPart;
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    if (dropped.contains(i)) continue;
    const auto& parts = system.transitions[i].parts;
    const Path& first = system.paths[parts.front()];
    starting[first.instance][first.location].push_back(i);
    for (auto part : parts)
      takingPart[system.paths[part].instance][system.paths[part].location].push_back(i);
  }
}

void Enabling::findAffected(const Bits& dropped) {
  std::vector<std::vector<TransitionId>> readers(system.cells.size());
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    if (dropped.contains(i)) continue;
    Bits others = system.transitions[i].guardReads;
    for (auto part : system.transitions[i].parts)
      others.erase(system.instances[system.paths[part].instance].location);
    others.each([&](CellId cell) { readers[cell].push_back(i); });
  }
  TransitionSet all(urgent.size());
  for (const auto& transition : system.transitions) {
    std::vector<std::uint32_t> words;
    transition.writes.each([&](CellId cell) {
      for (auto reader : readers[cell]) {
        if (all[reader / 64] == 0) words.push_back(reader / 64);
        insert(all, reader);
      }
    });
    auto& slices = affected.emplace_back();
    for (auto word : words) slices.push_back({word, std::exchange(all[word], 0)});
  }
}

void Enabling::look(TransitionId transition, const Word* state, TransitionSet& enabled) const {
  if (isEnabled(system, transition, state))
    insert(enabled, transition);
  else
    erase(enabled, transition);
}

void Enabling::compute(const Word* state, TransitionSet& enabled) const {
  enabled.assign(urgent.size(), 0);
  for (InstanceId i = 0; i < system.instances.size(); ++i)
    for (auto transition : starting[i][locationOf(i, state)])
      if (isEnabled(system, transition, state)) insert(enabled, transition);
}

void Enabling::refresh(const TransitionSet& changed, const Word* state,
                       TransitionSet& enabled) const {
  eachIn(changed, [&](TransitionId transition) { look(transition, state, enabled); });
}

void Enabling::update(TransitionId fired, const Word* state, TransitionSet& enabled) const {
  for (auto part : system.transitions[fired].parts) {
    const Path& path = system.paths[part];
    for (auto transition : takingPart[path.instance][path.location]) erase(enabled, transition);
  }
  for (auto part : system.transitions[fired].parts) {
    const InstanceId instance = system.paths[part].instance;
    for (auto transition : takingPart[instance][locationOf(instance, state)])
      look(transition, state, enabled);
  }
  for (const auto& slice : affected[fired])
    for (Word rest = slice.bits; rest != 0; rest &= rest - 1)
      look(slice.word * 64 + static_cast<TransitionId>(std::countr_zero(rest)), state, enabled);
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
