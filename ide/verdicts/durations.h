#pragma once

#include "ide/verdicts/verification.h"

namespace proskill::ide {

/// How long a skill takes from its start to its end, over all runs of the program.
struct SkillDuration {
  std::string skill;
  std::optional<MeasuredTime> shortest; ///< nullopt: a limit was met
  std::optional<MeasuredTime> longest;  ///< likewise

  bool operator==(const SkillDuration&) const = default;
};

/// A model with questions for the durations of its skills.
struct DurationQuestions {
  struct OfSkill {
    std::string skill;
    verify::Question shortest;
    verify::Question longest;
  };
  codegen::Model model;
  std::vector<OfSkill> questions;
};
[[nodiscard]] DurationQuestions askForDurations(codegen::Model model);

/// Measures each skill. Each has the same share of the remaining time, so that one with many states
/// leaves something for the others.
/// \param options `decided`, `wantsTrace` and `showsTimes` are not used
[[nodiscard]] std::vector<SkillDuration> measureDurations(const DurationQuestions& asked,
                                                          verify::Options options);

/// "2 to 8 s", "more than 2 s, with no upper bound", "never runs". Empty if nothing is known.
[[nodiscard]] std::string durationText(const SkillDuration& duration);
/// Whether the skill may take any time, as far as is known: not worth a lens or a hint.
[[nodiscard]] bool isAnyTime(const SkillDuration& duration);
/// `durationText` as a sentence about the skill: "Takes 2 to 8 s.", "Never runs." May be empty.
/// \param timeMayStop `program.time_progress` does not hold, so runs in which time stops do not
/// count
[[nodiscard]] std::string durationSentence(const SkillDuration& duration, bool timeMayStop);

} // namespace proskill::ide
