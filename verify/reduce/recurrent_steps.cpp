#include "verify/reduce/recurrent_steps.h"

#include "graph/components.h"
#include "verify/reduce/path_facts.h"
#include "verify/state/partial_evaluation.h"
#include "verify/state/state_layout.h"

#include <algorithm>
#include <map>

namespace proskill::verify {

namespace {

constexpr std::int64_t kMostBits = 64;

/// Values of a cell, as bits from its lowest on.
using Values = Word;

class RecurrenceSearch {
public:
  RecurrenceSearch(const System& of, const Bits& dropped)
      : system(of), evaluation(of), left((of.transitions.size() + 63) / 64), kept(left) {
    for (const auto& instance : system.instances) locations.insert(instance.location);
    for (TransitionId i = 0; i < system.transitions.size(); ++i) {
      if (dropped.contains(i)) continue;
      const auto& transition = system.transitions[i];
      if (mayBeStuck(transition)) insert(kept, i);
      if (transition.urgent || mayBeStuck(transition)) insert(left, i);
    }
  }

  TransitionSet run() {
    left = onCycles(left);
    while (takeAway()) {
    }
    for (std::size_t k = 0; k < left.size(); ++k) left[k] |= kept[k];
    return left;
  }

private:
  [[nodiscard]] bool mayBeStuck(const Transition& transition) const {
    return system.hasPriorities || transition.tentative ||
           std::ranges::any_of(transition.parts,
                               [&](PathId part) { return system.paths[part].mayFail; });
  }

  /// One round over all variables that some of those left read. \return something was taken away
  bool takeAway() {
    const TransitionSet before = left;
    Bits read;
    eachIn(left, [&](TransitionId id) { read |= system.transitions[id].guardReads; });
    read.each([&](CellId cell) {
      const Cell& place = system.cells[cell];
      if (locations.contains(cell) || place.mask == 0 || place.high - place.low >= kMostBits)
        return;
      left = recurringWith(cell);
    });
    return left != before;
  }

  /// Either the cell is written again and again, or it keeps one of its values.
  TransitionSet recurringWith(CellId cell) {
    const auto count = system.cells[cell].high - system.cells[cell].low + 1;
    Values all = count == kMostBits ? ~Values{0} : (Values{1} << count) - 1;
    Values written = 0;
    eachIn(left, [&](TransitionId id) { written |= writtenBy(id, cell, all); });
    TransitionSet found(left.size());
    const auto join = [&](Values values, bool constant) {
      TransitionSet some = left;
      eachIn(left, [&](TransitionId id) {
        const bool changes =
            constant && surelyWrites(id, cell) && (writtenBy(id, cell, all) & values) == 0;
        if (changes || (allowedBy(id, cell) & values) == 0) erase(some, id);
      });
      some = onCycles(some);
      for (std::size_t k = 0; k < some.size(); ++k) found[k] |= some[k];
    };
    if (written != 0) join(written, false);
    for (std::int64_t value = 0; value < count; ++value) join(Values{1} << value, true);
    return found;
  }

  /// The values that the transition may write into the cell.
  [[nodiscard]] Values writtenBy(TransitionId id, CellId cell, Values all) const {
    Values values = 0;
    if (!system.transitions[id].writes.contains(cell)) return values;
    for (auto part : system.transitions[id].parts)
      for (const auto& assignment : system.paths[part].assignments) {
        if (assignment.target != cell) continue;
        const Node& value = system.nodes[assignment.value];
        const auto at = value.number - system.cells[cell].low;
        if (value.op != NodeOp::Number || at < 0 || at >= kMostBits) return all;
        values |= Values{1} << at;
      }
    return values == 0 ? all : values;
  }

  [[nodiscard]] bool surelyWrites(TransitionId id, CellId cell) {
    return std::ranges::any_of(system.transitions[id].parts, [&](PathId part) {
      const Path& path = system.paths[part];
      if (!path.writes.contains(cell)) return false;
      const auto [entry, isNew] = sure.try_emplace(part);
      if (isNew) entry->second = surelyWritten(path, path.writes);
      return std::ranges::all_of(entry->second,
                                 [&](const auto& end) { return end.second.contains(cell); });
    });
  }

  /// The values of the cell with which the transition's guard may hold.
  [[nodiscard]] Values allowedBy(TransitionId id, CellId cell) {
    const auto [entry, isNew] = allowed.try_emplace({id, cell}, ~Values{0});
    if (!isNew || !system.transitions[id].guardReads.contains(cell)) return entry->second;
    const Cell& place = system.cells[cell];
    std::vector<Word> unknown(system.words, ~Word{0});
    std::vector<Word> state = initialState(system);
    unknown[place.word] &= ~place.mask;
    for (std::int64_t value = place.low; value <= place.high; ++value) {
      writeCell(system, cell, value, state.data());
      BitField undecided;
      const auto truth = evaluation.guard(system, system.transitions[id],
                                          {state.data(), unknown.data()}, undecided);
      if (truth == PartialTruth::False) entry->second &= ~(Values{1} << (value - place.low));
    }
    return entry->second;
  }

  // --- Locations

  struct Move {
    TransitionId transition = 0;
    std::uint32_t from = 0;
    std::vector<std::uint32_t> to;
  };

  /// Those whose parts all lie on cycles made of the rest.
  [[nodiscard]] TransitionSet onCycles(TransitionSet some) const {
    for (bool again = true; again;) {
      again = false;
      std::vector<std::vector<Move>> moves(system.instances.size());
      eachIn(some, [&](TransitionId id) {
        for (auto part : system.transitions[id].parts)
          moves[system.paths[part].instance].push_back(moveBy(id, system.paths[part]));
      });
      for (InstanceId i = 0; i < moves.size(); ++i)
        for (auto id : offCycles(moves[i], system.instances[i].locations.size())) {
          erase(some, id);
          again = true;
        }
    }
    return some;
  }

  [[nodiscard]] static Move moveBy(TransitionId id, const Path& path) {
    Move move{id, path.location, {}};
    for (const auto& instruction : path.code) {
      if (instruction.kind == InstructionKind::To) move.to.push_back(instruction.last);
      if (instruction.kind == InstructionKind::Loop) move.to.push_back(path.location);
    }
    return move;
  }

  [[nodiscard]] static std::vector<TransitionId> offCycles(const std::vector<Move>& moves,
                                                           std::size_t count) {
    std::vector<TransitionId> off;
    if (moves.empty()) return off;
    std::vector<std::vector<graph::Node>> next(count);
    for (const auto& move : moves)
      for (auto to : move.to) next[move.from].push_back(to);
    const auto component = graph::componentsOf(count, [&](graph::Node node, std::size_t i) {
      return i < next[node].size() ? next[node][i] : graph::kNoNode;
    });
    for (const auto& move : moves) {
      const auto stays = [&](std::uint32_t to) { return component[to] == component[move.from]; };
      if (std::ranges::none_of(move.to, stays)) off.push_back(move.transition);
    }
    return off;
  }

  const System& system;
  PartialEvaluation evaluation;
  TransitionSet left;
  TransitionSet kept; ///< whether they can happen is known only when they do
  Bits locations;     ///< cells
  std::map<PathId, std::map<std::uint32_t, Bits>> sure;
  std::map<std::pair<TransitionId, CellId>, Values> allowed;
};

} // namespace

TransitionSet recurrentSteps(const System& system, const Bits& dropped) {
  return RecurrenceSearch(system, dropped).run();
}

} // namespace proskill::verify
