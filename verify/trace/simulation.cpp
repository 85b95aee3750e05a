#include "verify/trace/simulation.h"

#include "verify/compile/compile.h"
#include "verify/state/state_layout.h"
#include "verify/trace/simulator.h"
#include "verify/trace/step_description.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace proskill::verify {

namespace {

/// Strict bounds are met with a margin of one of these parts of a unit.
constexpr std::int64_t kScale = 1 << 16;

} // namespace

struct Simulation::State {
  struct Taken {
    Concrete before;
    std::int64_t date = 0; ///< before the step
  };

  struct Candidate {
    TransitionId transition = 0;
    Choice choice;
  };

  State(System made, const fiacre::Provenance& of)
      : system(std::move(made)), provenance(of), simulator(system, kScale), now(simulator.start()) {
    initial = valuesIn(system, now.state);
  }

  /// The step that a transition would be; nullopt if it can be taken neither now nor later.
  [[nodiscard]] std::optional<Candidate> candidate(TransitionId id) const {
    const auto when = simulator.opportunity(now, id, date);
    if (!when) return std::nullopt;
    const std::int64_t at = when->earliest + (when->afterEarliest ? 1 : 0);
    StepLog log;
    const auto next = simulator.take(now, id, at, log);
    if (!next) return std::nullopt;
    Candidate made{id, {}};
    auto& choice = made.choice;
    choice.step = {.origins = mostDescriptiveLast(provenance, log),
                   .transitions = {nameOf(system, id, log)},
                   .instances = instancesOf(system, id),
                   .date = at,
                   .changes = changesBetween(system, now.state, next->state)};
    choice.scale = kScale;
    choice.earliest = when->earliest;
    choice.afterEarliest = when->afterEarliest;
    choice.latest = when->latest;
    choice.beforeLatest = when->beforeLatest;
    choice.bounded = system.transitions[id].interval.upper.has_value();
    return made;
  }

  /// Computed once per state, so that choices and their candidates match.
  [[nodiscard]] std::vector<Candidate> candidates() const {
    std::vector<Candidate> all;
    for (const auto& [id, since] : now.since)
      if (auto made = candidate(id)) all.push_back(std::move(*made));
    const auto soonest = [&](const Candidate& it) {
      const auto& upper = system.transitions[it.transition].interval.upper;
      const auto deadline = upper ? now.since.at(it.transition) + *upper * kScale : INT64_MAX;
      return std::tuple(deadline, it.choice.step.date, it.transition);
    };
    std::ranges::sort(all, {}, soonest);
    return all;
  }

  System system;
  const fiacre::Provenance& provenance;
  Simulator simulator;
  Concrete now;
  std::int64_t date = 0;
  std::vector<Change> initial;
  std::vector<Taken> taken;
};

Simulation::Simulation(std::unique_ptr<State> made) : state(std::move(made)) {}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

std::expected<Simulation, Unsupported> Simulation::start(const fiacre::Program& program,
                                                         const fiacre::Provenance& provenance) {
  auto compiled = compile(program, provenance, {});
  if (!compiled) return std::unexpected(compiled.error());
  return Simulation(
      std::make_unique<State>(withStateLayout(std::move(compiled->system)), provenance));
}

const std::vector<Change>& Simulation::initial() const { return state->initial; }

std::vector<Choice> Simulation::choices() const {
  std::vector<Choice> all;
  for (auto& made : state->candidates()) all.push_back(std::move(made.choice));
  return all;
}

std::int64_t Simulation::take(std::size_t choice, When when) {
  const auto chosen = state->candidates().at(choice);
  const auto& offered = chosen.choice;
  const bool isLate = when == When::Late && offered.latest;
  const auto date = isLate ? *offered.latest - (offered.beforeLatest ? 1 : 0) : offered.step.date;
  StepLog log;
  auto next = state->simulator.take(state->now, chosen.transition, date, log);
  state->taken.push_back({std::exchange(state->now, std::move(*next)), state->date});
  state->date = date;
  return date;
}

bool Simulation::undo() {
  if (state->taken.empty()) return false;
  state->now = std::move(state->taken.back().before);
  state->date = state->taken.back().date;
  state->taken.pop_back();
  return true;
}

} // namespace proskill::verify
