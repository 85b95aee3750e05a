#include "verify/graph/marking_expander.h"

#include "verify/state/evaluate.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace proskill::verify {

namespace {

/// Whether a path may end in more than one location.
bool branches(const Path& path) {
  std::optional<std::uint32_t> first;
  for (const auto& instruction : path.code) {
    const bool isEnd = instruction.kind == InstructionKind::To;
    if (!isEnd && instruction.kind != InstructionKind::Loop) continue;
    const std::uint32_t end = isEnd ? instruction.last : path.location;
    if (first.value_or(end) != end) return true;
    first = end;
  }
  return false;
}

} // namespace

unsigned ownerOf(const Ranks& ranks, std::span<const Word> marking) {
  const std::uint64_t hash = hashOfAll(marking);
  return static_cast<unsigned>((hash >> 32) * ranks.count() >> 32);
}

std::uint32_t signatureOf(const TransitionSet& allowed, const System& system,
                          const Enabling& enabling, FiringDomains& domains) {
  std::vector<TransitionId> clocked;
  eachIn(allowed, [&](TransitionId transition) {
    if (system.transitions[transition].clock != kNone) clocked.push_back(transition);
  });
  return domains.signature(enabling.isUrgent(allowed), clocked);
}

MarkingExpander::MarkingExpander(const System& of, const Enabling& how, StateTree& all,
                                 const LimitWatch& watch, std::uint32_t self, GraphRecorder* to,
                                 const Ranks* others)
    : system(of),
      enabling(how),
      markings(all),
      limits(watch),
      number(self),
      recorder(to),
      ranks(others),
      domains(of),
      state(of.words),
      next(of.words) {
  for (const auto& transition : of.transitions)
    branching.push_back(std::ranges::any_of(transition.parts,
                                            [&](PathId part) { return branches(of.paths[part]); }));
}

void MarkingExpander::startChunk(std::vector<Claimant>& room) {
  own = {};
  claimants = &room;
  current.made = previous.made = nullptr; // if a limit ended the chunk before
}

void MarkingExpander::expand(std::uint32_t marking, ExpandedMarking& to) {
  std::swap(current, previous);
  current.made = &to;
  to.steps.clear();
  to.words.clear();
  to.possible.clear();
  to.failure = {};
  markings.read(marking, state.data(), path);
  enabling.compute(state.data(), current.enabled);
  fireAll();
  if (previous.made)
    for (const auto& root : previous.group.roots)
      if (root) markings.roots.prefetchState(*root);
  const auto& roots = markings.findRoots(current.targets, system.words, path, current.group);
  for (const auto& root : roots)
    if (root) markings.roots.prefetchSlot(*root);
  findTargets(previous);
}

void MarkingExpander::finish() { findTargets(current); }

/// Computes the markings after all transitions that are possible in the marking.
void MarkingExpander::fireAll() {
  current.targets.clear();
  eachIn(current.enabled, [&](TransitionId transition) {
    limits.check();
    if (enabling.isBlocked(transition, current.enabled) || !fireFromState(transition)) return;
    current.made->steps.push_back({.transition = transition});
    current.targets.insert(current.targets.end(), next.begin(), next.end());
    if (recorder) current.made->steps.back().label = recorder->label(transition, log);
  });
}

/// Computes the marking after a transition, and notes what was possible. \return whether it is
bool MarkingExpander::fireFromState(TransitionId transition) {
  next = state;
  log.clear();
  const Outcome outcome =
      recorder ? fire(system, transition, next.data(), log) : fire(system, transition, next.data());
  if (outcome == Outcome::Failed) noteFailure(transition);
  if (outcome != Outcome::Done) return false;
  notePossible(transition, next.data());
  return true;
}

/// Says why a transition cannot be fired from the marking.
void MarkingExpander::noteFailure(TransitionId transition) {
  Unsupported& failure = current.made->failure;
  if (!failure.message.empty()) return;
  next = state;
  log.clear();
  std::ignore = fire(system, transition, next.data(), log);
  failure = {log.failure, log.origins.empty() ? 0 : log.origins.back()};
}

void MarkingExpander::notePossible(TransitionId transition, const Word* after) {
  auto& possible = current.made->possible;
  possible.push_back(transition);
  if (!branching[transition]) return;
  for (auto part : system.transitions[transition].parts) {
    const auto& instance = system.instances[system.paths[part].instance];
    possible.push_back(static_cast<std::uint32_t>(readCell(system, instance.location, after)));
  }
}

/// Numbers or claims the markings after the steps.
void MarkingExpander::findTargets(Begun& from) {
  ExpandedMarking* made = std::exchange(from.made, nullptr);
  if (!made) return;
  for (std::size_t i = 0; i < made->steps.size(); ++i) {
    MarkingStep& step = made->steps[i];
    const auto after = std::span(from.targets).subspan(i * system.words, system.words);
    if (isFound(step, from.group.roots[i], after, from.enabled)) continue;
    step.words = made->words.size();
    made->words.insert(made->words.end(), after.begin(), after.end());
    step.signature = signatureAfter(step, after, from.enabled);
  }
}

/// Numbers or claims the marking after a step, unless another rank has it, or it needs nodes or a
/// claim that the tables lack. \return whether this is done
bool MarkingExpander::isFound(MarkingStep& step, const std::optional<SoughtRoot>& root,
                              std::span<const Word> after, const TransitionSet& before) {
  step.isElsewhere = ranks && ownerOf(*ranks, after) != ranks->self();
  if (!root || step.isElsewhere) return false;
  const auto found = markings.roots.findOrClaim(*root, number, own);
  step.marking = found.id;
  step.claim = found.claim;
  if (found.isNew) (*claimants)[found.claim] = {number, signatureAfter(step, after, before)};
  return found.id != kNone || found.claim != kNone;
}

std::uint32_t MarkingExpander::signatureAfter(const MarkingStep& step, std::span<const Word> after,
                                              const TransitionSet& before) {
  nextEnabled = before;
  enabling.update(step.transition, after.data(), nextEnabled);
  return signatureOf(nextEnabled, system, enabling, domains);
}

} // namespace proskill::verify
