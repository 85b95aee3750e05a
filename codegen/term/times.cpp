#include "codegen/term/times.h"

#include "analysis/names/walk.h"
#include "syntax/tree/statements.h"

#include <fmt/format.h>

#include <limits>
#include <numeric>
#include <vector>

namespace proskill::codegen {
namespace {

using syntax::Interval;
using syntax::Rational;

constexpr std::int64_t kLargest = std::numeric_limits<std::int32_t>::max();

enum class Use : std::uint8_t { Bound, Wait, Property };

/// A duration or an interval of the program, and its purpose.
struct Duration {
  Interval interval;
  syntax::FileId file = 0;
  Use use = Use::Bound;
};

class Durations {
public:
  explicit Durations(const analysis::Program& program) {
    for (const auto& skill : program.skills.all) {
      if (skill->timeInterval) all.push_back({*skill->timeInterval, skill.file, Use::Bound});
      if (skill->body) addWaits(*skill->body, skill.file);
    }
    for (const auto& event : program.events.all)
      if (event->every) all.push_back({*event->every, event.file, Use::Bound});
    for (const auto& environment : program.environments.all)
      addWaits(environment->body, environment.file);
    for (const auto& property : program.properties.all) addBounds(property);
  }

  std::vector<Duration> all;

private:
  void addWaits(const syntax::Block& body, syntax::FileId file) {
    analysis::forEachStatement(body, [&](const syntax::Statement& statement) {
      if (syntax::hasDuration(statement)) all.push_back({statement.duration, file, Use::Wait});
    });
  }

  void addBounds(const analysis::Definition<syntax::Property>& property) {
    if (property->within) all.push_back({*property->within, property.file, Use::Property});
    if (property->forDuration)
      all.push_back({*property->forDuration, property.file, Use::Property});
    if (property->lasting) {
      const Interval lasting{.lower = property->lasting->number,
                             .upper = property->lasting->number,
                             .lowerOpen = false,
                             .upperOpen = false,
                             .range = property->bodyRange};
      all.push_back({lasting, property.file, Use::Property});
    }
  }
};

GenerationError errorAt(const Duration& duration, std::string message) {
  return {std::move(message), {duration.file, duration.interval.range}};
}

/// Least common multiple; nullopt if it exceeds 31 bits.
std::optional<std::int64_t> commonMultiple(std::int64_t a, std::int64_t b) {
  const auto factor = b / std::gcd(a, b);
  if (factor > kLargest || a > kLargest / factor) return std::nullopt;
  return a * factor;
}

std::optional<std::int64_t> scaled(Rational seconds, std::int64_t perSecond) {
  const auto value = syntax::multiply(seconds, {perSecond, 1});
  if (!value || value->denominator != 1 || value->numerator > kLargest) return std::nullopt;
  return value->numerator;
}

std::vector<Rational> boundsOf(const Interval& interval) {
  std::vector<Rational> bounds{interval.lower};
  if (interval.upper) bounds.push_back(*interval.upper);
  return bounds;
}

std::expected<std::int64_t, GenerationError> scaleOfVerification(const Durations& durations) {
  std::int64_t perSecond = 1;
  for (const auto& duration : durations.all)
    for (const auto bound : boundsOf(duration.interval)) {
      const auto scale = commonMultiple(perSecond, bound.denominator);
      if (!scale)
        return std::unexpected(errorAt(
            duration, fmt::format("{} s and the other bounds of the program have no common unit "
                                  "that is coarse enough; round it",
                                  toString(bound))));
      perSecond = *scale;
    }
  return perSecond;
}

/// Why a bound is not a multiple of the unit; nullopt if it is.
std::optional<std::string> misfit(Rational bound, std::int64_t perSecond) {
  if (scaled(bound, perSecond)) return std::nullopt;
  const auto value = syntax::multiply(bound, {perSecond, 1});
  if (!value || value->denominator == 1)
    return fmt::format("{} s is more than 2^31 of the model's units, which are {} s",
                       toString(bound), toString(Rational{1, perSecond}));
  return fmt::format("{} s is not a whole number of ticks at {} Hz; it would be at {} Hz",
                     toString(bound), perSecond, perSecond * value->denominator);
}

/// The least tick in an interval of ticks; nullopt if there is none.
std::optional<std::int64_t> firstTick(const fiacre::Interval& ticks) {
  const auto first = ticks.lower + (ticks.lowerOpen ? 1 : 0);
  if (ticks.upper && first > *ticks.upper - (ticks.upperOpen ? 1 : 0)) return std::nullopt;
  return first;
}

} // namespace

std::expected<Times, GenerationError> Times::of(const analysis::Program& program,
                                                const Options& options) {
  const Durations durations(program);
  Times times;
  times.punctual = options.edition == Edition::Runtime;
  if (times.punctual) {
    times.perSecond = options.ticksPerSecond;
  } else {
    const auto scale = scaleOfVerification(durations);
    if (!scale) return std::unexpected(scale.error());
    times.perSecond = *scale;
  }
  for (const auto& duration : durations.all) {
    if (times.punctual && duration.use == Use::Property) continue;
    for (const auto bound : boundsOf(duration.interval))
      if (auto why = misfit(bound, times.perSecond))
        return std::unexpected(errorAt(duration, std::move(*why)));
    if (times.punctual && duration.use == Use::Wait &&
        !firstTick(times.interval(duration.interval)))
      return std::unexpected(errorAt(
          duration, fmt::format("at {} Hz no tick lies within this interval", times.perSecond)));
  }
  return times;
}

std::int64_t Times::units(Rational seconds) const {
  // `of` has checked every bound, so this does not overflow
  return seconds.numerator * (perSecond / seconds.denominator);
}

fiacre::Interval Times::interval(const Interval& seconds) const {
  fiacre::Interval result;
  result.lower = units(seconds.lower);
  result.lowerOpen = seconds.lowerOpen;
  if (!seconds.upper) return result;
  result.upper = units(*seconds.upper);
  result.upperOpen = seconds.upperOpen;
  return result;
}

fiacre::Interval Times::waiting(const Interval& seconds) const {
  const auto exact = interval(seconds);
  if (!punctual) return exact;
  const auto tick = *firstTick(exact);
  return {.lower = tick, .upper = tick};
}

} // namespace proskill::codegen
