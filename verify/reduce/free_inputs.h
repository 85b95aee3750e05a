#pragma once

#include "verify/model/goals.h"
#include "verify/reduce/input_setters.h"
#include "verify/state/enabled.h"
#include "verify/state/evaluate.h"
#include "verify/state/partial_evaluation.h"

#include <algorithm>
#include <span>

namespace proskill::verify {

/// Variables that the environment sets to any of several values at any time. States that differ
/// only in which of these values such a variable has reach each other in no time, so one of them
/// stands for all; what it leads to is found by trying the values that each transition reads.
/// Compare Colby, Godefroid, Jagadeesan, "Automatically closing open reactive programs", PLDI 1998.
class FreeInputs {
public:
  using Variable = FreeInput;

  /// \pre the system has a state layout \param dropped transitions that are left out
  FreeInputs(const System& system, const std::vector<Goal>& goals, const Bits& dropped);

  /// The same for the same cells in other places.
  FreeInputs(const FreeInputs& from, const System& elsewhere) : FreeInputs(from) {
    system = &elsewhere;
  }

  [[nodiscard]] bool none() const { return variables.empty(); }
  [[nodiscard]] const std::vector<Variable>& all() const { return variables; }
  [[nodiscard]] bool isSetter(TransitionId transition) const {
    return contains(setters, transition);
  }
  /// Whether the transition only leads to another of the states that this one stands for.
  [[nodiscard]] bool staysWithin(TransitionId transition, const Word* state) const;
  /// A setter that does nothing which a goal asks for.
  [[nodiscard]] bool isSilent(TransitionId transition) const {
    return contains(silent, transition);
  }
  /// Indices of the variables that a transition's guard and code read.
  [[nodiscard]] const std::vector<std::uint32_t>& readBy(TransitionId id) const {
    return reads[id];
  }

  /// Which of a variable's values the state has; nothing where it has one that nobody sets.
  [[nodiscard]] std::optional<std::uint32_t> valueOf(std::uint32_t variable,
                                                     const Word* state) const;
  void set(std::uint32_t variable, std::uint32_t value, Word* state) const;

  /// The transitions that are enabled for some choice of values, and perhaps more.
  [[nodiscard]] TransitionSet candidates(const Word* state, const TransitionSet& enabled) const;

  /// Calls `visit` with each way to fire the transition from one of the states that this one stands
  /// for, until it says true; says whether it did. Ways differ in the values that the transition's
  /// code reads; for each, one choice of the others is found with which the guard holds. The values
  /// are set in place, and are as before afterwards, but where it was stopped.
  template <class Visit> bool eachFiring(TransitionId id, Word* state, Visit visit) const {
    std::vector<Word> unknown = unknownIn(guardReads[id], state);
    return eachOf(codeReads[id], id, state, unknown, visit);
  }

  /// Gives every open variable the value that stands for all. \return the setters that do it
  std::vector<TransitionId> normalise(Word* state, TransitionSet& enabled,
                                      const Enabling& enabling) const;
  /// The setters from one state to another that differs in open variables only.
  [[nodiscard]] std::vector<TransitionId> between(const Word* from, const Word* to) const;
  /// Those of some variables.
  [[nodiscard]] std::vector<TransitionId> between(const Word* from, const Word* to,
                                                  std::span<const std::uint32_t> which) const;
  /// Whether time may pass for some choice of values; the choice is then set in the state.
  [[nodiscard]] bool calm(Word* state, const TransitionSet& enabled) const;

  /// The bits of all variables that have a value which the environment chooses.
  [[nodiscard]] std::vector<Word> chosenBits(const Word* state) const;
  /// Whether the transition is enabled, where some bits are unknown. \param undecided where that is
  /// unknown: bits on which it depends
  [[nodiscard]] PartialTruth truth(TransitionId id, const Word* state,
                                   const std::vector<Word>& unknown, BitField& undecided) const;
  /// The variable that these bits belong to.
  [[nodiscard]] std::uint32_t variableAt(const BitField& bits) const;
  /// An unknown variable that the transition's code reads or writes.
  [[nodiscard]] std::optional<std::uint32_t> touchedBy(TransitionId id,
                                                       const std::vector<Word>& unknown) const;

private:
  template <class Visit>
  bool eachOf(std::span<const std::uint32_t> which, TransitionId id, Word* state,
              std::vector<Word>& unknown, Visit& visit) const {
    BitField ignored;
    if (truth(id, state, unknown, ignored) == PartialTruth::False) return false;
    if (which.empty()) return visitOne(id, state, unknown, visit);
    return tryValues(which[0], state, unknown,
                     [&] { return eachOf(which.subspan(1), id, state, unknown, visit); });
  }
  /// Finds values of what is unknown with which the transition is enabled, and visits it there.
  template <class Visit>
  bool visitOne(TransitionId id, Word* state, std::vector<Word>& unknown, Visit& visit) const {
    const std::vector<Word> before(state, state + system->words);
    std::vector<Word> open = unknown;
    if (!satisfy(id, state, open)) return false;
    if (visit()) return true;
    std::copy(before.begin(), before.end(), state);
    return false;
  }
  /// Calls `visit` with each value of a variable set, until it says true. Where it never does, the
  /// state and `unknown` are as before.
  template <class Visit>
  bool tryValues(std::uint32_t index, Word* state, std::vector<Word>& unknown, Visit visit) const {
    const auto before = valueOf(index, state);
    if (!before) return visit();
    const Cell& cell = system->cells[variables[index].cell];
    const Word wasUnknown = unknown[cell.word] & cell.mask;
    unknown[cell.word] &= ~cell.mask;
    for (std::uint32_t i = 0; i < variables[index].values.size(); ++i) {
      set(index, i, state);
      if (visit()) return true;
    }
    unknown[cell.word] |= wasUnknown;
    set(index, *before, state);
    return false;
  }

  [[nodiscard]] std::vector<Word> unknownIn(std::span<const std::uint32_t> which,
                                            const Word* state) const;
  bool satisfy(TransitionId id, Word* state, std::vector<Word>& unknown) const;
  bool disable(std::span<const TransitionId> all, Word* state, std::vector<Word>& unknown) const;
  void findReads(const Bits& dropped);
  void findPlaces(const Bits& dropped);
  /// Calls `visit` with each transition that a free input guards and whose first instance is
  /// where it needs it.
  template <class Visit> void eachGuardedHere(const Word* state, Visit visit) const {
    for (const auto& [instance, byLocation] : guardedAt) {
      const CellId cell = system->instances[instance].location;
      for (auto id : byLocation[static_cast<std::size_t>(readCell(*system, cell, state))])
        visit(id);
    }
  }
  void appendMoves(std::uint32_t variable, std::int64_t from, std::uint32_t to,
                   std::vector<TransitionId>& steps) const;
  void forgetMany(const Bits& dropped);

  const System* system;
  std::vector<Variable> variables;
  TransitionSet setters;
  std::vector<std::uint32_t> variableOf; ///< by transition, of setters
  TransitionSet silent;
  PartialEvaluation evaluation;
  TransitionSet guarded; ///< enabled or not by a free input
  TransitionSet urgent;
  /// Those of `guarded` by an instance that takes part, and its location.
  std::vector<std::pair<InstanceId, std::vector<std::vector<TransitionId>>>> guardedAt;
  std::vector<std::vector<std::uint32_t>> reads;      ///< by transition: variables
  std::vector<std::vector<std::uint32_t>> guardReads; ///< by transition: variables
  std::vector<std::vector<std::uint32_t>> codeReads;  ///< by transition: variables
};

} // namespace proskill::verify
