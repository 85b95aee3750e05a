#include "verify/refine/split_tests.h"

#include "verify/model/nodes.h"
#include "verify/model/path_summary.h"
#include "verify/model/step_copies.h"
#include "verify/model/value_bounds.h"

#include <algorithm>
#include <optional>

namespace proskill::verify {

namespace {

constexpr std::size_t kMostWays = 8;   ///< through the code of one path
constexpr std::size_t kMostTests = 64; ///< that are followed, on all ways together

/// Lists the ways through the code of a path, each as a path without tests.
class Ways {
public:
  Ways(Nodes& with, const System& of, const Path& whole) : nodes(with), system(of), path(whole) {}

  /// Nothing if a test cannot become a condition, or if there are too many ways.
  std::optional<std::vector<Path>> all() {
    Path start = path;
    for (auto* cells : {&start.guardReads, &start.reads, &start.writes}) *cells = {};
    start.code.clear();
    start.assignments.clear();
    start.tentative = false;
    follow(0, std::move(start));
    if (isHopeless) return std::nullopt;
    return std::move(found);
  }

private:
  void follow(std::size_t at, Path way) {
    while (!isHopeless) {
      if (at >= path.code.size()) return giveUp();
      const auto& next = path.code[at++];
      switch (next.kind) {
      case InstructionKind::Assign: copy(next, way); break;
      case InstructionKind::Tag:
      case InstructionKind::Origin: way.code.push_back(next); break;
      case InstructionKind::On:
        if (mayHaveFailed(way)) return giveUp(); // an error comes before the test
        if (!require(next.node, way)) return;
        break;
      case InstructionKind::JumpUnless:
        if (next.last < at || ++tests > kMostTests) return giveUp(); // a loop, or too many
        followUnless(next, way);
        if (!require(next.node, way)) return;
        break;
      case InstructionKind::Jump:
        if (next.last < at) return giveUp();
        at = next.last;
        break;
      case InstructionKind::To: copy(next, way); return end(std::move(way));
      case InstructionKind::Loop: way.code.push_back(next); return end(std::move(way));
      case InstructionKind::Store:
      case InstructionKind::Fail: return giveUp();
      }
    }
  }

  void followUnless(const Instruction& test, Path otherwise) {
    if (require(nodes.negation(test.node), otherwise)) follow(test.last, std::move(otherwise));
  }

  /// Adds a condition. \return whether the way is still possible
  bool require(NodeId condition, Path& way) {
    if (const auto known = nodes.constant(condition)) return *known != 0;
    Bits read;
    addReads(system, condition, read);
    if (read.meets(writtenBy(way)) || mayFail(system, condition)) giveUp();
    way.guard = nodes.both(way.guard, condition);
    return !isHopeless;
  }

  [[nodiscard]] bool mayHaveFailed(const Path& way) const {
    return std::ranges::any_of(way.assignments, [&](const Assignment& it) {
      return it.checked || mayFail(system, it.value);
    });
  }

  static Bits writtenBy(const Path& way) {
    Bits cells;
    for (const auto& assignment : way.assignments) cells.insert(assignment.target);
    return cells;
  }

  /// Copies an instruction with its assignments.
  void copy(Instruction instruction, Path& way) {
    const bool isTo = instruction.kind == InstructionKind::To;
    const auto last = isTo ? instruction.first + 1 : instruction.last;
    const auto first = static_cast<std::uint32_t>(way.assignments.size());
    for (auto i = instruction.first; i < last; ++i) way.assignments.push_back(path.assignments[i]);
    instruction.first = first;
    if (!isTo) instruction.last = static_cast<std::uint32_t>(way.assignments.size());
    way.code.push_back(instruction);
  }

  void end(Path way) {
    summarisePath(system, way);
    found.push_back(std::move(way));
    if (found.size() > kMostWays) giveUp();
  }

  void giveUp() { isHopeless = true; }

  Nodes& nodes;
  const System& system; ///< of the nodes
  const Path& path;
  std::vector<Path> found;
  std::size_t tests = 0;
  bool isHopeless = false;
};

/// Copies transitions, with a step for each way through their code.
class Splitter {
public:
  Splitter(const System& of, LimitWatch& watch)
      : whole(of),
        limits(watch),
        made{withoutSteps(of), {}},
        nodes(made.system),
        steps(whole, made.system) {}

  SplitSystem run() && {
    for (TransitionId id = 0; id < whole.transitions.size(); ++id) {
      limits.check();
      if (const auto ways = waysOf(id))
        for (const auto& way : *ways) steps.add(id, along(way, whole.transitions[id]), way);
      else
        steps.add(id);
      made.original.resize(made.system.transitions.size(), id);
    }
    return std::move(made);
  }

private:
  [[nodiscard]] std::optional<std::vector<Path>> waysOf(TransitionId id) {
    const Transition& transition = whole.transitions[id];
    if (transition.parts.size() != 1 || transition.clock != kNone || transition.fails) return {};
    return Ways(nodes, made.system, whole.paths[transition.parts[0]]).all();
  }

  Transition along(const Path& way, Transition transition) {
    transition.guard = nodes.both(transition.guard, way.guard);
    transition.guardReads = way.guardReads;
    addReads(made.system, transition.guard, transition.guardReads);
    transition.reads = way.reads;
    transition.writes = way.writes;
    transition.tentative = false;
    return transition;
  }

  const System& whole;
  LimitWatch& limits;
  SplitSystem made;
  Nodes nodes; ///< of the made system
  StepCopies steps;
};

} // namespace

SplitSystem withSplitTests(const System& whole, LimitWatch& limits) {
  return Splitter(whole, limits).run();
}

} // namespace proskill::verify
