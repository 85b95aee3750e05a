#include "verify/reduce/free_inputs.h"

#include "verify/model/nodes.h"
#include "verify/reduce/path_facts.h"
#include "verify/state/evaluate.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace proskill::verify {

namespace {

/// Limit of the combinations of values that the code of one transition reads.
constexpr std::size_t kMostChoices = 1024;

} // namespace

FreeInputs::FreeInputs(const System& of, const std::vector<Goal>& goals, const Bits& dropped)
    : system(&of),
      variables(findFreeInputs(of, goals, dropped)),
      setters((of.transitions.size() + 63) / 64),
      silent(setters),
      evaluation(of) {
  const Bits observed = eventsOf(of, goals);
  for (auto& variable : variables) variable.readers.assign(setters.size(), 0);
  forgetMany(dropped);
  variableOf.assign(system->transitions.size(), kNone);
  for (std::uint32_t v = 0; v < variables.size(); ++v)
    for (auto setter : variables[v].setters) {
      insert(setters, setter);
      variableOf[setter] = v;
      if (!mayPass(*system, system->transitions[setter], observed)) insert(silent, setter);
    }
  findReads(dropped);
  findPlaces(dropped);
}

void FreeInputs::findReads(const Bits& dropped) {
  for (TransitionId i = 0; i < system->transitions.size(); ++i) {
    const auto& transition = system->transitions[i];
    auto& read = reads.emplace_back();
    auto& guard = guardReads.emplace_back();
    auto& code = codeReads.emplace_back();
    for (std::uint32_t v = 0; v < variables.size(); ++v) {
      const CellId cell = variables[v].cell;
      const bool guarded = transition.guardReads.contains(cell);
      const bool inCode = transition.reads.contains(cell);
      if (guarded) guard.push_back(v);
      if (inCode || (guarded && transition.tentative)) code.push_back(v);
      if (guarded || inCode) read.push_back(v);
      if (guarded && !dropped.contains(i)) insert(variables[v].readers, i);
    }
  }
}

void FreeInputs::findPlaces(const Bits& dropped) {
  guarded = urgent = TransitionSet(setters.size());
  std::map<InstanceId, std::vector<std::vector<TransitionId>>> places;
  for (TransitionId i = 0; i < system->transitions.size(); ++i) {
    const auto& transition = system->transitions[i];
    if (transition.urgent && !dropped.contains(i)) insert(urgent, i);
    if (guardReads[i].empty() || dropped.contains(i)) continue;
    insert(guarded, i);
    const Path& first = system->paths[transition.parts[0]];
    auto& byLocation = places[first.instance];
    byLocation.resize(system->instances[first.instance].locations.size());
    byLocation[first.location].push_back(i);
  }
  guardedAt.assign(places.begin(), places.end());
}

/// Gives up open variables while the code of a transition has too many choices; keeps those with
/// the most values.
void FreeInputs::forgetMany(const Bits& dropped) {
  std::ranges::stable_sort(variables, std::greater{},
                           [](const auto& variable) { return variable.values.size(); });
  std::vector<std::size_t> choices(system->transitions.size(), 1);
  const auto reads = [&](TransitionId i, CellId cell) {
    const auto& transition = system->transitions[i];
    return !dropped.contains(i) && (transition.reads.contains(cell) ||
                                    (transition.tentative && transition.guardReads.contains(cell)));
  };
  std::erase_if(variables, [&](const Variable& variable) {
    std::vector<std::size_t> more = choices;
    for (TransitionId i = 0; i < more.size(); ++i)
      if (reads(i, variable.cell)) more[i] *= variable.values.size();
    const bool tooMany = std::ranges::any_of(more, [](auto count) { return count > kMostChoices; });
    if (!tooMany) choices = std::move(more);
    return tooMany;
  });
}

bool FreeInputs::staysWithin(TransitionId transition, const Word* state) const {
  return variableOf[transition] != kNone && valueOf(variableOf[transition], state).has_value();
}

std::optional<std::uint32_t> FreeInputs::valueOf(std::uint32_t index, const Word* state) const {
  const Variable& variable = variables[index];
  auto found = std::ranges::find(variable.values, readCell(*system, variable.cell, state));
  if (found == variable.values.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - variable.values.begin());
}

void FreeInputs::set(std::uint32_t variable, std::uint32_t value, Word* state) const {
  writeCell(*system, variables[variable].cell, variables[variable].values[value], state);
}

std::vector<TransitionId> FreeInputs::normalise(Word* state, TransitionSet& enabled,
                                                const Enabling& enabling) const {
  std::vector<TransitionId> steps;
  for (std::uint32_t v = 0; v < variables.size(); ++v) {
    if (valueOf(v, state).value_or(0) == 0) continue;
    appendMoves(v, readCell(*system, variables[v].cell, state), 0, steps);
    set(v, 0, state);
    enabling.refresh(variables[v].readers, state, enabled);
  }
  return steps;
}

void FreeInputs::appendMoves(std::uint32_t index, std::int64_t from, std::uint32_t to,
                             std::vector<TransitionId>& steps) const {
  const Variable& variable = variables[index];
  const std::int64_t low = system->cells[variable.cell].low;
  while (from != variable.values[to]) {
    const InputMove& move = variable.moves[static_cast<std::size_t>(from - low)][to];
    if (move.setter == kNone) return; // no setter is possible there
    steps.push_back(move.setter);
    from = move.next;
  }
}

std::vector<TransitionId> FreeInputs::between(const Word* from, const Word* to) const {
  std::vector<std::uint32_t> which(variables.size());
  std::iota(which.begin(), which.end(), 0U);
  return between(from, to, which);
}

std::vector<TransitionId> FreeInputs::between(const Word* from, const Word* to,
                                              std::span<const std::uint32_t> which) const {
  std::vector<TransitionId> steps;
  for (auto v : which) {
    if (const auto wanted = valueOf(v, to))
      appendMoves(v, readCell(*system, variables[v].cell, from), *wanted, steps);
  }
  return steps;
}

std::vector<Word> FreeInputs::unknownIn(std::span<const std::uint32_t> which,
                                        const Word* state) const {
  std::vector<Word> unknown(system->words);
  for (auto v : which) {
    const Cell& cell = system->cells[variables[v].cell];
    if (valueOf(v, state)) unknown[cell.word] |= cell.mask;
  }
  return unknown;
}

std::uint32_t FreeInputs::variableAt(const BitField& bits) const {
  const auto found = std::ranges::find_if(variables, [&](const Variable& variable) {
    const Cell& cell = system->cells[variable.cell];
    return cell.word == bits.word && (cell.mask & bits.mask) != 0;
  });
  return static_cast<std::uint32_t>(found - variables.begin());
}

PartialTruth FreeInputs::truth(TransitionId id, const Word* state, const std::vector<Word>& unknown,
                               BitField& undecided) const {
  const Transition& transition = system->transitions[id];
  const auto known = evaluation.guard(*system, transition, {state, unknown.data()}, undecided);
  if (known != PartialTruth::True || !transition.tentative) return known;
  for (auto v : guardReads[id]) { // an `on` in its code may read any of them
    const Cell& cell = system->cells[variables[v].cell];
    if ((unknown[cell.word] & cell.mask) == 0) continue;
    undecided = {cell.word, cell.mask};
    return PartialTruth::Unknown;
  }
  return isEnabled(*system, id, state) ? PartialTruth::True : PartialTruth::False;
}

/// Sets values of unknown variables so that the transition is enabled. \return false, with the
/// state unchanged, if there are none
bool FreeInputs::satisfy(TransitionId id, Word* state, std::vector<Word>& unknown) const {
  BitField undecided;
  switch (truth(id, state, unknown, undecided)) {
  case PartialTruth::False: return false;
  case PartialTruth::True: return true;
  case PartialTruth::Unknown: break;
  }
  return tryValues(variableAt(undecided), state, unknown,
                   [&] { return satisfy(id, state, unknown); });
}

/// Sets values such that none of the transitions is enabled.
bool FreeInputs::disable(std::span<const TransitionId> all, Word* state,
                         std::vector<Word>& unknown) const {
  BitField undecided;
  std::vector<TransitionId> unsure;
  for (auto id : all) {
    BitField open;
    const PartialTruth known = truth(id, state, unknown, open);
    if (known == PartialTruth::False) continue;
    if (known == PartialTruth::True) return false;
    unsure.push_back(id);
    undecided = open;
  }
  if (unsure.empty()) return true;
  return tryValues(variableAt(undecided), state, unknown,
                   [&] { return disable(unsure, state, unknown); });
}

TransitionSet FreeInputs::candidates(const Word* state, const TransitionSet& enabled) const {
  TransitionSet all = enabled;
  for (std::size_t k = 0; k < all.size(); ++k) all[k] &= ~guarded[k];
  eachGuardedHere(state, [&](TransitionId id) { insert(all, id); });
  return all;
}

std::vector<Word> FreeInputs::chosenBits(const Word* state) const {
  std::vector<std::uint32_t> all(variables.size());
  std::iota(all.begin(), all.end(), 0U);
  return unknownIn(all, state);
}

std::optional<std::uint32_t> FreeInputs::touchedBy(TransitionId id,
                                                   const std::vector<Word>& unknown) const {
  const Transition& transition = system->transitions[id];
  for (std::uint32_t v = 0; v < variables.size(); ++v) {
    const Cell& cell = system->cells[variables[v].cell];
    const bool touched = transition.reads.contains(variables[v].cell) ||
                         transition.writes.contains(variables[v].cell);
    if (touched && (unknown[cell.word] & cell.mask) != 0) return v;
  }
  return std::nullopt;
}

bool FreeInputs::calm(Word* state, const TransitionSet& enabled) const {
  for (std::size_t k = 0; k < enabled.size(); ++k)
    if ((enabled[k] & urgent[k] & ~guarded[k]) != 0) return false;
  std::vector<TransitionId> unsure;
  std::vector<std::uint32_t> which;
  eachGuardedHere(state, [&](TransitionId id) {
    if (!contains(urgent, id)) return;
    unsure.push_back(id);
    which.insert(which.end(), guardReads[id].begin(), guardReads[id].end());
  });
  std::vector<Word> unknown = unknownIn(which, state);
  return disable(unsure, state, unknown);
}

} // namespace proskill::verify
