#include "verify/model/place_counts.h"

#include "verify/model/nodes.h"
#include "verify/model/path_summary.h"
#include "verify/model/value_bounds.h"

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

namespace proskill::verify {

namespace {

constexpr std::size_t kMostForks = 64; ///< through the code of one path

/// An assignment that adds a constant to a number.
struct Sum {
  PathId path = 0;
  std::uint32_t assignment = 0;
  std::int64_t adds = 0;

  friend auto operator<=>(const Sum&, const Sum&) = default;
};

/// One number, and the changes that steps make to it.
class PlaceCount {
public:
  PlaceCount(const System& of, CellId counted, const std::function<void()>& tell)
      : system(of), cell(counted), check(tell), added(of.instances.size()) {}

  /// The assignments that keep the number within its range.
  [[nodiscard]] std::set<Sum> harmless() {
    Bits writers;
    for (const auto& path : system.paths)
      if (path.writes.contains(cell)) writers.insert(path.instance);
    for (PathId id = 0; id < system.paths.size() && !isOther; ++id)
      if (writers.contains(system.paths[id].instance)) addMoves(id);
    writers.each([&](InstanceId writer) {
      if (!isOther) followMoves(writer);
    });
    std::set<Sum> found;
    if (isOther) return found;
    std::set<Sum> harmful;
    for (const auto& change : changes)
      (isHarmless(change) ? found : harmful).insert({change.path, change.assignment, change.adds});
    for (const auto& one : harmful) found.erase(one);
    return found;
  }

private:
  using Range = ValueBounds;

  /// A way of an instance from one location to another, and what it adds to the number.
  struct Move {
    InstanceId instance = 0;
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    std::int64_t adds = 0;
  };
  /// An assignment to the number, on one way through its path.
  struct Change {
    PathId path = 0;
    std::uint32_t assignment = 0;
    std::int64_t adds = 0;
    std::vector<KnownTruth> known; ///< conditions on the number before
  };
  struct Way {
    std::size_t at = 0; ///< the next instruction
    std::int64_t adds = 0;
    bool isChanged = false;
    std::vector<KnownTruth> known;
  };

  void addMoves(PathId id) {
    const Path& path = system.paths[id];
    if (path.fails) return;
    Way way;
    know({path.guard, true}, way);
    std::size_t left = kMostForks;
    follow(id, std::move(way), left);
  }

  void know(const KnownTruth& truth, Way& way) const {
    if (way.isChanged) return;
    const Node& node = system.nodes[truth.condition];
    if (node.op == NodeOp::And && truth.truth) {
      know({node.a, true}, way);
      know({node.b, true}, way);
      return;
    }
    Bits read;
    addReads(system, truth.condition, read);
    Bits own;
    own.insert(cell);
    if (read == own) way.known.push_back(truth);
  }

  void follow(PathId id, Way way, std::size_t& left) {
    const Path& path = system.paths[id];
    while (!isOther) {
      work();
      if (way.at >= path.code.size()) return;
      const auto& next = path.code[way.at++];
      switch (next.kind) {
      case InstructionKind::Assign:
        for (auto i = next.first; i < next.last; ++i) assign(id, i, way);
        break;
      case InstructionKind::On: know({next.node, true}, way); break;
      case InstructionKind::JumpUnless: {
        if (next.last < way.at || left == 0) return giveUp();
        --left;
        Way other = way;
        other.at = next.last;
        know({next.node, false}, other);
        follow(id, std::move(other), left);
        know({next.node, true}, way);
        break;
      }
      case InstructionKind::Jump:
        if (next.last < way.at) return giveUp();
        way.at = next.last;
        break;
      case InstructionKind::To:
        moves.push_back({path.instance, path.location, next.last, way.adds});
        return;
      case InstructionKind::Loop:
        moves.push_back({path.instance, path.location, path.location, way.adds});
        return;
      case InstructionKind::Fail: return;
      case InstructionKind::Store: return giveUp();
      case InstructionKind::Tag:
      case InstructionKind::Origin: break;
      }
    }
  }

  void giveUp() { isOther = true; }

  /// Looks at the limits now and then.
  void work() {
    constexpr std::uint64_t kBetweenChecks = 256;
    if (++steps % kBetweenChecks == 0) check();
  }

  void assign(PathId id, std::uint32_t at, Way& way) {
    const auto& assignment = system.paths[id].assignments[at];
    if (assignment.target != cell) return;
    const auto adds = addedBy(assignment.value);
    if (!adds || way.isChanged) return giveUp();
    changes.push_back({id, at, *adds, way.known});
    way.isChanged = true;
    way.adds = *adds;
  }

  /// What the value adds to the number, if that is a constant.
  [[nodiscard]] std::optional<std::int64_t> addedBy(NodeId value) const {
    constexpr std::int64_t kMost = 1'000'000;
    const Node& node = system.nodes[value];
    if (node.op != NodeOp::Add && node.op != NodeOp::Subtract) return std::nullopt;
    const Node& left = system.nodes[node.a];
    const Node& right = system.nodes[node.b];
    if (left.op != NodeOp::Cell || left.a != cell || right.op != NodeOp::Number ||
        right.number < -kMost || right.number > kMost)
      return std::nullopt;
    return node.op == NodeOp::Add ? right.number : -right.number;
  }

  /// Determines what is added wherever the instance is.
  void followMoves(InstanceId instance) {
    auto& of = added[instance];
    of.assign(system.instances[instance].locations.size(), std::nullopt);
    of[static_cast<std::size_t>(system.cells[system.instances[instance].location].initial)] = 0;
    std::vector<Move> own;
    std::ranges::copy_if(moves, std::back_inserter(own),
                         [&](const Move& move) { return move.instance == instance; });
    for (bool grew = true; grew && !isOther;) {
      grew = false;
      for (const auto& [_, from, to, adds] : own) {
        work();
        if (!of[from]) continue;
        if (of[to] && *of[to] != *of[from] + adds) return giveUp();
        grew = grew || !of[to];
        of[to] = *of[from] + adds;
      }
    }
  }

  [[nodiscard]] bool isHarmless(const Change& change) const {
    const Path& path = system.paths[change.path];
    const auto here = added[path.instance][path.location];
    if (!here) return true; // the instance is never there
    const Cell& of = system.cells[cell];
    Range before{of.initial + *here, of.initial + *here};
    for (InstanceId i = 0; i < added.size(); ++i) {
      if (i == path.instance) continue;
      const auto [least, most] = rangeOf(i);
      before.low += least;
      before.high += most;
    }
    const auto tested = valueBounds(system, counted(), change.known);
    if (!tested) return true; // the way is never taken
    const auto low = std::max(before.low, tested->low) + change.adds;
    const auto high = std::min(before.high, tested->high) + change.adds;
    return low >= of.low && high <= of.high;
  }

  /// What the locations of the instance may add.
  [[nodiscard]] Range rangeOf(InstanceId instance) const {
    Range range;
    for (const auto& some : added[instance]) {
      if (!some) continue;
      range.low = std::min(range.low, *some);
      range.high = std::max(range.high, *some);
    }
    return range;
  }

  /// The node that is the number itself.
  [[nodiscard]] NodeId counted() const {
    const auto& change = changes.front();
    return system.nodes[system.paths[change.path].assignments[change.assignment].value].a;
  }

  const System& system;
  CellId cell;
  const std::function<void()>& check;
  std::uint64_t steps = 0;
  std::vector<Move> moves;
  std::vector<Change> changes;
  std::vector<std::vector<std::optional<std::int64_t>>> added; ///< by instance and location
  bool isOther = false;                                        ///< the number does not count places
};

[[nodiscard]] Bits checkedCells(const System& system) {
  Bits cells;
  for (const auto& path : system.paths)
    for (const auto& assignment : path.assignments)
      if (assignment.checked) cells.insert(assignment.target);
  return cells;
}

/// The number plus a constant, or the bound that it would pass.
NodeId sumWithin(CellId cell, const Cell& range, std::int64_t adds, Nodes& nodes) {
  const NodeId old = nodes.cell(cell);
  const NodeId sum = nodes.binary(NodeOp::Add, old, nodes.number(adds));
  const bool grows = adds > 0;
  const NodeId last = nodes.number((grows ? range.high : range.low) - adds);
  const NodeId passes =
      grows ? nodes.binary(NodeOp::Less, last, old) : nodes.binary(NodeOp::Less, old, last);
  return nodes.conditional(passes, nodes.number(grows ? range.high : range.low), sum);
}

} // namespace

void dropNeedlessChecks(System& system, const std::function<void()>& check) {
  const auto checked = checkedCells(system);
  if (checked.empty()) return;
  std::set<PathId> changed;
  Nodes nodes(system, check);
  checked.each([&](CellId cell) {
    for (const auto& [path, index, adds] : PlaceCount(system, cell, check).harmless()) {
      auto& assignment = system.paths[path].assignments[index];
      assignment.value = sumWithin(cell, system.cells[cell], adds, nodes);
      assignment.checked = false;
      changed.insert(path);
    }
  });
  for (auto path : changed) summarisePath(system, system.paths[path]);
}

} // namespace proskill::verify
