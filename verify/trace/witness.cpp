#include "verify/trace/witness.h"

#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"
#include "verify/trace/causes.h"
#include "verify/trace/dates.h"
#include "verify/trace/replay.h"
#include "verify/trace/step_description.h"
#include "verify/trace/waits.h"

#include <algorithm>

namespace proskill::verify {

namespace {

/// Bytes of a step of a trace, with what it usually refers to, in this form and in the terms of the
/// program.
constexpr std::size_t kRoomPerStep = 2 * sizeof(Step);

/// Steps that replace those of evidence, and the new positions of the latter.
struct Rewritten {
  Steps steps;
  std::vector<std::size_t> ownPlaces{0}; ///< by number of steps: positions directly after them
  std::vector<std::size_t> places{0};    ///< the same, after inserted steps

  void endStep() { ownPlaces.push_back(steps.size()); }
  void endPlace() { places.push_back(steps.size()); }

  /// The evidence with these steps.
  [[nodiscard]] Evidence of(const Evidence& evidence) const {
    Evidence made = evidence;
    made.steps = steps;
    for (auto& mark : made.marks)
      mark.after = mark.until = (mark.atStep ? ownPlaces : places)[mark.after];
    if (made.loop) made.loop = places[*made.loop];
    return made;
  }
};

/// A state of the system and its enabled transitions, which steps change.
class FollowedState {
public:
  FollowedState(const System& of, const Enabling& with)
      : system(of), enabling(with), state(initialState(of)) {
    enabling.compute(state.data(), enabled);
  }

  /// \return whether the step was possible; otherwise this has no meaning any more
  bool take(TransitionId id) {
    if (fire(system, id, state.data()) != Outcome::Done) return false;
    enabling.update(id, state.data(), enabled);
    return true;
  }

  [[nodiscard]] const Word* words() const { return state.data(); }
  [[nodiscard]] bool isUrgent() const { return enabling.isUrgent(enabled); }

private:
  const System& system;
  const Enabling& enabling;
  std::vector<Word> state;
  TransitionSet enabled;
};

/// By step: whether the monitor moves with it, so that it cannot be removed.
std::vector<bool> readSteps(const Evidence& evidence) {
  std::vector<bool> read(evidence.steps.size());
  for (const auto& mark : evidence.marks)
    if (mark.atStep) read[mark.after - 1] = true;
  return read;
}

/// The evidence without a step that the monitor does not read.
Evidence without(const Evidence& evidence, std::size_t step) {
  Evidence made = evidence;
  made.steps.erase(made.steps.begin() + static_cast<std::ptrdiff_t>(step));
  for (auto& mark : made.marks) {
    if (mark.after > step) --mark.after;
    if (mark.until > step) --mark.until;
  }
  return made;
}

} // namespace

Witness::Witness(const System& whole, const Reductions& used, const fiacre::Provenance& origins,
                 LimitWatch& watch)
    : system(whole),
      dropped(used.dropped),
      provenance(origins),
      limits(watch),
      played(whole, watch),
      changing(whole.transitions.size()) {
  if (used.freeInputs) open.emplace(*used.freeInputs, whole);
}

const Enabling& Witness::enablingOfAll() const { return madeOnce(wholeTables, {}); }

const Enabling& Witness::enablingOfSearch() const {
  return dropped.empty() ? enablingOfAll() : madeOnce(searchedTables, dropped);
}

const Enabling& Witness::madeOnce(std::optional<Enabling>& tables, const Bits& without) const {
  if (!tables) {
    limits.checkLargeGrowth(Enabling::mostBytes(system));
    tables.emplace(system, without);
  }
  return *tables;
}

std::optional<Dating> Witness::dates(const Evidence& evidence) const {
  return dated(system, enablingOfAll(), evidence, limits);
}

/// Dates and replays the evidence. \param windows see dated() \return an error; empty on success
std::string Witness::check(const Goal& goal, const Evidence& evidence,
                           std::optional<Dating>& dating, bool windows) const {
  dating = dated(system, enablingOfAll(), evidence, limits, windows);
  if (!dating) return "the steps have no dates";
  return replay(system, goal, evidence, *dating, played);
}

std::string Witness::refutation(const Goal& goal, const Evidence& evidence) const {
  std::optional<Dating> dating;
  return check(goal, evidence, dating, false);
}

std::expected<Answer, std::string> Witness::answer(const Goal& goal, const Evidence& evidence,
                                                   bool wantsTrace) const {
  if (!wantsTrace) {
    auto wrong = refutation(goal, evidence);
    if (!wrong.empty()) return std::unexpected(std::move(wrong));
    return Answer{Truth::False, std::nullopt, {}, evidence.steps.size()};
  }
  auto made = trace(goal, evidence);
  if (!made) return std::unexpected(std::move(made.error()));
  const auto steps = made->steps.size();
  return Answer{Truth::False, std::move(*made), {}, steps};
}

/// Room for the steps, which a caller may then describe in other words: that takes as much again.
void Witness::reserveSteps(Trace& made, std::size_t count) const {
  limits.checkLargeGrowth(kRoomPerStep * count);
  made.steps.reserve(count);
}

std::expected<Trace, std::string> Witness::trace(const Goal& goal, const Evidence& evidence) const {
  std::optional<Dating> dating;
  std::string wrong = check(goal, evidence, dating, true);
  if (!wrong.empty()) return std::unexpected(wrong);

  Trace made{.scale = dating->scale,
             .end = goal.kind == GoalKind::Run || !evidence.differences.empty() ? dating->end : 0,
             .loop = evidence.loop};
  if (goal.kind == GoalKind::Run)
    made.rest = played.restAfter(made.loop.value_or(evidence.steps.size()));
  std::vector<Word> state = initialState(system);
  made.initial = valuesIn(system, state);
  StepLog log;
  reserveSteps(made, evidence.steps.size());
  for (std::size_t i = 0; i < evidence.steps.size(); ++i) {
    limits.check();
    const std::vector<Word> before = state;
    log.clear();
    const Outcome outcome = fire(system, evidence.steps[i], state.data(), log);
    const bool fails = outcome == Outcome::Failed && goal.kind == GoalKind::Error;
    if (outcome != Outcome::Done && !fails) return std::unexpected("a step fails");
    if (fails) state = before;
    const Window& window = dating->steps[i];
    made.steps.push_back(
        {.origins = mostDescriptiveLast(provenance, log),
         .transitions = {nameOf(system, evidence.steps[i], log)},
         .instances = instancesOf(system, evidence.steps[i]),
         .earliest = window.earliest,
         .latest = window.latest,
         .date = window.date,
         .changes = changesBetween(system, watchedBy(evidence.steps[i]), before, state),
         .failure = fails ? log.failure : ""});
  }
  if (goal.kind == GoalKind::Deadlock || evidence.rest)
    made.waits = waitsIn(system, provenance, state);
  addCauses(goal, evidence, made);
  return made;
}

/// Replays the relevant steps alone; if this fails, every step counts as relevant. If a limit is
/// reached, the trace stays unchanged.
void Witness::addCauses(const Goal& goal, const Evidence& evidence, Trace& trace) const {
  try {
    auto causes = causesOf(system, enablingOfAll(), provenance, goal, evidence, limits);
    const bool stands = reproduces(system, goal, evidence, causes.relevant);
    for (std::size_t i = 0; i < trace.steps.size(); ++i) {
      auto& step = trace.steps[i];
      step.causes = std::move(causes.of[i]);
      step.grounds = std::move(causes.grounds[i]);
      step.timer = causes.timers[i];
      step.relevant = !stands || causes.relevant[i];
    }
    trace.support = std::move(causes.support);
  } catch (const LimitMet&) {
  }
}

/// Watched variables that a step may change, by index.
const std::vector<std::uint32_t>& Witness::watchedBy(TransitionId step) const {
  auto& known = changing[step];
  if (known) return *known;
  known.emplace();
  for (std::uint32_t i = 0; i < system.watched.size(); ++i)
    if (system.transitions[step].writes.contains(system.watched[i].cell)) known->push_back(i);
  return *known;
}

Evidence Witness::tidied(const Goal& goal, const Evidence& evidence) const {
  Evidence whole = completed(goal, evidence);
  if (!open) return whole;
  Evidence better = completed(goal, lazily(goal, evidence));
  if (!refutation(goal, better).empty()) return whole;
  if (goal.kind == GoalKind::Lost) return better; // a replay does not show that a moment is lost
  constexpr std::size_t kLong = 400;
  if (better.steps.size() >= kLong) return better;
  const std::vector<bool> read = readSteps(better); // only steps after the current one are removed
  std::vector<std::size_t> setters;                 // the last one first
  for (std::size_t i = better.steps.size(); i-- > 0;)
    if (open->isSetter(better.steps[i]) && !read[i]) setters.push_back(i);
  Evidence bare = better;
  for (auto setter : setters) bare = without(bare, setter);
  if (refutation(goal, bare).empty()) return bare;
  for (auto setter : setters) {
    Evidence shorter = without(better, setter);
    if (refutation(goal, shorter).empty()) better = std::move(shorter);
  }
  return better;
}

/// The search sets open variables before each step and back after it. Here they are set only when a
/// step reads them, when time could not pass otherwise, and as required at the end.
Evidence Witness::lazily(const Goal& goal, const Evidence& evidence) const {
  const Steps& steps = evidence.steps;
  const bool valuesAtEnd = goal.kind == GoalKind::Stuck;
  const bool lastIsAskedFor = !valuesAtEnd && goal.kind != GoalKind::Run;
  const std::vector<bool> read = readSteps(evidence);
  FollowedState there(system, enablingOfSearch()); // as in the search
  FollowedState here(system, enablingOfSearch());
  Rewritten made;
  const auto take = [&](TransitionId id) {
    limits.check();
    made.steps.push_back(id);
    return here.take(id);
  };
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const TransitionId step = steps[i];
    const bool stays = read[i] || (lastIsAskedFor && i + 1 == steps.size());
    if (open->isSetter(step) && !stays) {
      if (!there.take(step)) return evidence;
    } else {
      for (auto setter : open->between(here.words(), there.words(), open->readBy(step)))
        take(setter);
      if (!take(step) || !there.take(step)) return evidence;
    }
    made.endStep();
    if (here.isUrgent() && !there.isUrgent())
      for (auto setter : open->between(here.words(), there.words())) take(setter);
    made.endPlace();
  }
  if (valuesAtEnd)
    for (auto setter : open->between(here.words(), there.words())) take(setter);
  return made.of(evidence);
}

/// The steps with those of the dropped processes inserted as soon as they are urgent.
Evidence Witness::completed(const Goal& goal, const Evidence& evidence) const {
  if (dropped.empty()) return evidence;
  Rewritten made;
  std::vector<Word> state = initialState(system);
  TransitionSet enabled;
  const Enabling& all = enablingOfAll();
  all.compute(state.data(), enabled);
  StepLog log;
  const auto take = [&](TransitionId id) {
    limits.check();
    made.steps.push_back(id);
    const bool isDone = fire(system, id, state.data(), log) == Outcome::Done;
    all.update(id, state.data(), enabled);
    return isDone;
  };
  const auto takeOne = [&](bool urgent) {
    Steps possible;
    dropped.each([&](TransitionId id) {
      if (contains(enabled, id) && system.transitions[id].urgent == urgent) possible.push_back(id);
    });
    return std::ranges::any_of(possible, take);
  };
  const auto settle = [&](bool alsoLater) {
    while (takeOne(true) || (alsoLater && takeOne(false))) {
    }
  };
  // A monitor moves in a state after all urgent steps.
  if (evidence.monitor) settle(false);
  made.places[0] = made.steps.size();
  for (auto step : evidence.steps) {
    settle(false);
    if (!take(step)) return evidence;
    made.endStep();
    if (evidence.monitor) settle(false);
    made.endPlace();
  }
  if (goal.kind == GoalKind::Deadlock || evidence.rest) settle(true);
  Evidence whole = made.of(evidence);
  for (std::size_t i = 0; evidence.rest && i < whole.marks.size(); ++i)
    if (!whole.marks[i].atStep && evidence.marks[i].after == evidence.steps.size())
      whole.marks[i].until = whole.steps.size(); // it may be later
  return whole;
}

} // namespace proskill::verify
