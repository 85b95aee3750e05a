#include "runtime/executor/stopwatch.h"

#include <algorithm>

namespace proskill::runtime {

Stopwatch::Stopwatch(const Executable& of)
    : executable(of),
      actions(of.actions.size()),
      stretches(of.stretches.size()),
      events(of.everySpans.size()) {
  for (std::size_t i = 0; i < events.size(); ++i)
    events[i].isRunning = of.everySpans[i].has_value();
}

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
  for (std::size_t i = 0; i < events.size(); ++i)
    if (events[i].isRunning) look(events[i], *executable.everySpans[i]);
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

Stopwatch::Subject Stopwatch::ofEvent(std::uint32_t signal) const {
  static const Span none;
  const auto& of = executable.model.signals[signal];
  const auto& span = executable.everySpans[signal];
  return {of.name, span ? *span : none, of.everyOrigin, "comes sooner than its `:every` says",
          "comes later than its `:every` says"};
}

} // namespace proskill::runtime
