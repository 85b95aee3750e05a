#pragma once

#include "analysis/flow/domain/state.h"
#include "analysis/flow/engine/call_order.h"
#include "analysis/flow/engine/graph.h"

#include <map>
#include <utility>
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

/// Somebody who closes what it knows under a relation, and wants to know when that grows.
struct Reader {
  ProcessId process = 0;
  NodeId node = kNoNode; ///< the node that looks at the moves; none: all that know the slot
  bool inside = false;   ///< of these, those where the skill is running; or else the others
  Slot slot = 0;
};

/// The moves that some processes make with one variable.
struct View {
  const IdSet* processes = nullptr;
  Relation relation;
  std::vector<Reader> readers;
};

/// Who changes what: the moves that each process makes with each variable, whenever it makes them.
/// It only grows while the analysis runs. This is the rely-guarantee method, one variable at a
/// time: C. B. Jones, "Tentative steps toward a development method for interfering programs",
/// TOPLAS 1983; A. Miné, "Static analysis of run-time errors in embedded critical parallel C
/// programs", ESOP 2011.
class Interference {
public:
  explicit Interference(const Variables& variables);

  /// Notes that a process may move a variable, and calls `tell(reader)` for each reader of a view
  /// that grows.
  template <class Tell>
  void add(ProcessId process, VariableId variable, unsigned from, ValueSet to, Tell&& tell) {
    forEach(added(process, variable, from, to), [&](unsigned index) {
      for (View* view : grown(process, variable, from, index)) {
        view->relation.add(from, ValueSet::of(index));
        for (const Reader& reader : view->readers) tell(reader);
      }
    });
  }

  /// The moves of a variable that any process of the set makes; it grows with them.
  [[nodiscard]] View& of(const IdSet& processes, VariableId variable);

private:
  struct PerVariable {
    std::map<ProcessId, Relation> writers;
    std::map<std::size_t, View> views; ///< by the number of the set
    /// For each move that somebody makes, the views of which nobody makes it.
    std::map<std::pair<unsigned, unsigned>, std::vector<View*>> without;
  };

  /// What is new of the moves that a process makes.
  ValueSet added(ProcessId process, VariableId variable, unsigned from, ValueSet to);
  /// The views that do not have the move yet, and do now.
  std::vector<View*> grown(ProcessId process, VariableId variable, unsigned from, unsigned to);

  const Variables& variables;
  std::map<IdSet, std::size_t> known; ///< with their numbers
  std::vector<PerVariable> all;
};

} // namespace proskill::analysis::flow
