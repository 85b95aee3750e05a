#include "ide/verdicts/simulated_run.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::ide {

namespace {

bool readsAs(const TraceStep& step, const ChosenStep& wanted) {
  return step.actor == wanted.actor && step.description == wanted.description;
}

/// The choice with this description: preferably of the same transition, otherwise the first.
std::optional<std::size_t> find(const std::vector<TraceStep>& choices, const ChosenStep& wanted) {
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (!readsAs(choices[i], wanted)) continue;
    if (choices[i].transitions == wanted.transitions) return i;
    if (!first) first = i;
  }
  return first;
}

/// A step of the model without a counterpart in the program: the mission remains ended.
bool isIdle(const TraceStep& step) { return step.description.empty() && step.changes.empty(); }

} // namespace

SimulatedRun::SimulatedRun(std::unique_ptr<const codegen::Model> of, verify::Simulation started)
    : model(std::move(of)), simulation(std::move(started)) {
  taken.initial = simulation.initial();
}

std::expected<SimulatedRun, std::string> SimulatedRun::start(codegen::Model made) {
  auto model = std::make_unique<const codegen::Model>(std::move(made));
  auto started = verify::Simulation::start(model->fiacre, model->provenance);
  if (!started)
    return std::unexpected("this model cannot be simulated: " + started.error().message);
  return SimulatedRun(std::move(model), std::move(*started));
}

TraceStep SimulatedRun::stepOf(const verify::Choice& choice) const {
  const auto before = taken.steps.empty() ? syntax::Rational() : taken.steps.back().date;
  auto step = inWords(choice.step, model->provenance);
  step.earliest = {seconds(choice.earliest, choice.scale, model->unit), choice.afterEarliest};
  if (choice.latest)
    step.latest = {seconds(*choice.latest, choice.scale, model->unit), choice.beforeLatest};
  step.date = seconds(choice.step.date, choice.scale, model->unit);
  step.delay = difference(step.date, before);
  return step;
}

std::vector<TraceStep> SimulatedRun::choices() const {
  std::vector<TraceStep> steps;
  for (const auto& choice : simulation.choices())
    if (auto step = stepOf(choice); !isIdle(step)) steps.push_back(std::move(step));
  return steps;
}

void SimulatedRun::take(std::size_t choice, verify::When when) {
  const auto offered = simulation.choices();
  std::size_t place = 0;
  for (std::size_t left = choice;; ++place) {
    if (isIdle(stepOf(offered.at(place)))) continue;
    if (left-- == 0) break;
  }
  auto step = stepOf(offered[place]);
  const auto before = difference(step.date, step.delay);
  step.date = seconds(simulation.take(place, when), offered[place].scale, model->unit);
  step.delay = difference(step.date, before);
  taken.steps.push_back(std::move(step));
  dated.push_back(when);
}

bool SimulatedRun::undo() {
  if (!simulation.undo()) return false;
  taken.steps.pop_back();
  dated.pop_back();
  return true;
}

std::optional<MissingStep> SimulatedRun::follow(std::span<const ChosenStep> wanted) {
  std::size_t same = 0;
  while (same < taken.steps.size() && same < wanted.size() &&
         readsAs(taken.steps[same], wanted[same]) &&
         taken.steps[same].transitions == wanted[same].transitions &&
         dated[same] == wanted[same].when)
    ++same;
  while (taken.steps.size() > same) undo();
  for (std::size_t i = same; i < wanted.size(); ++i) {
    const auto found = find(choices(), wanted[i]);
    if (!found) return MissingStep{i, whyMissing(wanted[i])};
    take(*found, wanted[i].when);
  }
  return std::nullopt;
}

/// The program may still allow the step at another time or by another path.
std::string SimulatedRun::whyMissing(const ChosenStep& wanted) const {
  const auto offered = choices();
  if (offered.empty()) return "no step is possible any more";
  const auto own = std::ranges::find(offered, wanted.actor, &TraceStep::actor);
  const auto& instead = own != offered.end() ? *own : offered.front();
  return fmt::format("{} `{}` {}", own != offered.end() ? "now" : "the next is", instead.actor,
                     instead.description);
}

std::map<std::string, std::string> SimulatedRun::values() const {
  std::map<std::string, std::string> now;
  for (const auto& first : taken.initial) now[first.variable] = first.after;
  for (const auto& step : taken.steps)
    for (const auto& change : step.changes) now[change.variable] = change.after;
  return now;
}

std::vector<UnmetValue> unmet(const SimulatedRun& run,
                              const std::map<std::string, std::string>& expected) {
  const auto values = run.values();
  std::vector<UnmetValue> all;
  for (const auto& [variable, wanted] : expected) {
    const auto found = values.find(variable);
    const auto actual = found == values.end() ? std::string() : found->second;
    if (actual != wanted) all.push_back({variable, wanted, actual});
  }
  return all;
}

} // namespace proskill::ide
