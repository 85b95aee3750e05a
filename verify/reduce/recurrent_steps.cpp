#include "verify/reduce/recurrent_steps.h"

#include "graph/components.h"
#include "verify/reduce/path_facts.h"
#include "verify/state/evaluate.h"
#include "verify/state/partial_evaluation.h"

#include <algorithm>
#include <map>

namespace proskill::verify {

namespace {

constexpr std::int64_t kMostBits = 64;

/// Values of a cell, as bits from its lowest on.
using Values = Word;

class RecurrenceSearch {
public:
  RecurrenceSearch(const System& of, const Bits& dropped, LimitWatch& watch)
      : system(of),
        limits(watch),
        evaluation(of),
        left((of.transitions.size() + 63) / 64),
        kept(left),
        anywhere(of.words),
        unknown(of.words, ~Word{0}) {
    for (const auto& instance : system.instances) locations.insert(instance.location);
    for (TransitionId i = 0; i < system.transitions.size(); ++i) {
      if (dropped.contains(i)) continue;
      const auto& transition = system.transitions[i];
      if (mayBeStuck(transition)) insert(kept, i);
      if (transition.urgent || mayBeStuck(transition)) insert(left, i);
    }
    findUses();
  }

  TransitionSet run() {
    Bits all;
    for (InstanceId i = 0; i < system.instances.size(); ++i) all.insert(i);
    left = onCycles(left, all);
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

  /// Which of those left have to do with which cells and instances.
  void findUses() {
    readers.resize(system.cells.size());
    writers.resize(system.cells.size());
    movers.resize(system.instances.size());
    eachIn(left, [&](TransitionId id) {
      const auto& transition = system.transitions[id];
      transition.guardReads.each([&](CellId cell) { readers[cell].push_back(id); });
      transition.writes.each([&](CellId cell) { writers[cell].push_back(id); });
      for (auto part : transition.parts)
        movers[system.paths[part].instance].push_back(moveBy(id, system.paths[part]));
    });
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

  /// Either the cell is written again and again, or it keeps one of its values. Those left before
  /// lie on cycles, so only where some are taken away others may lose theirs.
  TransitionSet recurringWith(CellId cell) {
    limits.check();
    const auto count = system.cells[cell].high - system.cells[cell].low + 1;
    Values all = count == kMostBits ? ~Values{0} : (Values{1} << count) - 1;
    Values written = 0;
    for (auto id : writers[cell])
      if (contains(left, id)) written |= writtenBy(id, cell, all);
    TransitionSet found(left.size());
    bool keepsAll = false;
    const auto join = [&](Values values, bool constant) {
      if (keepsAll) return;
      TransitionSet some = left;
      Bits touched;
      const auto takeOut = [&](TransitionId id) {
        erase(some, id);
        for (auto part : system.transitions[id].parts) touched.insert(system.paths[part].instance);
      };
      for (auto id : readers[cell])
        if (contains(left, id) && (allowedBy(id, cell) & values) == 0) takeOut(id);
      if (constant)
        for (auto id : writers[cell])
          if (contains(some, id) && (writtenBy(id, cell, all) & values) == 0 &&
              surelyWrites(id, cell))
            takeOut(id);
      keepsAll = touched.empty();
      some = onCycles(std::move(some), touched);
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
    limits.check();
    unknown[place.word] &= ~place.mask;
    for (std::int64_t value = place.low; value <= place.high; ++value) {
      writeCell(system, cell, value, anywhere.data());
      BitField undecided;
      const auto truth = evaluation.guard(system, system.transitions[id],
                                          {anywhere.data(), unknown.data()}, undecided);
      if (truth == PartialTruth::False) entry->second &= ~(Values{1} << (value - place.low));
    }
    unknown[place.word] |= place.mask;
    return entry->second;
  }

  // --- Locations

  struct Move {
    TransitionId transition = 0;
    std::uint32_t from = 0;
    std::vector<std::uint32_t> to;
  };

  /// Those whose parts all lie on cycles made of the rest.
  /// \param touched instances that may have lost cycles
  [[nodiscard]] TransitionSet onCycles(TransitionSet some, Bits touched) const {
    while (!touched.empty()) {
      Bits next;
      touched.each([&](InstanceId instance) {
        limits.check();
        for (auto id : offCycles(instance, some)) {
          erase(some, id);
          for (auto part : system.transitions[id].parts) next.insert(system.paths[part].instance);
        }
      });
      touched = std::move(next);
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

  [[nodiscard]] std::vector<TransitionId> offCycles(InstanceId instance,
                                                    const TransitionSet& some) const {
    std::vector<TransitionId> off;
    std::vector<Move> moves;
    std::ranges::copy_if(movers[instance], std::back_inserter(moves),
                         [&](const Move& move) { return contains(some, move.transition); });
    if (moves.empty()) return off;
    const std::size_t count = system.instances[instance].locations.size();
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
  LimitWatch& limits;
  PartialEvaluation evaluation;
  TransitionSet left;
  TransitionSet kept; ///< whether they can happen is known only when they do
  Bits locations;     ///< cells
  std::vector<std::vector<TransitionId>> readers; ///< by cell: guards
  std::vector<std::vector<TransitionId>> writers; ///< by cell
  std::vector<std::vector<Move>> movers;          ///< by instance
  std::vector<Word> anywhere;                     ///< a state of which one cell is looked at
  std::vector<Word> unknown;                      ///< the bits of the others
  std::map<PathId, std::map<std::uint32_t, Bits>> sure;
  std::map<std::pair<TransitionId, CellId>, Values> allowed;
};

} // namespace

TransitionSet recurrentSteps(const System& system, const Bits& dropped, LimitWatch& limits) {
  return RecurrenceSearch(system, dropped, limits).run();
}

} // namespace proskill::verify
