#include "ide/verdicts/durations.h"

#include "ide/verdicts/times.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace proskill::ide {

namespace {

using fiacre::Observable;
using fiacre::ObservableKind;
using fiacre::PatternKind;

Observable runs(const fiacre::Expr& running) {
  Observable made;
  made.kind = ObservableKind::Value;
  made.value = running;
  return made;
}

Observable doesNotRun(const fiacre::Expr& running) {
  Observable made;
  made.kind = ObservableKind::Not;
  made.operands = {runs(running)};
  return made;
}

/// Adds the property that asks for a time of the skill. \return the question
verify::Question ask(codegen::Model& model, PatternKind kind, const fiacre::Expr& running) {
  model.fiacre.properties.push_back(
      {.name = fmt::format("duration_{}", model.fiacre.properties.size()),
       .pattern = {.kind = kind, .operands = {runs(running), doesNotRun(running)}}});
  return {model.fiacre.properties.size() - 1};
}

std::optional<MeasuredTime> timeOf(const verify::Answer& answer, const codegen::Model& model) {
  if (!answer.duration) return std::nullopt;
  return measuredTime(*answer.duration, model.unit);
}

std::string secondsOf(const MeasuredTime& time) { return syntax::toString(time.value.seconds); }

/// "2 to 8", "at least 2", …
std::string rangeText(const MeasuredTime& from, const MeasuredTime& to) {
  if (!to.bounded)
    return fmt::format("{} {} s, with no upper bound", from.value.strict ? "more than" : "at least",
                       secondsOf(from));
  const bool isStrict = from.value.strict || to.value.strict;
  if (!isStrict && secondsOf(from) == secondsOf(to)) return secondsOf(from) + " s";
  return fmt::format("{}{} to {}{} s", from.value.strict ? "more than " : "", secondsOf(from),
                     to.value.strict ? "less than " : "", secondsOf(to));
}

bool neverRuns(const SkillDuration& duration) {
  return duration.longest && !duration.longest->happens;
}

bool neverEnds(const SkillDuration& duration) {
  return duration.shortest && !duration.shortest->happens;
}

} // namespace

DurationQuestions askForDurations(codegen::Model model) {
  DurationQuestions asked{std::move(model), {}};
  for (const auto& [skill, running] : asked.model.running)
    asked.questions.push_back({skill, ask(asked.model, PatternKind::Shortest, running),
                               ask(asked.model, PatternKind::Longest, running)});
  return asked;
}

std::vector<SkillDuration> measureDurations(const DurationQuestions& asked,
                                            verify::Options options) {
  using Clock = std::chrono::steady_clock;
  const auto& model = asked.model;
  const auto limit = options.limits.seconds;
  const auto begun = Clock::now();
  options.wantsTrace = [](std::size_t) { return false; };
  options.showsTimes = false;
  options.decided = {};
  std::vector<SkillDuration> all;
  for (std::size_t i = 0; i < asked.questions.size(); ++i) {
    const auto& of = asked.questions[i];
    auto& made = all.emplace_back(SkillDuration{of.skill, {}, {}});
    const double spent = std::chrono::duration<double>(Clock::now() - begun).count();
    if (limit)
      options.limits.seconds =
          std::max(0.0, *limit - spent) / static_cast<double>(asked.questions.size() - i);
    const auto result =
        verify::verify(model.fiacre, model.provenance, {of.shortest, of.longest}, options);
    if (!result) continue;
    made.shortest = timeOf(result->answers[0], model);
    made.longest = timeOf(result->answers[1], model);
  }
  return all;
}

bool isAnyTime(const SkillDuration& duration) {
  if (neverRuns(duration) || neverEnds(duration)) return false;
  const auto& [_, shortest, longest] = duration;
  const bool fromZero = !shortest || shortest->value == Moment{};
  return fromZero && (!longest || !longest->bounded);
}

std::string durationText(const SkillDuration& duration) {
  if (neverRuns(duration)) return "never runs";
  if (neverEnds(duration)) return "never ends";
  const auto& [_, shortest, longest] = duration;
  if (shortest && longest) return rangeText(*shortest, *longest);
  if (shortest)
    return fmt::format("{} {} s", shortest->value.strict ? "more than" : "at least",
                       secondsOf(*shortest));
  if (longest && longest->bounded)
    return fmt::format("{} {} s", longest->value.strict ? "less than" : "at most",
                       secondsOf(*longest));
  return longest ? "no upper bound" : "";
}

std::string durationSentence(const SkillDuration& duration, bool timeMayStop) {
  const auto text = durationText(duration);
  if (text.empty()) return "";
  if (neverRuns(duration)) return "Never runs.";
  if (neverEnds(duration)) return "Never ends.";
  if (text == "no upper bound") return "Its duration has no upper bound.";
  return fmt::format("Takes {}, over all runs {}.", text,
                     timeMayStop ? "in which time goes on" : "of the program");
}

} // namespace proskill::ide
