#include "runtime/platform/simulated.h"

#include <algorithm>
#include <numeric>

namespace proskill::runtime {

namespace {

constexpr Nanoseconds kNever = INT64_MAX;
constexpr unsigned kSuccessWeight = 8;

class Simulated final : public Platform {
public:
  Simulated(SimulationSettings with, std::uint64_t seed)
      : settings(std::move(with)),
        random(seed),
        pending(settings.actions.size()),
        runs(settings.actions.size()),
        coming(settings.signals.size(), kNever) {
    for (std::uint32_t i = 0; i < coming.size(); ++i) awaitSignal(i, 0);
  }

  void start(const Start& start, Nanoseconds date) override {
    auto& run = pending[start.action];
    const auto ending = next(start.action);
    const auto& of = settings.actions[start.action];
    run.run = start.run;
    run.date = date + (ending.after ? *ending.after : drawn(of.duration));
    run.result = ending.result ? *ending.result : drawnResult(of.weights);
  }

  bool stop(std::uint32_t action, RunNumber number, Nanoseconds date) override {
    auto& run = pending[action];
    if (run.run != number || run.date == kNever) return false;
    const auto delay = drawn(settings.actions[action].stops);
    run.date = delay == 0 ? kNever : std::min(run.date, date + delay);
    return delay == 0;
  }

  [[nodiscard]] std::optional<Nanoseconds> next() const override {
    Nanoseconds first = kNever;
    for (const auto& run : pending) first = std::min(first, run.date);
    for (const auto date : coming) first = std::min(first, date);
    if (scripted < settings.script.size()) first = std::min(first, settings.script[scripted].date);
    return first == kNever ? std::nullopt : std::optional(first);
  }

  bool poll(Nanoseconds date, Report& report) override {
    return pollActions(date, report) || pollScript(date, report) || pollSignals(date, report);
  }

private:
  struct Run {
    Nanoseconds date = kNever; ///< of its end
    RunNumber run = 0;
    std::uint32_t result = 0;
  };

  SimulationSettings::Ending next(std::uint32_t action) {
    const auto& all = settings.endings[action];
    return runs[action] < all.size() ? all[runs[action]++] : SimulationSettings::Ending{};
  }

  Nanoseconds drawn(const Span& span) {
    return random.between(span.first, span.last.value_or(span.first + 10 * kSecond));
  }

  std::uint32_t drawnResult(const std::vector<unsigned>& weights) {
    const auto sum = std::accumulate(weights.begin(), weights.end(), 0U);
    auto left = random.below(std::max(sum, 1U));
    for (std::uint32_t i = 0; i < weights.size(); ++i) {
      if (left < weights[i]) return i;
      left -= weights[i];
    }
    return 0;
  }

  void awaitSignal(std::uint32_t signal, Nanoseconds date) {
    const auto& every = settings.signals[signal];
    coming[signal] = every ? date + drawn(*every) : kNever;
  }

  bool pollActions(Nanoseconds date, Report& report) {
    const auto first = std::ranges::min_element(pending, {}, &Run::date);
    if (first == pending.end() || first->date > date) return false;
    report.kind = ReportKind::Result;
    report.action = static_cast<std::uint32_t>(first - pending.begin());
    report.date = first->date;
    report.run = first->run;
    report.result = first->result;
    first->date = kNever;
    return true;
  }

  bool pollScript(Nanoseconds date, Report& report) {
    if (scripted == settings.script.size() || settings.script[scripted].date > date) return false;
    report.kind = ReportKind::Signal;
    report.date = settings.script[scripted].date;
    report.signal = settings.script[scripted++].signal;
    return true;
  }

  bool pollSignals(Nanoseconds date, Report& report) {
    const auto first = std::ranges::min_element(coming);
    if (first == coming.end() || *first > date) return false;
    report.kind = ReportKind::Signal;
    report.signal = static_cast<std::uint32_t>(first - coming.begin());
    report.date = *first;
    awaitSignal(report.signal, *first);
    return true;
  }

  SimulationSettings settings;
  Random random;
  std::vector<Run> pending;        ///< by action
  std::vector<std::size_t> runs;   ///< by action: number of scripted runs so far
  std::vector<Nanoseconds> coming; ///< by signal
  std::size_t scripted = 0;        ///< number of script entries that are over
};

} // namespace

SimulationSettings defaultSettings(const Executable& executable) {
  SimulationSettings made;
  for (std::size_t i = 0; i < executable.actions.size(); ++i) {
    auto& action = made.actions.emplace_back();
    action.duration = executable.actions[i].span;
    action.stops = {0, 0};
    for (const auto& result : executable.model.performed[i].results)
      action.weights.push_back(result.status == "success" ? kSuccessWeight : 1);
  }
  made.endings.resize(made.actions.size());
  for (std::size_t i = 0; i < executable.model.signals.size(); ++i) {
    const bool comes = !executable.model.signals[i].interrupts && !executable.model.hasEnvironment;
    const auto span = executable.everySpans[i].value_or(Span{5 * kSecond, 60 * kSecond});
    made.signals.push_back(comes ? std::optional(span) : std::nullopt);
  }
  return made;
}

std::unique_ptr<Platform> simulatedPlatform(SimulationSettings settings, std::uint64_t seed) {
  return std::make_unique<Simulated>(std::move(settings), seed);
}

} // namespace proskill::runtime
