#pragma once

#include "verify/enabled.h"
#include "verify/goals.h"

#include <span>

namespace proskill::verify {

/// Variables that the environment sets to any of several values at any time. States that differ
/// only in which of these values such a variable has reach each other in no time, so one of them
/// stands for all; what it leads to is found by trying the values that each transition reads.
/// Compare Colby, Godefroid, Jagadeesan, "Automatically closing open reactive programs", PLDI 1998.
class OpenVariables {
public:
  struct Variable {
    CellId cell = 0;
    std::vector<std::int64_t> values;  ///< that can be set; the first stands for all
    std::vector<TransitionId> setters; ///< one for each value
    TransitionSet readers;             ///< transitions that are enabled or not by it
  };

  /// \pre the system is placed \param dropped transitions that are left out
  OpenVariables(const System& system, const std::vector<Goal>& goals, const Bits& dropped);

  /// The same for the same cells in other places.
  OpenVariables(const OpenVariables& from, const System& elsewhere) : OpenVariables(from) {
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

  /// Calls `visit` with each choice of values for those of `which` that are open in the state, set
  /// in place, until it says true; says whether it did. The state is as before afterwards, but
  /// where it was stopped.
  template <class Visit>
  bool eachChoice(std::span<const std::uint32_t> which, Word* state, Visit visit) const {
    if (which.empty()) return visit();
    auto before = valueOf(which[0], state);
    if (!before) return eachChoice(which.subspan(1), state, visit);
    for (std::uint32_t i = 0; i < variables[which[0]].values.size(); ++i) {
      set(which[0], i, state);
      if (eachChoice(which.subspan(1), state, visit)) return true;
    }
    set(which[0], *before, state);
    return false;
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
  [[nodiscard]] bool calm(Word* state, const TransitionSet& enabled,
                          const Enabling& enabling) const;

private:
  void findSetters(const std::vector<Goal>& goals, const Bits& dropped);
  [[nodiscard]] std::optional<Assignment> constantOf(const Transition& transition) const;
  [[nodiscard]] bool isAlwaysPossible(const Transition& transition) const;
  void forgetMany();

  const System* system;
  std::vector<Variable> variables;
  TransitionSet setters;
  std::vector<std::uint32_t> variableOf; ///< by transition, of setters
  TransitionSet silent;
  std::vector<std::vector<std::uint32_t>> reads;      ///< by transition: variables
  std::vector<std::vector<std::uint32_t>> guardReads; ///< by transition: variables
};

} // namespace proskill::verify
