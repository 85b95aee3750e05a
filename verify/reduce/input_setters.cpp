#include "verify/reduce/input_setters.h"

#include "verify/model/nodes.h"
#include "verify/reduce/path_facts.h"
#include "verify/state/evaluate.h"
#include "verify/state/run.h"
#include "verify/state/state_layout.h"

#include <algorithm>
#include <map>

namespace proskill::verify {

namespace {

constexpr std::int64_t kMostInputValues = 64;

/// Cells that may not be open: a goal's condition reads them, a clock depends on them, or a run may
/// end because of them.
Bits closedCells(const System& system, const std::vector<Goal>& goals) {
  Bits closed;
  for (const auto& goal : goals)
    if (goal.kind == GoalKind::Condition) addReads(system, goal.condition, closed);
  for (const auto& transition : system.transitions)
    if (transition.clock != kNone || transition.fails) closed |= transition.guardReads;
  return closed;
}

/// Events of which each occurrence counts.
Bits countedEvents(const System& system, const std::vector<Goal>& goals) {
  Bits counted;
  for (const auto& goal : goals)
    if (goal.ofRuns) addEvents(system, goal.condition, counted);
  return counted;
}

/// Instances with clocks that a step of theirs would restart.
Bits clockedInstances(const System& system) {
  Bits all;
  for (const auto& transition : system.transitions)
    if (transition.clock != kNone)
      for (auto part : transition.parts) all.insert(system.paths[part].instance);
  return all;
}

/// The effect of a transition on each value of the only variable that it changes.
struct Mover {
  TransitionId transition = kNone;
  std::vector<std::optional<std::int64_t>> to; ///< by value, from the cell's lowest on
};

class SetterSearch {
public:
  SetterSearch(const System& of, const std::vector<Goal>& goals, const Bits& without)
      : system(of),
        dropped(without),
        closed(closedCells(of, goals)),
        counted(countedEvents(of, goals)),
        clocked(clockedInstances(of)) {}

  std::vector<FreeInput> run() {
    std::map<CellId, std::vector<Mover>> byCell;
    for (TransitionId i = 0; i < system.transitions.size(); ++i) {
      if (dropped.contains(i) || !isFree(system.transitions[i])) continue;
      const auto cell = onlyCell(system.transitions[i]);
      if (!cell || closed.contains(*cell)) continue;
      if (auto mover = moverOf(i, *cell)) byCell[*cell].push_back(std::move(*mover));
    }
    std::vector<FreeInput> all;
    for (const auto& [cell, movers] : byCell)
      if (auto variable = variableOf(cell, movers)) all.push_back(std::move(*variable));
    return all;
  }

private:
  [[nodiscard]] bool isStored(CellId id) const {
    const Cell& cell = system.cells[id];
    return cell.mask != 0 && cell.word < system.storedWords;
  }

  /// Whether the transition depends on neither time nor locations.
  [[nodiscard]] bool isFree(const Transition& transition) const {
    return !transition.urgent && transition.clock == kNone && !transition.tentative &&
           !transition.fails && !transition.consumed.meets(clocked) &&
           !mayPass(system, transition, counted) &&
           std::ranges::all_of(transition.parts, [&](PathId part) {
             return system.instances[system.paths[part].instance].locations.size() == 1;
           });
  }

  /// The cell that the transition changes, if it is the only one among those that distinguish
  /// states.
  [[nodiscard]] std::optional<CellId> onlyCell(const Transition& transition) const {
    std::optional<CellId> found;
    std::size_t count = 0;
    transition.writes.each([&](CellId cell) {
      if (!isStored(cell)) return;
      found = cell;
      ++count;
    });
    return count == 1 ? found : std::nullopt;
  }

  [[nodiscard]] std::optional<Mover> moverOf(TransitionId id, CellId cell) const {
    const Cell& place = system.cells[cell];
    if (place.high - place.low >= kMostInputValues) return std::nullopt;
    if (auto value = constantOf(system.transitions[id], cell))
      return Mover{id, std::vector(static_cast<std::size_t>(place.high - place.low + 1), value)};
    return readsOnly(system.transitions[id], cell) ? tried(id, cell) : std::nullopt;
  }

  /// The constant that the transition writes to the cell in any state.
  [[nodiscard]] std::optional<std::int64_t> constantOf(const Transition& transition,
                                                       CellId cell) const {
    std::optional<std::int64_t> found;
    for (auto part : transition.parts) {
      const Path& path = system.paths[part];
      const Node& guard = system.nodes[path.guard];
      if (path.mayFail || guard.op != NodeOp::Number || guard.number == 0) return std::nullopt;
      const auto sure = surelyWritten(path);
      for (const auto& assignment : path.assignments) {
        if (assignment.target != cell) continue;
        const Node& value = system.nodes[assignment.value];
        const bool always =
            std::ranges::all_of(sure, [&](const auto& end) { return end.second.contains(cell); });
        if (!always || value.op != NodeOp::Number || assignment.checked) return std::nullopt;
        if (found && *found != value.number) return std::nullopt;
        found = value.number;
      }
    }
    return found;
  }

  /// Whether the effect of the transition depends on the cell alone.
  [[nodiscard]] bool readsOnly(const Transition& transition, CellId cell) const {
    bool only = true;
    const auto look = [&](CellId read) { only = only && (read == cell || !isStored(read)); };
    transition.guardReads.each(look);
    transition.reads.each(look);
    return only;
  }

  [[nodiscard]] std::optional<Mover> tried(TransitionId id, CellId cell) const {
    const Cell& place = system.cells[cell];
    Mover mover{id};
    StepLog log;
    for (std::int64_t value = place.low; value <= place.high; ++value) {
      std::vector<Word> state = initialState(system);
      writeCell(system, cell, value, state.data());
      auto& to = mover.to.emplace_back();
      if (!isEnabled(system, id, state.data())) continue;
      log.clear();
      if (fire(system, id, state.data(), log) != Outcome::Done) return std::nullopt;
      to = readCell(system, cell, state.data());
    }
    return mover;
  }

  /// By value, from the cell's lowest on: the values reached from it.
  using Reached = std::vector<Word>;

  [[nodiscard]] static Reached reachedBy(const std::vector<Mover>& movers, std::int64_t low,
                                         std::size_t values) {
    Reached reached(values);
    for (const auto& mover : movers)
      for (std::size_t i = 0; i < values; ++i)
        if (mover.to[i]) reached[i] |= Word{1} << (*mover.to[i] - low);
    for (std::size_t k = 0; k < values; ++k)
      for (std::size_t i = 0; i < values; ++i)
        if ((reached[i] >> k & 1) != 0) reached[i] |= reached[k];
    return reached;
  }

  /// The largest set of values that all reach each other.
  [[nodiscard]] static Word largestCycle(const Reached& reached) {
    Word best = 0;
    for (std::size_t i = 0; i < reached.size(); ++i) {
      Word own = 0;
      for (std::size_t j = 0; j < reached.size(); ++j)
        if ((reached[i] >> j & 1) != 0 && (reached[j] >> i & 1) != 0) own |= Word{1} << j;
      if (std::popcount(own) > std::popcount(best)) best = own;
    }
    return best;
  }

  [[nodiscard]] std::optional<FreeInput> variableOf(CellId cell, std::vector<Mover> movers) const {
    const std::int64_t low = system.cells[cell].low;
    const auto count = static_cast<std::size_t>(system.cells[cell].high - low + 1);
    while (true) {
      const Word set = largestCycle(reachedBy(movers, low, count));
      if (std::popcount(set) < 2) return std::nullopt;
      const auto left = std::erase_if(movers, [&](const Mover& mover) {
        for (std::size_t i = 0; i < count; ++i)
          if ((set >> i & 1) != 0 && mover.to[i] && (set >> (*mover.to[i] - low) & 1) == 0)
            return true;
        return false;
      });
      if (left == 0) return described(cell, movers, set);
    }
  }

  [[nodiscard]] FreeInput described(CellId cell, const std::vector<Mover>& movers, Word set) const {
    const std::int64_t low = system.cells[cell].low;
    FreeInput made{.cell = cell};
    const auto addValue = [&](std::int64_t value) {
      const bool known = std::ranges::find(made.values, value) != made.values.end();
      if (!known && (set >> (value - low) & 1) != 0) made.values.push_back(value);
    };
    for (const auto& mover : movers) {
      made.setters.push_back(mover.transition);
      for (const auto& to : mover.to)
        if (to) addValue(*to);
    }
    findMoves(made, movers, low);
    return made;
  }

  /// Shortest paths to each value, by breadth-first search backwards.
  static void findMoves(FreeInput& made, const std::vector<Mover>& movers, std::int64_t low) {
    const std::size_t range = movers.front().to.size();
    made.moves.assign(range, std::vector<InputMove>(made.values.size()));
    for (std::size_t goal = 0; goal < made.values.size(); ++goal) {
      std::vector<std::int64_t> todo{made.values[goal]};
      for (std::size_t at = 0; at < todo.size(); ++at)
        for (const auto& mover : movers)
          for (std::size_t from = 0; from < range; ++from) {
            InputMove& move = made.moves[from][goal];
            const std::int64_t value = low + static_cast<std::int64_t>(from);
            const bool known = move.setter != kNone || value == made.values[goal];
            if (known || mover.to[from] != todo[at]) continue;
            move = {mover.transition, todo[at]};
            todo.push_back(value);
          }
    }
  }

  const System& system;
  const Bits& dropped;
  Bits closed;  ///< cells
  Bits counted; ///< events
  Bits clocked; ///< instances
};

} // namespace

std::vector<FreeInput> findFreeInputs(const System& system, const std::vector<Goal>& goals,
                                      const Bits& dropped) {
  return SetterSearch(system, goals, dropped).run();
}

} // namespace proskill::verify
