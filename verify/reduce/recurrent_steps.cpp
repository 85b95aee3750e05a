#include "verify/reduce/recurrent_steps.h"

#include "graph/components.h"
#include "verify/model/nodes.h"
#include "verify/reduce/path_facts.h"
#include "verify/state/evaluate.h"
#include "verify/state/partial_evaluation.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

namespace proskill::verify {

namespace {

constexpr std::size_t kMostKinds = 64;
constexpr std::int64_t kMostValues = 4096;

/// Values of a cell: a bit for each kind.
using Values = Word;

/// A transition whose guard limits the values of a cell.
struct Reader {
  TransitionId transition = 0;
  Values allowed = 0; ///< the values with which the guard may be true
};

/// A part of a transition's guard that reads a cell.
struct GuardPart {
  TransitionId transition = 0;
  NodeId condition = kNone; ///< kNone: the guard's bit tests
};

/// The values of a cell, in kinds with the same writers and readers.
struct Kinds {
  std::vector<std::size_t> of; ///< by value, from the cell's lowest on
  std::size_t count = 0;
  std::vector<Reader> readers; ///< whose guards are false for some values

  [[nodiscard]] Values all() const {
    return count == kMostKinds ? ~Values{0} : (Values{1} << count) - 1;
  }
};

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

  /// Finds the remaining transitions that use each cell and instance.
  void findUses() {
    guardParts.resize(system.cells.size());
    writers.resize(system.cells.size());
    movers.resize(system.instances.size());
    eachIn(left, [&](TransitionId id) {
      const auto& transition = system.transitions[id];
      findGuardParts(id);
      transition.writes.each([&](CellId cell) { writers[cell].push_back(id); });
      for (auto part : transition.parts)
        movers[system.paths[part].instance].push_back(moveBy(id, system.paths[part]));
    });
  }

  void findGuardParts(TransitionId id) {
    const auto& transition = system.transitions[id];
    std::vector<Word> tested(system.words);
    for (const auto& test : transition.tests) tested[test.word] |= test.mask;
    transition.guardReads.each([&](CellId cell) {
      if ((tested[system.cells[cell].word] & system.cells[cell].mask) != 0)
        guardParts[cell].push_back({id});
    });
    for (auto node : transition.rest) {
      const auto [entry, isNew] = readBy.try_emplace(node);
      if (isNew) addReads(system, node, entry->second);
      entry->second.each([&](CellId cell) { guardParts[cell].push_back({id, node}); });
    }
  }

  /// A round over all variables that remaining transitions read. \return whether a transition was
  /// removed
  bool takeAway() {
    const TransitionSet before = left;
    Bits read;
    eachIn(left, [&](TransitionId id) { read |= system.transitions[id].guardReads; });
    read.each([&](CellId cell) {
      if (locations.contains(cell) || system.cells[cell].mask == 0) return;
      if (const Kinds& kinds = kindsOf(cell); kinds.count > 0) left = recurringWith(cell, kinds);
    });
    return left != before;
  }

  /// Either the cell is written infinitely often, or it keeps one of its values. The remaining
  /// transitions are on cycles, so removing some affects only those on their cycles.
  TransitionSet recurringWith(CellId cell, const Kinds& kinds) {
    limits.check();
    Values written = 0;
    for (auto id : writers[cell])
      if (contains(left, id)) written |= writtenBy(id, cell, kinds);
    TransitionSet found(left.size());
    bool keepsAll = false;
    const auto join = [&](Values values, bool constant) {
      if (keepsAll) return;
      TransitionSet some = left;
      Ends impossible;
      Bits touched;
      const auto touch = [&](TransitionId id) {
        for (auto part : system.transitions[id].parts) touched.insert(system.paths[part].instance);
      };
      const auto takeOut = [&](TransitionId id) {
        erase(some, id);
        touch(id);
      };
      for (const auto& reader : kinds.readers)
        if (contains(left, reader.transition) && (reader.allowed & values) == 0)
          takeOut(reader.transition);
      if (constant)
        for (auto id : writers[cell]) {
          if (!contains(some, id) || (writtenBy(id, cell, kinds) & values) != 0) continue;
          const auto ends = endsThatWrite(id, cell);
          if (ends.empty()) continue;
          impossible.insert(ends.begin(), ends.end());
          touch(id);
        }
      keepsAll = touched.empty();
      some = onCycles(std::move(some), touched, impossible);
      for (std::size_t k = 0; k < some.size(); ++k) found[k] |= some[k];
    };
    if (written != 0) join(written, false);
    for (std::size_t kind = 0; kind < kinds.count; ++kind) join(Values{1} << kind, true);
    return found;
  }

  /// The values that the transition may write to the cell.
  [[nodiscard]] Values writtenBy(TransitionId id, CellId cell, const Kinds& kinds) const {
    Values values = 0;
    bool isAny = false;
    eachWritten(id, cell, [&](std::optional<std::size_t> value) {
      if (value)
        values |= Values{1} << kinds.of[*value];
      else
        isAny = true;
    });
    return isAny ? kinds.all() : values;
  }

  /// Visits the values that the transition may write to the cell, from its lowest on; nullopt means
  /// any.
  template <class Visit> void eachWritten(TransitionId id, CellId cell, Visit visit) const {
    if (!system.transitions[id].writes.contains(cell)) return;
    const Cell& place = system.cells[cell];
    bool isSeen = false;
    for (auto part : system.transitions[id].parts)
      for (const auto& assignment : system.paths[part].assignments) {
        if (assignment.target != cell) continue;
        isSeen = true;
        const Node& value = system.nodes[assignment.value];
        const bool isKnown =
            value.op == NodeOp::Number && value.number >= place.low && value.number <= place.high;
        visit(isKnown ? std::optional(static_cast<std::size_t>(value.number - place.low))
                      : std::nullopt);
      }
    if (!isSeen) visit(std::nullopt);
  }

  const Kinds& kindsOf(CellId cell) {
    const auto [entry, isNew] = kindsOfCell.try_emplace(cell);
    Kinds& made = entry->second;
    const Cell& place = system.cells[cell];
    if (!isNew || place.high - place.low >= kMostValues) return made;
    const auto count = static_cast<std::size_t>(place.high - place.low + 1);
    const Guards guards = guardsReading(cell);
    std::vector<std::vector<bool>> traits(count);
    for (const auto& [allows, transitions] : guards)
      for (std::size_t value = 0; value < count; ++value) traits[value].push_back(allows[value]);
    Bits constants;
    for (auto id : writers[cell])
      eachWritten(id, cell, [&](std::optional<std::size_t> value) {
        if (value) constants.insert(static_cast<std::uint32_t>(*value));
      });
    constants.each([&](std::uint32_t constant) {
      for (std::size_t value = 0; value < count; ++value)
        traits[value].push_back(value == constant);
    });
    std::map<std::vector<bool>, std::size_t> kinds;
    for (const auto& one : traits)
      made.of.push_back(kinds.try_emplace(one, kinds.size()).first->second);
    if (kinds.size() > kMostKinds) return made;
    made.count = kinds.size();
    for (const auto& [allows, transitions] : guards) {
      Values allowed = 0;
      for (std::size_t value = 0; value < count; ++value)
        if (allows[value]) allowed |= Values{1} << made.of[value];
      if (allowed == made.all()) continue;
      for (auto id : transitions) made.readers.push_back({id, allowed});
    }
    return made;
  }

  /// A transition and a location in which it leaves one of its instances.
  using End = std::tuple<TransitionId, InstanceId, std::uint32_t>;
  using Ends = std::set<End>;

  /// The ends of the transition before which it surely writes the cell.
  [[nodiscard]] std::vector<End> endsThatWrite(TransitionId id, CellId cell) {
    std::vector<End> ends;
    for (auto part : system.transitions[id].parts) {
      const Path& path = system.paths[part];
      if (!path.writes.contains(cell)) continue;
      const auto [entry, isNew] = sure.try_emplace(part);
      if (isNew) entry->second = surelyWritten(path);
      for (const auto& [to, cells] : entry->second)
        if (cells.contains(cell)) ends.emplace_back(id, path.instance, to);
    }
    return ends;
  }

  /// By value of a cell: whether something may be true.
  using Allows = std::vector<bool>;
  /// Transitions, by what their guards allow.
  using Guards = std::map<Allows, std::vector<TransitionId>>;

  /// What the guards that read the cell allow. Only the parts that read it are evaluated, since
  /// large programs have many guards of many parts.
  [[nodiscard]] Guards guardsReading(CellId cell) {
    Guards guards;
    std::map<NodeId, Allows> conditions;
    const auto& parts = guardParts[cell];
    for (auto part = parts.begin(); part != parts.end();) {
      limits.check();
      const TransitionId id = part->transition;
      Allows allows;
      for (; part != parts.end() && part->transition == id; ++part)
        restrict(allows, part->condition == kNone ? allowedByTests(id, cell)
                                                  : allowedBy(part->condition, cell, conditions));
      guards[std::move(allows)].push_back(id);
    }
    return guards;
  }

  /// \param allows empty: all values
  static void restrict(Allows& allows, const Allows& more) {
    if (allows.empty()) {
      allows = more;
      return;
    }
    for (std::size_t value = 0; value < allows.size(); ++value)
      allows[value] = allows[value] && more[value];
  }

  [[nodiscard]] Allows allowedByTests(TransitionId id, CellId cell) {
    return forEachValue(cell, [&](const PartialState& at, BitField& undecided) {
      return evaluation.tests(system, system.transitions[id], at, undecided);
    });
  }

  /// \param known the conditions that were evaluated before
  [[nodiscard]] const Allows& allowedBy(NodeId node, CellId cell, std::map<NodeId, Allows>& known) {
    const auto [entry, isNew] = known.try_emplace(node);
    if (isNew)
      entry->second = forEachValue(cell, [&](const PartialState& at, BitField& undecided) {
        return evaluation.condition(system, node, at, undecided);
      });
    return entry->second;
  }

  /// Whether `truth` may be true in the states in which only this cell is known.
  template <class Truth> [[nodiscard]] Allows forEachValue(CellId cell, Truth truth) {
    const Cell& place = system.cells[cell];
    Allows allows;
    unknown[place.word] &= ~place.mask;
    for (std::int64_t value = place.low; value <= place.high; ++value) {
      writeCell(system, cell, value, anywhere.data());
      BitField undecided;
      const PartialState at{anywhere.data(), unknown.data()};
      allows.push_back(truth(at, undecided) != PartialTruth::False);
    }
    unknown[place.word] |= place.mask;
    return allows;
  }

  // --- Locations

  struct Move {
    TransitionId transition = 0;
    std::uint32_t from = 0;
    std::vector<std::uint32_t> to;
  };

  /// The transitions whose parts are all on cycles of the rest.
  /// \param touched instances that may have lost cycles
  /// \param impossible ends that are never reached
  [[nodiscard]] TransitionSet onCycles(TransitionSet some, Bits touched,
                                       const Ends& impossible = {}) const {
    while (!touched.empty()) {
      Bits next;
      touched.each([&](InstanceId instance) {
        limits.check();
        for (auto id : offCycles(instance, some, impossible)) {
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

  [[nodiscard]] std::vector<TransitionId> offCycles(InstanceId instance, const TransitionSet& some,
                                                    const Ends& impossible) const {
    std::vector<TransitionId> off;
    std::vector<Move> moves;
    for (const auto& move : movers[instance]) {
      if (!contains(some, move.transition)) continue;
      std::erase_if(moves.emplace_back(move).to, [&](std::uint32_t to) {
        return impossible.contains({move.transition, instance, to});
      });
    }
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
  TransitionSet kept;            ///< whether they are possible is known only when they are taken
  Bits locations;                ///< cells
  std::map<NodeId, Bits> readBy; ///< the cells that a condition reads
  std::vector<std::vector<GuardPart>> guardParts; ///< by cell, in the order of transitions
  std::vector<std::vector<TransitionId>> writers; ///< by cell
  std::vector<std::vector<Move>> movers;          ///< by instance
  std::vector<Word> anywhere;                     ///< a state of which only one cell is read
  std::vector<Word> unknown;                      ///< the bits of the other cells
  std::map<CellId, Kinds> kindsOfCell;
  std::map<PathId, std::map<std::uint32_t, Bits>> sure;
};

} // namespace

TransitionSet recurrentSteps(const System& system, const Bits& dropped, LimitWatch& limits) {
  return RecurrenceSearch(system, dropped, limits).run();
}

} // namespace proskill::verify
