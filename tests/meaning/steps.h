#pragma once

#include "tests/meaning/look.h"

namespace proskill::meaning {

enum class What : std::uint8_t {
  Forbidden, ///< subject: a state variable
  Runs,      ///< subject: a skill, as below; it starts
  Succeeds,
  Fails,
  InvariantFails,
  IsInterrupted,
  PostconditionFails,
  Refused, ///< the mission or a monitor
  CallRefused,
  CallBusy,
  Reached, ///< a statement
  Undershoot,
  Overshoot,
  Occurs, ///< subject: an event
};

/// A fact: its kind, its subject, and its place in the program.
struct Fact {
  What what = What::Runs;
  int subject = 0;
  std::uint32_t at = 0;
  friend auto operator<=>(const Fact&, const Fact&) = default;
};

/// When a step happens. Without a clock: at once, or at any time.
struct When {
  int clock = kNobody; ///< index into the ages
  std::int64_t lower = 0;
  std::optional<std::int64_t> upper;
  bool lowerOpen = false;
  bool upperOpen = false;

  [[nodiscard]] static When now() { return {.upper = 0}; }
  [[nodiscard]] static When anyTime() { return {}; }
  [[nodiscard]] bool isUrgent() const { return clock == kNobody && upper.has_value(); }
};

/// A possible step. Steps are atomic.
struct Step {
  When when;
  std::vector<Fact> facts;
  Situation after;
};

/// With the first listed value of each variable.
[[nodiscard]] Situation beginning(const Script& script);
/// With each combination of possible initial values; that one is the first.
[[nodiscard]] std::vector<Situation> beginnings(const Script& script);

/// All steps that are possible in a situation apart from time.
[[nodiscard]] std::vector<Step> stepsFrom(const Script& script, const Situation& situation);

} // namespace proskill::meaning
