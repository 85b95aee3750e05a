#include "runtime/machine/machine.h"

#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

#include <algorithm>

namespace proskill::runtime {

using verify::contains;
using verify::TransitionId;

namespace {

/// How long what has no upper bound is put off at most, when it is drawn.
constexpr Nanoseconds kLongest = 10 * kSecond;

verify::TransitionSet emptySet(const verify::System& system) {
  return verify::TransitionSet((system.transitions.size() + 63) / 64);
}

} // namespace

Machine::Machine(const Executable& of, std::uint64_t seed)
    : executable(of),
      system(of.system),
      enabling(of.system),
      random(seed),
      urgentOnes(emptySet(of.system)),
      timedOnes(urgentOnes),
      enabled(urgentOnes),
      timedBefore(urgentOnes),
      dates(of.system.transitions.size()),
      now(verify::initialState(of.system)),
      before(now) {
  for (TransitionId id = 0; id < system.transitions.size(); ++id) {
    const auto role = executable.handling[id].role;
    if (role == Role::Urgent) verify::insert(urgentOnes, id);
    if (role == Role::Timed || role == Role::Drawn) verify::insert(timedOnes, id);
  }
  enabling.compute(now.data(), enabled);
  for (std::size_t k = 0; k < enabled.size(); ++k)
    for (auto rest = enabled[k] & timedOnes[k]; rest != 0; rest &= rest - 1) {
      const auto id = static_cast<TransitionId>(k * 64 + std::countr_zero(rest));
      dates[id] = drawn(id);
    }
}

std::optional<TransitionId> Machine::urgent() {
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < enabled.size(); ++k)
    count += static_cast<std::uint64_t>(std::popcount(enabled[k] & urgentOnes[k]));
  if (count == 0) return std::nullopt;
  auto chosen = count == 1 ? 0 : random.below(count);
  for (std::size_t k = 0;; ++k)
    for (auto rest = enabled[k] & urgentOnes[k]; rest != 0; rest &= rest - 1)
      if (chosen-- == 0) return static_cast<TransitionId>(k * 64 + std::countr_zero(rest));
}

std::optional<Machine::Due> Machine::due() const {
  std::optional<Due> first;
  for (std::size_t k = 0; k < enabled.size(); ++k)
    for (auto rest = enabled[k] & timedOnes[k]; rest != 0; rest &= rest - 1) {
      const auto id = static_cast<TransitionId>(k * 64 + std::countr_zero(rest));
      if (!first || dates[id] < first->date) first = Due{id, dates[id]};
    }
  return first;
}

std::optional<TransitionId> Machine::at(std::uint32_t port) const {
  if (port == verify::kNone) return std::nullopt;
  for (const auto id : executable.atPort[port])
    if (contains(enabled, id)) return id;
  return std::nullopt;
}

bool Machine::take(TransitionId step, Nanoseconds date) {
  passed.clear();
  before = now;
  for (std::size_t k = 0; k < enabled.size(); ++k) timedBefore[k] = enabled[k] & timedOnes[k];
  if (verify::fire(system, step, now.data(), passed) != verify::Outcome::Done) return false;
  enabling.update(step, now.data(), enabled);
  setDates(step, date);
  return true;
}

void Machine::setDates(TransitionId step, Nanoseconds date) {
  for (std::size_t k = 0; k < enabled.size(); ++k)
    for (auto rest = enabled[k] & timedOnes[k]; rest != 0; rest &= rest - 1) {
      const auto id = static_cast<TransitionId>(k * 64 + std::countr_zero(rest));
      if (!contains(timedBefore, id) || !goesOn(step, id)) dates[id] = date + drawn(id);
    }
}

/// Whether the time of `other` runs on while the step is taken.
bool Machine::goesOn(TransitionId step, TransitionId other) const {
  if (step == other) return false;
  const auto& consumed = system.transitions[step].consumed;
  return std::ranges::none_of(system.transitions[other].parts, [&](verify::PathId part) {
    return consumed.contains(system.paths[part].instance);
  });
}

Nanoseconds Machine::drawn(TransitionId step) {
  const auto& [role, span, action, stretch] = executable.handling[step];
  if (role != Role::Drawn) return span.first;
  return random.between(span.first, span.last.value_or(span.first + kLongest));
}

std::int64_t Machine::location(verify::InstanceId instance) const {
  return verify::readCell(system, system.instances[instance].location, now.data());
}

std::int64_t Machine::locationBefore(verify::InstanceId instance) const {
  return verify::readCell(system, system.instances[instance].location, before.data());
}

} // namespace proskill::runtime
