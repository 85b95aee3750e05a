#include "verify/reduce/private_moves.h"

#include "verify/model/nodes.h"
#include "verify/reduce/path_facts.h"
#include "verify/state/state_layout.h"

#include <algorithm>

namespace proskill::verify {

namespace {

/// Limit of tested combinations of values of one process's inputs.
constexpr std::size_t kMostPrivateChoices = 256;

using Transitions = std::vector<TransitionId>;

/// Finds the private moves of one system.
class Finder {
public:
  Finder(const System& of, const std::vector<Goal>& goals, const Bits& without,
         const FreeInputs& with)
      : system(of), dropped(without), inputs(with), readers(of.cells.size()) {
    for (const auto& goal : goals) {
      if (goal.kind != GoalKind::Condition) continue;
      addReads(system, goal.condition, visibleCells);
      addEvents(system, goal.condition, visibleEvents);
    }
    for (const auto& instance : system.instances) at.emplace_back(instance.locations.size());
    for (TransitionId i = 0; i < system.transitions.size(); ++i) {
      if (dropped.contains(i)) continue;
      const auto& transition = system.transitions[i];
      Bits read = transition.reads;
      read |= transition.guardReads;
      read.each([&](CellId cell) { readers[cell].push_back(i); });
      for (auto part : transition.parts) {
        const Path& path = system.paths[part];
        at[path.instance][path.location].push_back(i);
      }
    }
  }

  /// The inputs that only this instance reads.
  [[nodiscard]] std::vector<std::uint32_t> inputsOf(InstanceId instance) const {
    std::vector<std::uint32_t> own;
    for (std::uint32_t v = 0; v < inputs.all().size(); ++v) {
      const auto isOwn = [&](TransitionId i) {
        return isOf(instance, i) || inputs.isSetter(i); // a setter reads its own variable at most
      };
      const auto& all = readers[inputs.all()[v].cell];
      if (std::ranges::all_of(all, isOwn) &&
          std::ranges::any_of(all, [&](TransitionId i) { return isOf(instance, i); }))
        own.push_back(v);
    }
    return own;
  }

  /// The private move of the instance, by location.
  [[nodiscard]] Transitions movesOf(InstanceId instance,
                                    const std::vector<std::uint32_t>& own) const {
    Transitions moves(system.instances[instance].locations.size(), kNone);
    if (isSeenByOthers(instance)) return moves;
    Bits rests; // targets of moves, to exclude endless cycles
    for (bool changed = true; changed;) {
      changed = false;
      for (std::uint32_t from = 0; from < moves.size(); ++from) {
        const Transitions& all = at[instance][from];
        if (moves[from] != kNone || rests.contains(from) || all.size() != 1) continue;
        const auto target = privateTarget(instance, all[0], own);
        if (!target || *target == from) continue;
        if (moves[*target] == kNone) {
          if (!mayStay(instance, *target, own)) continue;
          rests.insert(*target);
        }
        moves[from] = all[0];
        changed = true;
      }
    }
    return moves;
  }

private:
  [[nodiscard]] bool isOf(InstanceId instance, TransitionId id) const {
    const auto& parts = system.transitions[id].parts;
    return parts.size() == 1 && system.paths[parts[0]].instance == instance;
  }

  /// Whether a step without the instance depends on its location.
  [[nodiscard]] bool isSeenByOthers(InstanceId instance) const {
    const CellId location = system.instances[instance].location;
    const auto takesPart = [&](TransitionId id) {
      return std::ranges::any_of(system.transitions[id].parts, [&](PathId part) {
        return system.paths[part].instance == instance;
      });
    };
    return visibleCells.contains(location) || !std::ranges::all_of(readers[location], takesPart);
  }

  /// The target of the step, if nobody observes it and only inputs determine whether it is
  /// possible.
  [[nodiscard]] std::optional<std::uint32_t>
  privateTarget(InstanceId instance, TransitionId id, const std::vector<std::uint32_t>& own) const {
    const Transition& move = system.transitions[id];
    if (move.clock != kNone || move.tentative || move.fails || !isOf(instance, id)) return {};
    const Path& path = system.paths[move.parts[0]];
    if (path.mayFail || mayPass(system, move, visibleEvents)) return {};
    if (!onlyMoves(instance, move)) return {};
    if (!isPossible(instance, path.location, own, {id}, PartialTruth::True)) return {};
    return targetOf(path);
  }

  /// Whether the step moves its process and changes nothing else that distinguishes states.
  [[nodiscard]] bool onlyMoves(InstanceId instance, const Transition& move) const {
    bool only = true;
    move.writes.each([&](CellId cell) {
      const Cell& written = system.cells[cell];
      const bool isStored = written.mask != 0 && written.word < system.storedWords;
      if (isStored && cell != system.instances[instance].location) only = false;
      if (visibleCells.contains(cell)) only = false;
    });
    return only;
  }

  /// The target of the path, if there is only one.
  [[nodiscard]] static std::optional<std::uint32_t> targetOf(const Path& path) {
    std::optional<std::uint32_t> target;
    for (const auto& instruction : path.code) {
      if (instruction.kind == InstructionKind::Loop) return std::nullopt;
      if (instruction.kind != InstructionKind::To) continue;
      if (target && *target != instruction.last) return std::nullopt;
      target = instruction.last;
    }
    return target;
  }

  /// Whether for some values of the inputs the instance can take no step there, whatever the rest
  /// of the state is.
  [[nodiscard]] bool mayStay(InstanceId instance, std::uint32_t location,
                             const std::vector<std::uint32_t>& own) const {
    const Transitions& all = at[instance][location];
    return std::ranges::none_of(all,
                                [&](TransitionId i) {
                                  return system.transitions[i].clock != kNone ||
                                         system.transitions[i].fails;
                                }) &&
           isPossible(instance, location, own, all, PartialTruth::False);
  }

  /// Whether for some values of the inputs this is known for all these transitions, whatever the
  /// rest of the state is.
  [[nodiscard]] bool isPossible(InstanceId instance, std::uint32_t location,
                                const std::vector<std::uint32_t>& own, const Transitions& all,
                                PartialTruth wanted) const {
    std::size_t choices = 1;
    for (auto v : own) choices *= inputs.all()[v].values.size();
    if (choices > kMostPrivateChoices) return false;
    std::vector<Word> state = initialState(system);
    std::vector<Word> unknown(system.words, ~Word{0});
    const auto know = [&](CellId id) { unknown[system.cells[id].word] &= ~system.cells[id].mask; };
    const CellId place = system.instances[instance].location;
    writeCell(system, place, location, state.data());
    know(place);
    for (auto v : own) know(inputs.all()[v].cell);
    for (std::size_t choice = 0; choice < choices; ++choice) {
      std::size_t rest = choice;
      for (auto v : own) {
        const std::size_t count = inputs.all()[v].values.size();
        inputs.set(v, static_cast<std::uint32_t>(rest % count), state.data());
        rest /= count;
      }
      BitField undecided;
      if (std::ranges::all_of(all, [&](TransitionId id) {
            return inputs.truth(id, state.data(), unknown, undecided) == wanted;
          }))
        return true;
    }
    return false;
  }

  const System& system;
  const Bits& dropped;
  const FreeInputs& inputs;
  std::vector<Transitions> readers;         ///< by cell: transitions whose guard or code reads it
  std::vector<std::vector<Transitions>> at; ///< by instance and location
  Bits visibleCells;
  Bits visibleEvents;
};

} // namespace

PrivateMoves::PrivateMoves(const System& of, const std::vector<Goal>& goals, const Bits& dropped,
                           const FreeInputs& with)
    : system(of), inputs(with) {
  const Finder finder(system, goals, dropped, inputs);
  for (InstanceId i = 0; i < system.instances.size(); ++i) {
    Mover mover{system.instances[i].location, {}, finder.inputsOf(i)};
    if (mover.inputs.empty()) continue;
    mover.moves = finder.movesOf(i, mover.inputs);
    const bool any = std::ranges::any_of(mover.moves, [](auto id) { return id != kNone; });
    if (any) movers.push_back(std::move(mover));
  }
}

TransitionId PrivateMoves::pick(const Word* state) const {
  for (const auto& mover : movers) {
    const auto at = static_cast<std::size_t>(readCell(system, mover.location, state));
    const bool isOpen = std::ranges::all_of(
        mover.inputs, [&](std::uint32_t v) { return inputs.valueOf(v, state).has_value(); });
    if (mover.moves[at] != kNone && isOpen) return mover.moves[at];
  }
  return kNone;
}

} // namespace proskill::verify
