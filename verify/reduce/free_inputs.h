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
/// only in these values reach each other in no time, so one of them represents all. Its successors
/// are found by trying the values that each transition reads. Compare Colby, Godefroid, Jagadeesan,
/// "Automatically closing open reactive programs", PLDI 1998.
class FreeInputs {
public:
  using Variable = FreeInput;

  /// \pre the system has a state layout
  /// \param dropped transitions that are skipped
  FreeInputs(const System& system, const std::vector<Goal>& goals, const Bits& dropped);

  /// The same inputs in a system whose cells have another layout.
  FreeInputs(const FreeInputs& from, const System& elsewhere) : FreeInputs(from) {
    system = &elsewhere;
  }

  [[nodiscard]] bool none() const { return variables.empty(); }
  [[nodiscard]] const std::vector<Variable>& all() const { return variables; }
  [[nodiscard]] bool isSetter(TransitionId transition) const {
    return contains(setters, transition);
  }
  /// Whether the transition only leads to another state with the same representative.
  [[nodiscard]] bool staysWithin(TransitionId transition, const Word* state) const;
  /// Whether the transition is a setter that no goal asks for.
  [[nodiscard]] bool isSilent(TransitionId transition) const {
    return contains(silent, transition);
  }
  /// Indices of the variables that the transition's guard and code read.
  [[nodiscard]] const std::vector<std::uint32_t>& readBy(TransitionId id) const {
    return reads[id];
  }

  /// The index of a variable's value in the state; nothing if the environment never sets this
  /// value.
  [[nodiscard]] std::optional<std::uint32_t> valueOf(std::uint32_t variable,
                                                     const Word* state) const;
  void set(std::uint32_t variable, std::uint32_t value, Word* state) const;

  /// A superset of the transitions that are enabled for some values of the inputs.
  [[nodiscard]] TransitionSet candidates(const Word* state, const TransitionSet& enabled) const;

  /// Calls `visit` for each way to fire the transition from a state with this representative, until
  /// `visit` returns true; returns whether it did. Ways differ in the values that the transition's
  /// code reads; for the other inputs, one choice is found that satisfies the guard. `visit` sees
  /// the values in `state`; afterwards they are restored, unless `visit` returned true.
  template <class Visit> bool eachFiring(TransitionId id, Word* state, Visit visit) const {
    std::vector<Word> unknown = unknownIn(guardReads[id], state);
    return eachOf(codeReads[id], id, state, unknown, visit);
  }

  /// Sets every open variable to its representative value. \return the setters that do this
  std::vector<TransitionId> normalise(Word* state, TransitionSet& enabled,
                                      const Enabling& enabling) const;
  /// The setters that lead from one state to another that differs only in open variables.
  [[nodiscard]] std::vector<TransitionId> between(const Word* from, const Word* to) const;
  /// The same for some variables only.
  [[nodiscard]] std::vector<TransitionId> between(const Word* from, const Word* to,
                                                  std::span<const std::uint32_t> which) const;
  /// Whether time may pass for some values of the inputs; if so, sets these values in the state.
  [[nodiscard]] bool calm(Word* state, const TransitionSet& enabled) const;

  /// The bits of all variables whose current value the environment chooses.
  [[nodiscard]] std::vector<Word> chosenBits(const Word* state) const;
  /// Whether the transition is enabled although some bits are unknown.
  /// \param undecided if the result is Unknown: bits on which it depends
  [[nodiscard]] PartialTruth truth(TransitionId id, const Word* state,
                                   const std::vector<Word>& unknown, BitField& undecided) const;
  /// The variable to which these bits belong.
  [[nodiscard]] std::uint32_t variableAt(const BitField& bits) const;
  /// An unknown variable that the transition's code reads or writes; nothing if there is none.
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
  /// Finds values for the unknown bits that enable the transition, and calls `visit` with them set.
  template <class Visit>
  bool visitOne(TransitionId id, Word* state, std::vector<Word>& unknown, Visit& visit) const {
    const std::vector<Word> before(state, state + system->words);
    std::vector<Word> open = unknown;
    if (!satisfy(id, state, open)) return false;
    if (visit()) return true;
    std::copy(before.begin(), before.end(), state);
    return false;
  }
  /// Calls `visit` with each value of a variable set, until it returns true. Otherwise restores the
  /// state and `unknown`.
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
  /// Calls `visit` for each transition whose guard reads a free input and whose first instance is
  /// in its source location.
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
  std::vector<std::uint32_t> variableOf; ///< by transition: the variable that this setter sets
  TransitionSet silent;
  PartialEvaluation evaluation;
  TransitionSet guarded; ///< transitions whose guard reads a free input
  TransitionSet urgent;
  /// The transitions of `guarded`, by an instance that takes part and its source location.
  std::vector<std::pair<InstanceId, std::vector<std::vector<TransitionId>>>> guardedAt;
  std::vector<std::vector<std::uint32_t>> reads;      ///< by transition: indices of variables
  std::vector<std::vector<std::uint32_t>> guardReads; ///< by transition: indices of variables
  std::vector<std::vector<std::uint32_t>> codeReads;  ///< by transition: indices of variables
};

} // namespace proskill::verify
