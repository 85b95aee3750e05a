#include "runtime/executor/stopwatch.h"

#include <algorithm>

namespace proskill::runtime {

Stopwatch::Stopwatch(const Executable& of)
    : executable(of), actions(of.actions.size()), stretches(of.stretches.size()) {}

void Stopwatch::start(std::uint32_t action, Nanoseconds date) {
  actions[action] = {.isRunning = true, .begin = date};
}

std::optional<Nanoseconds> Stopwatch::nextOvershoot() const {
  std::optional<Nanoseconds> first;
  const auto look = [&](const Measure& measure, const Span& span) {
    if (!measure.isRunning || measure.isLate || !span.last) return;
    const auto date = measure.begin + *span.last + 1;
    first = std::min(first.value_or(date), date);
  };
  for (std::size_t i = 0; i < actions.size(); ++i) look(actions[i], executable.actions[i].span);
  for (std::size_t i = 0; i < stretches.size(); ++i)
    look(stretches[i], executable.stretches[i].span);
  return first;
}

Stopwatch::Subject Stopwatch::ofAction(std::uint32_t action) const {
  const auto& of = executable.model.performed[action];
  return {of.skill, executable.actions[action].span, of.intervalOrigin};
}

Stopwatch::Subject Stopwatch::ofStretch(std::uint32_t stretch) const {
  const auto& of = executable.model.measured[stretch];
  return {of.skill, executable.stretches[stretch].span, of.origin};
}

} // namespace proskill::runtime
