#pragma once

#include "analysis/flow/domain/state.h"
#include "analysis/flow/engine/call_order.h"
#include "analysis/flow/engine/graph.h"

#include <map>
#include <utility>
#include <vector>

namespace proskill::analysis::flow {

/// Moves of a variable: for each class, the classes to which some process may change it.
class Relation {
public:
  explicit Relation(unsigned classes) : rows(classes) {}

  /// \return whether the relation has grown
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

  /// The possible values of a variable after any number of moves from these values.
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
  ValueSet sources; ///< classes with a move
};

/// A user of a relation who must be notified when it grows.
struct Reader {
  ProcessId process = 0;
  /// The node that depends on the moves; kNoNode: all nodes that know the slot.
  NodeId node = kNoNode;
  /// Of these, only the nodes at which the skill is running; otherwise only the others.
  bool inside = false;
  Slot slot = 0;
};

/// The moves of one variable by some processes.
struct View {
  const IdSet* processes = nullptr;
  Relation relation;
  std::vector<Reader> readers;
};

/// Records which moves each process makes with each variable at any time. It only grows during the
/// analysis. This is the rely-guarantee method, applied to each variable separately: C. B. Jones,
/// "Tentative steps toward a development method for interfering programs", TOPLAS 1983; A. Miné,
/// "Static analysis of run-time errors in embedded critical parallel C programs", ESOP 2011.
class Interference {
public:
  explicit Interference(const Variables& variables);

  /// Records that a process may move a variable, and calls `tell(reader)` for each reader of a view
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

  /// The moves of a variable by any process of the set. The view grows with them.
  [[nodiscard]] View& of(const IdSet& processes, VariableId variable);

private:
  struct PerVariable {
    std::map<ProcessId, Relation> writers;
    std::map<std::size_t, View> views; ///< by number of the set
    /// By move: the views none of whose processes makes it.
    std::map<std::pair<unsigned, unsigned>, std::vector<View*>> without;
  };

  /// The part of a process's moves that is new.
  ValueSet added(ProcessId process, VariableId variable, unsigned from, ValueSet to);
  /// The views that get this move now and did not have it before.
  std::vector<View*> grown(ProcessId process, VariableId variable, unsigned from, unsigned to);

  const Variables& variables;
  std::map<IdSet, std::size_t> known; ///< sets of processes with their numbers
  std::vector<PerVariable> all;
};

} // namespace proskill::analysis::flow
