#pragma once

#include "analysis/flow/bits.h"
#include "analysis/flow/variables.h"

#include <deque>
#include <map>
#include <vector>

namespace proskill::analysis::flow {

/// Moves of one variable: from each class, the classes that somebody may change it to.
class Relation {
public:
  explicit Relation(unsigned classes) : rows(classes) {}

  /// \return something is new
  bool add(unsigned from, ValueSet to) {
    to = to - ValueSet::of(from);
    if (to.within(rows[from])) return false;
    rows[from] |= to;
    sources |= ValueSet::of(from);
    return true;
  }
  void addAll(const Relation& other) {
    forEach(other.sources, [&](unsigned from) { add(from, other.rows[from]); });
  }
  [[nodiscard]] ValueSet from(unsigned index) const { return rows[index]; }
  [[nodiscard]] bool empty() const { return sources.empty(); }

  /// What a variable with one of these values may have after any number of moves.
  [[nodiscard]] ValueSet closure(ValueSet values) const {
    ValueSet pending = values & sources;
    while (!pending.empty()) {
      ValueSet added = rows[pending.first()] - values;
      pending.removeFirst();
      values |= added;
      pending |= added & sources;
    }
    return values;
  }

private:
  std::vector<ValueSet> rows;
  ValueSet sources; ///< with a row that is not empty
};

/// Who changes what: the moves that each process makes with each variable, whenever it makes them.
/// It only grows while the analysis runs. This is the rely-guarantee method, one variable at a
/// time: C. B. Jones, "Tentative steps toward a development method for interfering programs",
/// TOPLAS 1983; A. Miné, "Static analysis of run-time errors in embedded critical parallel C
/// programs", ESOP 2011.
class Interference {
public:
  Interference(const Variables& variables, std::size_t processes);

  /// Notes that a process may move a variable. \return something is new
  bool add(std::size_t process, VariableId variable, unsigned from, ValueSet to);

  /// The moves of a variable that any process of the set makes; it grows with them.
  [[nodiscard]] const Relation& of(const Bits& processes, VariableId variable);
  /// The moves of one process; null where it makes none.
  [[nodiscard]] const Relation* by(std::size_t process, VariableId variable) const;
  /// The processes that may move a variable, in their order.
  [[nodiscard]] std::vector<std::size_t> writers(VariableId variable) const;

private:
  struct View {
    const Bits* processes;
    Relation relation;
  };
  struct PerVariable {
    std::map<std::size_t, Relation> writers;
    std::map<const Bits*, View> views;
  };

  const Bits* intern(const Bits& processes);

  const Variables& variables;
  std::map<Bits, std::size_t> known;
  std::vector<PerVariable> all;
};

} // namespace proskill::analysis::flow
