#include "verify/compile/compile.h"
#include "verify/export/asked.h"
#include "verify/export/export.h"
#include "verify/export/identifiers.h"
#include "verify/space/state_tree.h"
#include "verify/state/enabled.h"
#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"
#include "verify/unsupported.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <deque>

namespace proskill::verify {

namespace {

constexpr std::uint64_t kMostLocations = 200'000;

constexpr auto kPreamble =
    R"(# Made by `proskill emit tchecker`: a timed automaton with a location for each discrete state that can be reached
# without regard to time, and a clock for each clock of the model. `tck-reach -a covreach -l LABEL FILE` asks whether a
# location with the label can be reached, in time. A label stands for a violated property:
{}
system:model
event:step
process:model
)";

/// Explores the discrete states, and writes each as a location.
class TimedAutomaton {
public:
  TimedAutomaton(const System& of, const std::vector<Goal>& asked,
                 const std::vector<std::string>& propertyNames, LimitWatch& watch,
                 std::uint64_t mostStates)
      : system(of), goals(asked), limits(watch), most(mostStates), enabling(of), states(of) {
    for (std::size_t i = 0; i < goals.size(); ++i)
      labels.push_back(identifiers.make("p_", propertyNames[i]));
    failed = identifiers.make("", "failed");
  }

  std::string write() {
    std::string clocks;
    for (ClockId i = 0; i < system.clocks.size(); ++i) clocks += fmt::format("clock:1:x{}\n", i);
    addInitial();
    for (std::uint64_t count = 0; !waiting.empty(); ++count) {
      if (count % 64 == 0) checkLimits();
      const auto next = waiting.front();
      waiting.pop_front();
      expand(next);
    }
    for (const auto& [label, name] : sinks)
      locations += fmt::format("location:model:{}{{labels:{}}}\n", name, label);
    return clocks + locations + edges;
  }

  [[nodiscard]] const std::vector<std::string>& labelNames() const { return labels; }

private:
  void checkLimits() {
    if (states.size() > most)
      unsupported(fmt::format("more than {} discrete states, each of which is a location", most));
    if (auto limit = limits.met({.classes = states.size(), .bytes = states.bytes()});
        !limit.empty())
      throw LimitMet{std::move(limit)};
  }

  void addInitial() {
    const auto first = initialState(system);
    add(first);
    for (std::size_t i = 0; i < goals.size(); ++i)
      if (goals[i].kind == GoalKind::Events && goals[i].initially)
        initialLabels.push_back(labels[i]);
  }

  StateId add(const std::vector<Word>& state) {
    const auto [id, isNew] = states.add(state.data());
    if (isNew) waiting.push_back(id);
    return id;
  }

  void expand(StateId id) {
    state.resize(system.words);
    states.read(id, state.data());
    enabling.compute(state.data(), enabled);
    writeLocation(id);
    bool fails = false;
    eachIn(enabled, [&](TransitionId it) { fails = fails || system.transitions[it].fails; });
    eachIn(enabled, [&](TransitionId it) {
      if (fails && !system.transitions[it].fails) return;
      if (!enabling.isBlocked(it, enabled)) follow(id, it);
    });
  }

  void writeLocation(StateId id) {
    std::vector<std::string> attributes;
    if (id == 0) attributes.emplace_back("initial:");
    if (enabling.isUrgent(enabled)) attributes.emplace_back("urgent:");
    std::vector<std::string> bounds;
    eachIn(enabled, [&](TransitionId it) {
      const auto& transition = system.transitions[it];
      if (transition.clock != kNone && transition.interval.upper)
        bounds.push_back(
            fmt::format("x{}{}{}", transition.clock,
                        transition.interval.upperOpen ? "<" : "<=", *transition.interval.upper));
    });
    std::ranges::sort(bounds);
    const auto twice = std::ranges::unique(bounds);
    bounds.erase(twice.begin(), twice.end());
    if (!bounds.empty())
      attributes.push_back(fmt::format("invariant:{}", fmt::join(bounds, " && ")));
    const auto here = labelsHere(id);
    if (!here.empty()) attributes.push_back(fmt::format("labels:{}", fmt::join(here, ",")));
    locations += fmt::format("location:model:s{}{{{}}}\n", id, fmt::join(attributes, " : "));
  }

  /// The properties that the state violates.
  std::vector<std::string> labelsHere(StateId id) {
    auto here = id == 0 ? initialLabels : std::vector<std::string>{};
    const Moment moment{state.data(), nullptr, nullptr};
    const bool stopped = std::ranges::all_of(enabled, [](Word word) { return word == 0; });
    for (std::size_t i = 0; i < goals.size(); ++i) {
      const bool reached =
          (goals[i].kind == GoalKind::Condition && holdsAt(system, goals[i].condition, moment)) ||
          (goals[i].kind == GoalKind::Deadlock && stopped &&
           !holdsAt(system, goals[i].condition, moment));
      if (reached) here.push_back(labels[i]);
    }
    return here;
  }

  void follow(StateId source, TransitionId id) {
    next = state;
    log.clear();
    const Outcome outcome = fire(system, id, next.data(), log);
    if (outcome == Outcome::GaveUp) return;
    const auto guard = guardOf(id);
    if (outcome == Outcome::Failed) return writeFailure(source, guard);
    nextEnabled = enabled;
    enabling.update(id, next.data(), nextEnabled);
    const StateId target = add(next);
    auto attributes = guard;
    if (const auto started = clocksStarted(id); !started.empty())
      attributes.push_back(fmt::format("do:{}", fmt::join(started, "; ")));
    writeEdge(source, fmt::format("s{}", target), attributes);
    for (std::size_t i = 0; i < goals.size(); ++i)
      if (isShown(goals[i])) writeEdge(source, sink(labels[i]), guard);
  }

  void writeFailure(StateId source, const std::vector<std::string>& guard) {
    bool asked = false;
    for (std::size_t i = 0; i < goals.size(); ++i) {
      if (goals[i].kind != GoalKind::Error) continue;
      writeEdge(source, sink(labels[i]), guard);
      asked = true;
    }
    if (!asked) writeEdge(source, sink(failed), guard);
  }

  /// Whether the step shows the goal.
  [[nodiscard]] bool isShown(const Goal& goal) const {
    Bits events;
    for (auto event : log.events) events.insert(event);
    if (goal.kind == GoalKind::Events) return events.meets(goal.events);
    if (goal.kind != GoalKind::Condition || !goal.ofSteps) return false;
    return holdsAt(system, goal.condition, {state.data(), next.data(), &events});
  }

  /// A location that nothing leaves.
  const std::string& sink(const std::string& label) {
    return sinks.try_emplace(label, "sink_" + label).first->second;
  }

  void writeEdge(StateId source, const std::string& target,
                 const std::vector<std::string>& attributes) {
    edges +=
        fmt::format("edge:model:s{}:{}:step{{{}}}\n", source, target, fmt::join(attributes, " : "));
  }

  std::vector<std::string> guardOf(TransitionId id) {
    const auto& transition = system.transitions[id];
    std::vector<std::string> all;
    const auto& interval = transition.interval;
    if (transition.clock != kNone && (interval.lower > 0 || interval.lowerOpen))
      all.push_back(fmt::format("x{}{}{}", transition.clock,
                                interval.lowerOpen ? ">" : ">=", interval.lower));
    for (auto blocker : transition.laterBlockers) {
      const auto& first = system.transitions[blocker];
      if (contains(enabled, blocker))
        all.push_back(fmt::format("x{}{}{}", first.clock, first.interval.lowerOpen ? "<=" : "<",
                                  first.interval.lower));
    }
    if (all.empty()) return {};
    return {fmt::format("provided:{}", fmt::join(all, " && "))};
  }

  /// The clocks that run after the step and start with it.
  std::vector<std::string> clocksStarted(TransitionId fired) {
    const Bits before = running(enabled);
    std::vector<std::string> started;
    running(nextEnabled).each([&](ClockId clock) {
      if (!before.contains(clock) || resets(system, fired, clock))
        started.push_back(fmt::format("x{}=0", clock));
    });
    return started;
  }

  [[nodiscard]] Bits running(const TransitionSet& of) const {
    Bits clocks;
    eachIn(of, [&](TransitionId it) {
      if (system.transitions[it].clock != kNone) clocks.insert(system.transitions[it].clock);
    });
    return clocks;
  }

  const System& system;
  const std::vector<Goal>& goals;
  LimitWatch& limits;
  std::uint64_t most;
  Identifiers identifiers;
  std::vector<std::string> labels; ///< by goal
  std::string failed;              ///< label of errors of the model that are not asked for
  std::vector<std::string> initialLabels;
  Enabling enabling;
  StateTree states;
  std::deque<StateId> waiting;
  std::map<std::string, std::string> sinks; ///< by label
  std::string locations;
  std::string edges;

  std::vector<Word> state;
  std::vector<Word> next;
  TransitionSet enabled;
  TransitionSet nextEnabled;
  StepLog log;
};

} // namespace

std::expected<Exported, Unsupported> exportTChecker(const fiacre::Program& program,
                                                    const fiacre::Provenance& provenance,
                                                    const std::vector<Question>& questions,
                                                    const std::vector<std::string>& names,
                                                    const Options& options) try {
  LimitWatch limits(options);
  auto compiled = compile(program, provenance, questions, &limits);
  if (!compiled) return std::unexpected(compiled.error());
  const System system = withStateLayout(std::move(compiled->system));
  TimedAutomaton automaton(system, compiled->goals, names, limits,
                           options.limits.classes.value_or(kMostLocations));
  const auto text = automaton.write();
  Exported made;
  std::string legend;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (const auto why = whyNotAsked(compiled->goals[i]))
      made.notes.push_back(fmt::format("TChecker is not asked for `{}`: {}", names[i], *why));
    else
      legend += fmt::format("#   {}: `{}`\n", automaton.labelNames()[i], names[i]);
  }
  made.text = fmt::format(kPreamble, legend) + text;
  return made;
} catch (const CompileError& error) {
  return std::unexpected(error.why);
} catch (const LimitMet& limit) {
  return std::unexpected(Unsupported{limit.which});
}

} // namespace proskill::verify
