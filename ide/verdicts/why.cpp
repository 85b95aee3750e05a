#include "ide/verdicts/why.h"

#include "syntax/text/seconds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace proskill::ide {

namespace {

using fiacre::Ground;
using verify::Support;

std::string sinceText(std::size_t since) {
  return since == 0 ? " from the start" : fmt::format(" since step {}", since);
}

/// "`energy` is 0 since step 15, `sun` is Up from the start".
std::string supportText(const std::vector<Support>& support) {
  std::string text;
  for (const auto& each : support)
    if (!each.variable.empty())
      text += fmt::format("{}`{}` is {}{}", text.empty() ? "" : ", ", each.variable, each.value,
                          sinceText(each.since));
  return text;
}

bool isWordCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// A sum with its variables replaced by their values.
std::string withValues(const std::string& sum, const std::vector<Support>& support) {
  std::string text;
  for (std::size_t i = 0; i < sum.size();) {
    auto end = i;
    const auto joins = [&](char c) { return c == '-' || c == '.'; };
    while (end < sum.size() && (isWordCharacter(sum[end]) || (end > i && joins(sum[end])))) ++end;
    const auto word = sum.substr(i, std::max(end, i + 1) - i);
    const auto found = std::ranges::find(support, word, &Support::variable);
    text += found == support.end() ? word : found->value;
    i += word.size();
  }
  return text;
}

/// Writes the reasons of a step.
class Reasons {
public:
  Reasons(const verify::Trace& of, const codegen::Model& with) : trace(of), model(with) {}

  std::string of(std::size_t index) {
    text.clear();
    const auto& step = trace.steps[index];
    for (const auto& value : step.grounds)
      add(index, value, model.provenance.origins[value.origin].grounds[value.ground]);
    if (text.empty() && step.timer) addTimer(*step.timer);
    return text;
  }

private:
  void add(std::size_t index, const verify::GroundValue& value, const Ground& ground) {
    switch (ground.kind) {
    case Ground::Kind::Condition:
      if ((value.value != 0) == ground.expected) addCondition(value, ground);
      return;
    case Ground::Kind::Value: return addValue(value, ground);
    case Ground::Kind::Move: return addMove(value, ground);
    case Ground::Kind::Cause: return addCauses(index, value);
    case Ground::Kind::Need:
    case Ground::Kind::Holder: return;
    }
  }

  void addCondition(const verify::GroundValue& value, const Ground& ground) {
    const auto support = supportText(value.support);
    if (ground.text.empty()) return say(support);
    say(fmt::format("{} is {}{}", ground.text, ground.expected ? "true" : "false",
                    support.empty() ? "" : fmt::format(" ({})", support)));
  }

  /// `lift` is Away since step 3: no transition leads from there to Here.
  void addMove(const verify::GroundValue& value, const Ground& ground) {
    auto target = ground.text; // a value, or the input that has it
    for (const auto& each : value.support)
      if (each.variable != ground.variable && each.variable == ground.text) target = each.value;
    for (const auto& each : value.support)
      if (each.variable == ground.variable)
        say(fmt::format("`{}` is {}{}: no transition leads from there to {}", each.variable,
                        each.value, sinceText(each.since), target));
  }

  /// `energy` 1 − 2 = −1 is below `:min` 0.
  void addValue(const verify::GroundValue& value, const Ground& ground) {
    if (!ground.bounds) return;
    const auto [low, high] = *ground.bounds;
    if (low <= value.value && value.value <= high) return;
    const auto number =
        value.value < 0 ? fmt::format("−{}", -value.value) : std::to_string(value.value);
    const auto sum = withValues(ground.text, value.support);
    say(fmt::format("`{}` {}{} is {}", ground.variable, sum == number ? "" : sum + " = ", number,
                    value.value < low ? fmt::format("below `:min` {}", low)
                                      : fmt::format("above `:max` {}", high)));
  }

  /// The condition that enabled a step: "`(place Dock)` is false: …".
  std::string conditionsOf(const verify::Step& step) {
    Reasons other(trace, model);
    for (const auto& value : step.grounds) {
      const auto& ground = model.provenance.origins[value.origin].grounds[value.ground];
      const bool isTold = ground.kind == Ground::Kind::Condition && !ground.text.empty();
      if (isTold && (value.value != 0) == ground.expected) other.addCondition(value, ground);
    }
    return other.text;
  }

  /// "step 14: explore calls `drive_to`".
  void addCauses(std::size_t index, const verify::GroundValue& value) {
    std::vector<std::size_t> steps;
    for (const auto& each : value.support)
      if (each.since > 0 && each.since <= index) steps.push_back(each.since);
    std::ranges::sort(steps);
    steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
    for (auto number : steps) {
      const auto cause = nameOf(trace.steps[number - 1], model.provenance);
      const auto why = conditionsOf(trace.steps[number - 1]);
      say(fmt::format("step {}: {} {}{}{}", number, cause.actor, cause.description,
                      why.empty() ? "" : ": ", why));
    }
  }

  void addTimer(const verify::Timer& timer) {
    say(fmt::format("{} after {}", inSeconds(timer.interval, model.unit),
                    timer.since == 0 ? "the start" : fmt::format("step {}", timer.since)));
  }

  void say(const std::string& more) {
    if (more.empty() || text.find(more) != std::string::npos) return;
    text += (text.empty() ? "" : "; ") + more;
  }

  const verify::Trace& trace;
  const codegen::Model& model;
  std::string text;
};

/// "In step 15, at 4 s,".
std::string whenText(const Trace& trace, std::size_t number) {
  return fmt::format("in step {}, at {},", number,
                     syntax::secondsText(trace.steps[number - 1].date));
}

std::string afterText(const Trace& trace) {
  if (trace.steps.empty()) return "at the start";
  return fmt::format("after step {}, at {},", trace.steps.size(),
                     syntax::secondsText(trace.steps.back().date));
}

/// The step and its reason.
std::string stepText(const Trace& trace, std::size_t number) {
  const auto& step = trace.steps[number - 1];
  return fmt::format("{} {} {}{}{}", whenText(trace, number), step.actor, step.description,
                     step.why.empty() ? "" : ". Reason: ", step.why);
}

std::string repeatText(const Trace& trace) {
  const auto first = *trace.loop + 1;
  if (first == trace.steps.size()) return fmt::format("step {} can be repeated for ever", first);
  return fmt::format("steps {} to {} can be repeated for ever", first, trace.steps.size());
}

/// What decided a condition of the last state: variables, and steps if there is no variable.
std::string shownText(const Trace& trace, const std::vector<Support>& support) {
  auto text = supportText(support);
  std::vector<std::size_t> steps;
  for (const auto& each : support)
    if (each.variable.empty() && each.since > 0) steps.push_back(each.since);
  std::ranges::sort(steps);
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  for (auto number : steps) {
    const auto& step = trace.steps[number - 1];
    text += fmt::format("{}step {}: {} {}", text.empty() ? "" : "; ", number, step.actor,
                        step.description);
  }
  return text;
}

bool isRunPattern(const codegen::Check& check, const codegen::Model& model) {
  using fiacre::PatternKind;
  const auto& pattern = model.fiacre.properties[check.property].pattern;
  switch (pattern.kind) {
  case PatternKind::Absent:
  case PatternKind::Always:
  case PatternKind::DeadlockFree:
  case PatternKind::Progress:
  case PatternKind::NoError:
  case PatternKind::AlwaysReachable: return pattern.after || pattern.before || pattern.within;
  case PatternKind::InfinitelyOften:
  case PatternKind::Mortal:
  case PatternKind::Present:
  case PatternKind::LeadsTo:
  case PatternKind::Precedes:
  case PatternKind::Longest:
  case PatternKind::Shortest:
  case PatternKind::Ltl: return true;
  }
  return true;
}

std::string sentence(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ".";
}

/// What did or did not happen, in the program's words: "`(called lift)` does not follow `(running
/// drive)`". For other properties the description.
std::string failureText(const codegen::Check& check, const codegen::Model& model) {
  using fiacre::PatternKind;
  const auto& pattern = model.fiacre.properties[check.property].pattern;
  const auto kind = pattern.kind;
  const auto operand = [&](std::size_t i) { return "`" + check.operands[i] + "`"; };
  const bool follows = kind == PatternKind::LeadsTo || fiacre::asksForTime(kind);
  if (check.operands.size() == 2 && follows)
    return fmt::format("{} does not follow {}", operand(1), operand(0));
  if (check.operands.size() == 2 && kind == PatternKind::Precedes)
    return fmt::format("{} becomes true without {} before it", operand(1), operand(0));
  if (check.operands.size() == 1) {
    if (kind == PatternKind::Present && !pattern.before && !pattern.after)
      return operand(0) + " does not become true";
    if (kind == PatternKind::InfinitelyOften) return operand(0) + " does not become true again";
    if (kind == PatternKind::Always) return operand(0) + " is false";
    if (kind == PatternKind::Absent)
      return operand(0) +
             (check.good == codegen::Expectation::Reachable ? " is reached" : " is true");
  }
  return check.description + " does not hold";
}

bool waitsForSomething(const codegen::Check& check, const codegen::Model& model) {
  using fiacre::PatternKind;
  const auto kind = model.fiacre.properties[check.property].pattern.kind;
  return kind != PatternKind::Absent && kind != PatternKind::Always &&
         kind != PatternKind::Precedes;
}

/// The end of a run from which a condition cannot become true any more.
std::string lostText(const codegen::Check& check, const Trace& trace) {
  const auto wanted = check.operands.empty() ? check.description : "`" + check.operands[0] + "`";
  const auto until =
      trace.end ? fmt::format(" if nothing else happens until {},", syntax::secondsText(*trace.end))
                : "";
  return fmt::format("{}{} {} can never become true any more", afterText(trace), until, wanted);
}

/// A violation that only the run as a whole shows.
std::string runText(const codegen::Check& check, const codegen::Model& model, const Trace& trace) {
  const auto failure = failureText(check, model);
  if (trace.loop) return fmt::format("{}, and then {}", repeatText(trace), failure);
  const bool waits = trace.end || waitsForSomething(check, model);
  if (waits && trace.rest == verify::Rest::Forced)
    return fmt::format("{} nothing happens any more: {}", afterText(trace), failure);
  if (waits && trace.rest == verify::Rest::Allowed)
    return fmt::format("{} nothing has to happen any more: {}", afterText(trace), failure);
  if (trace.end)
    return fmt::format("{} nothing else has to happen until {}: {}", afterText(trace),
                       syntax::secondsText(*trace.end), failure);
  return fmt::format("{} {}", afterText(trace), failure);
}

} // namespace

std::vector<std::string> whyOf(const verify::Trace& trace, const codegen::Model& model) {
  Reasons reasons(trace, model);
  std::vector<std::string> all;
  for (std::size_t i = 0; i < trace.steps.size(); ++i) all.push_back(reasons.of(i));
  return all;
}

std::string summaryOf(const codegen::Check& check, const codegen::Model& model, const Trace& trace,
                      const std::vector<Support>& support) {
  if (check.kind == "no_deadlock")
    return sentence(afterText(trace) +
                    " no step is possible any more, and the mission has not ended");
  if (check.kind == "time_progress") {
    if (trace.loop) return sentence(repeatText(trace) + ", and no time passes");
    return sentence(afterText(trace) + " time can never pass again");
  }
  const auto asked = model.fiacre.properties[check.property].pattern.kind;
  if (asked == fiacre::PatternKind::AlwaysReachable) return sentence(lostText(check, trace));
  if (isRunPattern(check, model)) return sentence(runText(check, model, trace));
  if (!support.empty()) {
    const bool isFound = check.good == codegen::Expectation::Reachable;
    const auto outcome = !check.operands.empty() ? failureText(check, model)
                         : isFound               ? check.description + " is reached"
                                                 : check.description + " does not hold";
    return sentence(fmt::format("{} {}: {}", afterText(trace), outcome, shownText(trace, support)));
  }
  if (trace.steps.empty()) return sentence("at the start");
  return sentence(stepText(trace, trace.steps.size()));
}

std::string inSeconds(const fiacre::Interval& interval, syntax::Rational unit) {
  const auto from = syntax::toString(seconds(interval.lower, 1, unit));
  if (!interval.upper)
    return fmt::format("{} {} s", interval.lowerOpen ? "more than" : "at least", from);
  const auto to = syntax::toString(seconds(*interval.upper, 1, unit));
  if (from == to) return from + " s";
  return fmt::format("{}{} to {}{} s", interval.lowerOpen ? "more than " : "", from,
                     interval.upperOpen ? "less than " : "", to);
}

} // namespace proskill::ide
