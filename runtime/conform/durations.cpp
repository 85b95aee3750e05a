#include "runtime/conform/durations.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace proskill::runtime {

namespace {

/// Whether a step is the result of its actor's action.
bool isResult(const RecordedStep& step) {
  return step.stops.empty() && (step.what.description.starts_with("succeeds") ||
                                step.what.description.starts_with("fails"));
}

void add(Durations& to, Nanoseconds duration) {
  to.least = to.count == 0 ? duration : std::min(to.least, duration);
  to.most = std::max(to.most, duration);
  ++to.count;
}

Nanoseconds nanoseconds(const syntax::Rational& seconds) {
  const auto exact = syntax::multiply(seconds, {kSecond, 1});
  return exact ? exact->numerator / exact->denominator : 0;
}

std::string decimal(Nanoseconds time) {
  auto text = fmt::format("{}.{:09}", time / kSecond, time % kSecond);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

Nanoseconds rounded(Nanoseconds time, bool up) {
  Nanoseconds step = 1;
  while (time / step >= 100) step *= 10;
  return (up ? (time + step - 1) / step : time / step) * step;
}

} // namespace

bool DurationsOfRuns::onHead(const RecordedHead&) {
  since.clear();
  return true;
}

bool DurationsOfRuns::onStep(const RecordedStep& step) {
  const auto* skill = program.skills.find(step.what.actor);
  if (!step.stops.empty()) since.erase(step.stops);
  if (!skill || (*skill)->isComposite()) return true;
  if (step.what.description == "starts") since[step.what.actor] = step.date;
  const auto begin = since.find(step.what.actor);
  if (begin == since.end() || !isResult(step)) return true;
  add(durations[step.what.actor], step.date - begin->second);
  since.erase(begin);
  return true;
}

bool DurationsOfRuns::onCall(const RecordedCall&) { return true; }

std::string widened(const syntax::Interval& interval, const Durations& durations) {
  const auto lower = nanoseconds(interval.lower);
  const bool isEarly = durations.least < lower || (durations.least == lower && interval.lowerOpen);
  std::optional<Nanoseconds> upper;
  if (interval.upper) upper = nanoseconds(*interval.upper);
  const bool isLate =
      upper && (durations.most > *upper || (durations.most == *upper && interval.upperOpen));
  if (!isEarly && !isLate) return "";
  auto text = isEarly ? "[" + decimal(rounded(durations.least, false))
                      : (interval.lowerOpen ? "]" : "[") + decimal(lower);
  text += ",";
  if (isLate) return text + decimal(rounded(durations.most, true)) + "]";
  if (!upper) return text + "...[";
  return text + decimal(*upper) + (interval.upperOpen ? "[" : "]");
}

} // namespace proskill::runtime
