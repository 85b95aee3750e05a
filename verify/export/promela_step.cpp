#include "verify/export/promela_step.h"

#include "verify/export/promela_path.h"
#include "verify/export/symbolic_step.h"
#include "verify/model/path_events.h"
#include "verify/state/timing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace proskill::verify {

namespace {

constexpr auto kIndent = ";\n       ";

/// The events that a step may cause, of those that some assertion reads.
Bits eventsOf(const PromelaModel& model, const Transition& transition) {
  Bits all = eventsOf(model.system, transition.parts);
  for (auto event : transition.events) all.insert(event);
  all &= model.events;
  return all;
}

/// The statements of one step.
class StepWriter {
public:
  StepWriter(PromelaModel& of, TransitionId which)
      : model(of),
        id(which),
        transition(of.system.transitions[which]),
        events(eventsOf(of, transition)) {}

  std::string write() {
    keepBefore();
    bool mayFail = false;
    for (std::size_t i = 0; i < transition.parts.size(); ++i) {
      const auto& path = model.system.paths[transition.parts[i]];
      mayFail = mayFail || path.mayFail;
      append(promelaPath(model, id, i));
    }
    if (!transition.fails) conclude();
    if (mayFail || transition.fails) lines.push_back(fmt::format("E{}: skip", id));
    if (lines.empty()) lines.emplace_back("skip");
    return fmt::format("  :: d_step {{ {} ->\n       {}\n     }}\n", guard(),
                       fmt::join(lines, kIndent));
  }

private:
  void append(std::vector<std::string> more) { std::ranges::move(more, std::back_inserter(lines)); }

  std::string guard() {
    std::vector<std::string> all;
    if (model.mayFail) all.emplace_back("!failed");
    if (!transition.fails)
      for (TransitionId i = 0; i < model.system.transitions.size(); ++i)
        if (model.system.transitions[i].fails) all.push_back("!" + model.names.enabled(i));
    all.push_back(model.named.contains(id) ? model.names.enabled(id) : enabledText());
    for (auto blocker : transition.blockers) all.push_back("!" + model.names.enabled(blocker));
    if (transition.clock != kNone)
      all.push_back(fmt::format("{} >= {}", model.names.clock(transition.clock),
                                model.time.lower(transition.interval)));
    for (auto blocker : transition.laterBlockers) all.push_back(notReady(blocker));
    return fmt::format("{}", fmt::join(all, " && "));
  }

  std::string enabledText() {
    return model.names.text(enabledNode(model.system, transition, model.nodes, model.faults));
  }

  std::string notReady(TransitionId blocker) {
    const auto& first = model.system.transitions[blocker];
    return fmt::format("!({} && {} >= {})", model.names.enabled(blocker),
                       model.names.clock(first.clock), model.time.lower(first.interval));
  }

  void keepBefore() {
    Bits kept = model.before;
    for (auto part : transition.parts) kept |= oldCells(model.system, transition, part);
    kept.each([&](CellId cell) {
      lines.push_back(fmt::format("{} = {}", model.names.before(cell), model.names.cell(cell)));
    });
    Bits reset = events;
    reset |= model.eventsOfSteps;
    reset.each(
        [&](EventId event) { lines.push_back(fmt::format("{} = 0", model.names.event(event))); });
    for (auto event : transition.events)
      if (model.events.contains(event))
        lines.push_back(fmt::format("{} = 1", model.names.event(event)));
  }

  /// What holds after the step: clocks start, and assertions are checked.
  void conclude() {
    for (ClockId clock = 0; clock < model.system.clocks.size(); ++clock) restart(clock);
    for (const auto& assertion : model.assertions) check(assertion);
  }

  /// A clock that does not run is 0.
  void restart(ClockId clock) {
    const auto name = model.names.clock(clock);
    Bits read;
    for (const auto& other : model.system.transitions)
      if (other.clock == clock) read |= other.guardReads;
    if (resets(model.system, id, clock))
      lines.push_back(fmt::format("{} = 0", name));
    else if (read.meets(transition.writes))
      lines.push_back(fmt::format("{0} = (runs_{0} -> {0} : 0)", name));
  }

  void check(const PromelaAssertion& assertion) {
    const auto expect = [&](const std::string& what) {
      lines.push_back(fmt::format("expect({}, {})", assertion.name, what));
    };
    const Goal& goal = *assertion.goal;
    if (goal.kind == GoalKind::Events) {
      std::vector<std::string> any;
      Bits possible = goal.events;
      possible &= events;
      possible.each([&](EventId event) { any.push_back(model.names.event(event)); });
      if (!any.empty()) expect(fmt::format("!({})", fmt::join(any, " || ")));
    }
    if (goal.kind != GoalKind::Condition) return;
    if (model.isOfSteps(assertion))
      expect(fmt::format("!{}", model.names.overStep(assertion.condition)));
    if (!assertion.reads.meets(transition.writes)) return; // the state before was checked
    if (auto ofState = assertedOfState(model, assertion)) lines.push_back(std::move(*ofState));
  }

  PromelaModel& model;
  TransitionId id;
  const Transition transition; // a copy, since nodes are added
  const Bits events;           ///< that it may cause; the others are not read after it
  std::vector<std::string> lines;
};

} // namespace

std::string promelaStep(PromelaModel& model, TransitionId id) {
  return StepWriter(model, id).write();
}

std::optional<std::string> assertedOfState(const PromelaModel& model,
                                           const PromelaAssertion& assertion) {
  if (assertion.goal->kind != GoalKind::Condition) return std::nullopt;
  const auto condition = model.names.text(assertion.condition);
  return fmt::format("expect({}, !{})", assertion.name, condition);
}

std::string promelaTick(const PromelaModel& model) {
  std::vector<std::string> guard;
  if (model.mayFail) guard.emplace_back("!failed");
  std::vector<std::string> growing;
  std::vector<std::string> lines;
  for (TransitionId i = 0; i < model.system.transitions.size(); ++i) {
    const auto& it = model.system.transitions[i];
    if (it.urgent) guard.push_back("!" + model.names.enabled(i));
    if (it.clock != kNone && it.interval.upper)
      guard.push_back(fmt::format("!({} && {} >= {})", model.names.enabled(i),
                                  model.names.clock(it.clock), model.time.upper(it.interval)));
  }
  for (ClockId clock = 0; clock < model.system.clocks.size(); ++clock) {
    const auto name = model.names.clock(clock);
    const auto most = model.time.most()[clock];
    growing.push_back(fmt::format("(runs_{0} && {0} < {1})", name, most));
    lines.push_back(fmt::format("{0} = (runs_{0} && {0} < {1} -> {0} + 1 : {0})", name, most));
  }
  guard.push_back(fmt::format("({})", fmt::join(growing, " || ")));
  return fmt::format("  /* time passes */\n  :: d_step {{ {} ->\n       {}\n     }}\n",
                     fmt::join(guard, " && "), fmt::join(lines, kIndent));
}

std::string clockMacros(const PromelaModel& model) {
  std::string text;
  for (ClockId clock = 0; clock < model.system.clocks.size(); ++clock) {
    std::vector<std::string> any;
    for (TransitionId i = 0; i < model.system.transitions.size(); ++i)
      if (model.system.transitions[i].clock == clock) any.push_back(model.names.enabled(i));
    text += fmt::format("#define runs_{} ({})\n", model.names.clock(clock), fmt::join(any, " || "));
  }
  return text;
}

} // namespace proskill::verify
