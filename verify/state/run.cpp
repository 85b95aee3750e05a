#include "verify/state/run.h"

#include "verify/state/evaluate.h"

#include <algorithm>
#include <array>
#include <span>
#include <tuple>

namespace proskill::verify {

namespace {

bool fits(const Cell& cell, std::int64_t value) { return cell.low <= value && value <= cell.high; }

void explain(const Cell& cell, std::int64_t value, StepLog& log) {
  log.failure = "`" + cell.name + "` would get the value " + std::to_string(value) +
                ", outside of " + std::to_string(cell.low) + ".." + std::to_string(cell.high);
}

Outcome failed(const System& system, FaultId fault, StepLog& log) {
  log.failure = system.faults[fault];
  return Outcome::Failed;
}

/// In place of a StepLog, where only the outcome matters.
struct NoLog {
  struct Ignored {
    static void push_back(std::uint32_t) {} // NOLINT(readability-identifier-naming): as of vectors
  };
  Ignored events;
  Ignored origins;
  Ignored leaves;
  std::string_view failure;
};

void explain(const Cell&, std::int64_t, NoLog&) {}
Outcome failed(const System&, FaultId, NoLog&) { return Outcome::Failed; }

/// Ignores a step; a search needs no listener.
struct NoListener {
  static void beginApart() {}
  static void evaluates(NodeId, const Word*, CellId = kNone) {}
  static void writes(CellId) {}
};
struct TellListener {
  StepListener& told;
  void beginApart() const { told.beginApart(); }
  void evaluates(NodeId node, const Word* state, CellId target = kNone) const {
    told.evaluates(node, state, target);
  }
  void writes(CellId cell) const { told.writes(cell); }
};

/// Simultaneous assignments: evaluates all values first.
template <class Log, class Listener>
Outcome assignAll(const System& system, std::span<const Assignment> assignments, Word* state,
                  Log& log, const Listener& listener) {
  constexpr std::size_t kFew = 64;
  std::array<std::int64_t, kFew> few{};
  std::vector<std::int64_t> many(assignments.size() > kFew ? assignments.size() : 0);
  std::int64_t* values = many.empty() ? few.data() : many.data();
  for (std::size_t i = 0; i < assignments.size(); ++i) {
    FaultId fault = kNoFault;
    listener.evaluates(assignments[i].value, state, assignments[i].target);
    values[i] = evaluate(system, assignments[i].value, state, fault);
    if (fault != kNoFault) return failed(system, fault, log);
    if (assignments[i].checked && !fits(system.cells[assignments[i].target], values[i])) {
      explain(system.cells[assignments[i].target], values[i], log);
      return Outcome::Failed;
    }
  }
  for (std::size_t i = 0; i < assignments.size(); ++i) {
    writeCell(system, assignments[i].target, values[i], state);
    listener.writes(assignments[i].target);
  }
  return Outcome::Done;
}

template <class Log, class Listener>
Outcome firePath(const System& system, const Path& path, Word* state, Log& log,
                 const Listener& listener) {
  std::size_t at = 0;
  FaultId fault = kNoFault;
  int turns = 0;
  constexpr int kMostTurns = 100'000;
  while (true) {
    const Instruction& instruction = path.code[at++];
    switch (instruction.kind) {
    case InstructionKind::Assign: {
      std::span all(path.assignments);
      auto outcome =
          assignAll(system, all.subspan(instruction.first, instruction.last - instruction.first),
                    state, log, listener);
      if (outcome != Outcome::Done) return outcome;
      break;
    }
    case InstructionKind::Store:
      for (auto i = instruction.firstStore; i < instruction.lastStore; ++i) {
        const BitStore& store = path.stores[i];
        state[store.word] = (state[store.word] & store.keep) | store.bits;
      }
      for (auto i = instruction.first; i < instruction.last; ++i)
        listener.writes(path.assignments[i].target);
      break;
    case InstructionKind::On:
      listener.evaluates(instruction.node, state);
      if (evaluate(system, instruction.node, state, fault) == 0 && fault == kNoFault)
        return Outcome::GaveUp;
      if (fault != kNoFault) return failed(system, fault, log);
      break;
    case InstructionKind::JumpUnless:
      listener.evaluates(instruction.node, state);
      if (evaluate(system, instruction.node, state, fault) == 0) at = instruction.last;
      if (fault != kNoFault) return failed(system, fault, log);
      break;
    case InstructionKind::Jump:
      if (instruction.last < at && ++turns > kMostTurns) {
        log.failure = "a loop that does not end";
        return Outcome::Failed;
      }
      at = instruction.last;
      break;
    case InstructionKind::Fail:
      listener.evaluates(instruction.node, state);
      std::ignore = evaluate(system, instruction.node, state, fault);
      return failed(system, fault, log);
    case InstructionKind::Tag:
      if (instruction.event != kNone) log.events.push_back(instruction.event);
      break;
    case InstructionKind::Origin: log.origins.push_back(instruction.first); break;
    case InstructionKind::To:
      writeCell(system, system.instances[path.instance].location, instruction.last, state);
      listener.writes(system.instances[path.instance].location);
      if (instruction.event != kNone) log.events.push_back(instruction.event);
      log.leaves.push_back(instruction.leaf);
      return Outcome::Done;
    case InstructionKind::Loop: log.leaves.push_back(instruction.leaf); return Outcome::Done;
    }
  }
}

/// Each part reads the state before the step; their writes are disjoint, and are combined.
template <class Log, class Listener>
Outcome fireApart(const System& system, const Transition& transition, Word* state, Log& log,
                  const Listener& listener) {
  const std::vector<Word> before(state, state + system.words);
  for (auto id : transition.parts) {
    const Path& path = system.paths[id];
    std::vector<Word> own = before;
    listener.beginApart();
    auto outcome = firePath(system, path, own.data(), log, listener);
    if (outcome != Outcome::Done) return outcome;
    path.writes.each(
        [&](CellId cell) { writeCell(system, cell, readCell(system, cell, own.data()), state); });
  }
  return Outcome::Done;
}

template <class Log, class Listener>
Outcome firePaths(const System& system, const Transition& transition, Word* state, Log& log,
                  const Listener& listener) {
  if (transition.apart) return fireApart(system, transition, state, log, listener);
  for (auto part : transition.parts) {
    auto outcome = firePath(system, system.paths[part], state, log, listener);
    if (outcome != Outcome::Done) return outcome;
  }
  return Outcome::Done;
}

/// Whether the observers wait for this step.
bool isSeen(const System& system, const Transition& transition, const Word* before,
            const Word* after, std::span<const EventId> happened) {
  Bits events;
  for (auto event : happened) events.insert(event);
  return std::ranges::all_of(transition.seen, [&](NodeId condition) {
    return holdsAt(system, condition, {before, after, &events});
  });
}

template <class Listener>
Outcome fireTold(const System& system, TransitionId id, Word* state, StepLog& log,
                 const Listener& listener) {
  const Transition& transition = system.transitions[id];
  const auto first = log.events.size();
  log.events.insert(log.events.end(), transition.events.begin(), transition.events.end());
  if (transition.seen.empty()) return firePaths(system, transition, state, log, listener);
  const std::vector<Word> before(state, state + system.words);
  const auto outcome = firePaths(system, transition, state, log, listener);
  if (outcome != Outcome::Done) return outcome;
  const std::span happened = std::span(log.events).subspan(first);
  return isSeen(system, transition, before.data(), state, happened) ? outcome : Outcome::GaveUp;
}

} // namespace

Outcome fire(const System& system, TransitionId id, Word* state, StepLog& log) {
  return fireTold(system, id, state, log, NoListener{});
}

Outcome fire(const System& system, TransitionId id, Word* state) {
  const Transition& transition = system.transitions[id];
  if (transition.seen.empty()) {
    NoLog ignored;
    return firePaths(system, transition, state, ignored, NoListener{});
  }
  StepLog log;
  return fireTold(system, id, state, log, NoListener{});
}

Outcome fire(const System& system, TransitionId id, Word* state, StepLog& log,
             StepListener& listener) {
  return fireTold(system, id, state, log, TellListener{listener});
}

bool isEnabled(const System& system, TransitionId id, const Word* state) {
  const Transition& transition = system.transitions[id];
  for (const auto& test : transition.tests)
    if (((state[test.word] & test.mask) == test.value) != test.equal) return false;
  for (auto node : transition.rest)
    if (!holds(system, node, state)) return false;
  if (!transition.tentative) return true;
  constexpr std::size_t kFew = 64;
  std::array<Word, kFew> few; // NOLINT: what is used is copied
  std::vector<Word> many(system.words > kFew ? system.words : 0);
  Word* const trial = many.empty() ? few.data() : many.data();
  std::copy(state, state + system.words, trial);
  return fire(system, id, trial) != Outcome::GaveUp;
}

bool disturbs(const System& system, TransitionId fired, TransitionId other) {
  return std::ranges::any_of(system.transitions[other].parts, [&](PathId part) {
    return system.transitions[fired].consumed.contains(system.paths[part].instance);
  });
}

} // namespace proskill::verify
