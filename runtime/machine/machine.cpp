#include "runtime/machine/machine.h"

#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

namespace proskill::runtime {

using verify::contains;
using verify::TransitionId;

namespace {

/// Maximum random delay of a step without an upper bound.
constexpr Nanoseconds kLongest = 10 * kSecond;

verify::TransitionSet emptySet(const verify::System& system) {
  return verify::TransitionSet((system.transitions.size() + 63) / 64);
}

} // namespace

Machine::Machine(const Executable& of, std::uint64_t seed)
    : executable(of),
      system(of.system),
      enabling(*of.enabling),
      random(seed),
      urgentOnes(emptySet(of.system)),
      timedOnes(urgentOnes),
      enabled(urgentOnes),
      timedBefore(urgentOnes),
      dates(of.system.transitions.size()),
      taken(of.system.transitions.size(), -1),
      now(verify::initialState(of.system)),
      before(now) {
  for (TransitionId id = 0; id < system.transitions.size(); ++id) {
    const auto role = executable.handling[id].role;
    if (role == Role::Urgent) verify::insert(urgentOnes, id);
    if (role == Role::Timed || role == Role::Drawn) verify::insert(timedOnes, id);
  }
  enabling.compute(now.data(), enabled);
  verify::eachInBoth(enabled, timedOnes, [&](TransitionId id) { dates[id] = dateOf(id, 0); });
}

std::optional<TransitionId> Machine::urgent() {
  std::uint64_t count = 0;
  std::optional<TransitionId> found;
  verify::eachInBoth(enabled, urgentOnes, [&](TransitionId id) {
    if (count++ == 0) found = id;
  });
  if (count <= 1) return found;
  auto chosen = random.below(count);
  verify::eachInBoth(enabled, urgentOnes, [&](TransitionId id) {
    if (chosen-- == 0) found = id;
  });
  return found;
}

std::optional<Machine::Due> Machine::due() const {
  std::optional<Due> first;
  verify::eachInBoth(enabled, timedOnes, [&](TransitionId id) {
    if (!first || dates[id] < first->date) first = Due{id, dates[id]};
  });
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
  taken[step] = date;
  for (std::size_t k = 0; k < enabled.size(); ++k) timedBefore[k] = enabled[k] & timedOnes[k];
  if (verify::fire(system, step, now.data(), passed) != verify::Outcome::Done) return false;
  enabling.update(step, now.data(), enabled);
  setDates(step, date);
  return true;
}

void Machine::setDates(TransitionId step, Nanoseconds date) {
  verify::eachInBoth(enabled, timedOnes, [&](TransitionId id) {
    const bool goesOn =
        contains(timedBefore, id) && id != step && !verify::disturbs(system, step, id);
    if (!goesOn) dates[id] = dateOf(id, date);
  });
}

Nanoseconds Machine::dateOf(TransitionId step, Nanoseconds date) {
  const auto& [role, span, action, stretch] = executable.handling[step];
  if (role == Role::Drawn)
    return date + random.between(span.first, span.last.value_or(span.first + kLongest));
  // A step that needs no time happens once at a date: otherwise a loop might never let time pass.
  const bool again = span.first == 0 && taken[step] == date;
  return date + (again ? soonAfter(0, span.last) : span.first);
}

std::int64_t Machine::location(verify::InstanceId instance) const {
  return verify::readCell(system, system.instances[instance].location, now.data());
}

std::int64_t Machine::locationBefore(verify::InstanceId instance) const {
  return verify::readCell(system, system.instances[instance].location, before.data());
}

} // namespace proskill::runtime
