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

/// Something that is said to happen, of what, and where the program has it.
struct Fact {
  What what = What::Runs;
  int subject = 0;
  std::uint32_t at = 0;
  friend auto operator<=>(const Fact&, const Fact&) = default;
};

/// When a step happens. Without a clock it happens at once, or whenever it pleases.
struct When {
  int clock = kNobody; ///< an index into the ages
  std::int64_t lower = 0;
  std::optional<std::int64_t> upper;
  bool lowerOpen = false;
  bool upperOpen = false;

  [[nodiscard]] static When now() { return {.upper = 0}; }
  [[nodiscard]] static When anyTime() { return {}; }
  [[nodiscard]] bool isUrgent() const { return clock == kNobody && upper.has_value(); }
};

/// One thing that can happen. Nothing comes between its beginning and its end.
struct Step {
  When when;
  std::vector<Fact> facts;
  Situation after;
};

/// With the first value of each variable that is listed.
[[nodiscard]] Situation beginning(const Script& script);
/// With each of the values that variables may begin with; that one is the first.
[[nodiscard]] std::vector<Situation> beginnings(const Script& script);

/// All that can happen in a situation if time allows it, each by itself.
[[nodiscard]] std::vector<Step> stepsFrom(const Script& script, const Situation& situation);

} // namespace proskill::meaning
