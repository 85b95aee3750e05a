#pragma once

#include "analysis/flow/domain/variables.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace proskill::analysis::flow {

using Slot = std::uint32_t;

/// The variables that a process tracks, in ascending order. A variable that neither it nor its
/// callees ever read gets no slot.
class Slots {
public:
  Slots() = default;
  /// Duplicates are allowed.
  explicit Slots(std::vector<VariableId> variables) : ids(std::move(variables)) {
    std::ranges::sort(ids);
    ids.erase(std::ranges::unique(ids).begin(), ids.end());
  }

  [[nodiscard]] std::size_t size() const { return ids.size(); }
  [[nodiscard]] VariableId operator[](Slot slot) const { return ids[slot]; }
  [[nodiscard]] const std::vector<VariableId>& variables() const { return ids; }
  /// The skill whose inputs the process may read, by its index in the program.
  std::optional<std::size_t> skill;
  [[nodiscard]] std::optional<Slot> find(VariableId id) const {
    auto found = std::ranges::lower_bound(ids, id);
    if (found == ids.end() || *found != id) return std::nullopt;
    return static_cast<Slot>(found - ids.begin());
  }

private:
  std::vector<VariableId> ids;
};

/// A box: the possible values of each slot of a process, independent of each other.
struct State {
  bool reachable = false;
  std::vector<ValueSet> values; ///< by slot; empty if unreachable

  /// Adds the values of another path to this point. \return whether the box has grown
  bool join(const State& other) {
    if (!other.reachable) return false;
    if (!reachable) {
      *this = other;
      return true;
    }
    bool grew = false;
    for (std::size_t i = 0; i < values.size(); ++i) {
      grew |= !other.values[i].within(values[i]);
      values[i] |= other.values[i];
    }
    return grew;
  }
};

/// The knowledge of a process at a point of its graph: a few boxes, one of which is true. Boxes
/// preserve which values occur together, such as a result and the effects of the skill. If there
/// are too many boxes, those that differ least are merged. A process without slots has at most one
/// box.
class Cases {
public:
  /// Keeps at most `most` boxes, fewer if they have many slots. \return whether something is new
  bool add(State box, std::size_t most);
  [[nodiscard]] bool reachable() const { return !boxes.empty(); }
  [[nodiscard]] const std::vector<State>& all() const { return boxes; }
  /// The smallest box that contains all cases.
  [[nodiscard]] State hull() const;

private:
  void absorb(State box, std::size_t most);

  std::vector<State> boxes;
};

} // namespace proskill::analysis::flow
