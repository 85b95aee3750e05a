#include "ide/verdicts/verification.h"

#include <fmt/ranges.h>

/// The parts of a trace in the program's terms. They are a file of their own, since recordings of
/// runs need no more of this folder.
namespace proskill::ide {

using syntax::Rational;

std::optional<analysis::Location> locate(const fiacre::Origin& origin) {
  if (origin.begin == origin.end) return std::nullopt;
  return analysis::Location{origin.file, {origin.begin, origin.end}};
}

syntax::Rational seconds(std::int64_t units, std::int64_t scale, Rational unit) {
  auto scaled = syntax::multiply(Rational{units, 1}, unit);
  auto result = scaled ? syntax::multiply(*scaled, Rational{1, scale}) : std::nullopt;
  return result.value_or(Rational{INT64_MAX, 1});
}

syntax::Rational difference(Rational later, Rational earlier) {
  return syntax::add(later, Rational{-earlier.numerator, earlier.denominator}).value_or(Rational{});
}

/// The last origin with a description names the step.
StepName nameOf(const verify::Step& step, const fiacre::Provenance& provenance) {
  StepName name;
  for (auto id : step.origins) {
    const auto& origin = provenance.origins[id];
    if (!origin.actor.empty()) name.actor = origin.actor;
    if (!origin.description.empty()) name.description = origin.description;
  }
  if (provenance.byHand) name.actor = fmt::format("{}", fmt::join(step.instances, ", "));
  if (!step.failure.empty())
    name.description += (name.description.empty() ? "" : ": ") + step.failure;
  return name;
}

/// The last origin with a place locates the step.
TraceStep inWords(verify::Step raw, const fiacre::Provenance& provenance) {
  TraceStep step;
  auto name = nameOf(raw, provenance);
  step.actor = std::move(name.actor);
  step.description = std::move(name.description);
  for (auto id : raw.origins)
    if (auto location = locate(provenance.origins[id])) step.location = location;
  step.changes = std::move(raw.changes);
  step.transitions = std::move(raw.transitions);
  step.origins = std::move(raw.origins);
  step.causes = std::move(raw.causes);
  step.relevant = raw.relevant;
  return step;
}

} // namespace proskill::ide
