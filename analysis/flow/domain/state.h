#pragma once

#include "analysis/flow/domain/variables.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace proskill::analysis::flow {

using Slot = std::uint32_t;

/// Which variables a process follows, in the order of their numbers. A variable that neither it nor
/// what it calls ever looks at is not worth a slot.
class Slots {
public:
  Slots() = default;
  /// Duplicates are welcome.
  explicit Slots(std::vector<VariableId> variables) : ids(std::move(variables)) {
    std::ranges::sort(ids);
    ids.erase(std::ranges::unique(ids).begin(), ids.end());
  }

  [[nodiscard]] std::size_t size() const { return ids.size(); }
  [[nodiscard]] VariableId operator[](Slot slot) const { return ids[slot]; }
  [[nodiscard]] const std::vector<VariableId>& variables() const { return ids; }
  [[nodiscard]] std::optional<Slot> find(VariableId id) const {
    auto found = std::ranges::lower_bound(ids, id);
    if (found == ids.end() || *found != id) return std::nullopt;
    return static_cast<Slot>(found - ids.begin());
  }

private:
  std::vector<VariableId> ids;
};

/// A box: the values that each slot of a process may have, whatever the others have.
struct State {
  bool reachable = false;
  std::vector<ValueSet> values; ///< one a slot where reachable

  /// Takes in another way to get here. \return something is new
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

/// What a process knows at one point of its graph: a few boxes, one of which is true. So it stays
/// known which values go together, such as a result and what the skill has left behind; where the
/// boxes would be too many, those that differ least are made one. A process without slots has at
/// most one box.
class Cases {
public:
  /// Keeps `most` boxes, or fewer where they have many slots. \return something is new
  bool add(State box, std::size_t most);
  [[nodiscard]] bool reachable() const { return !boxes.empty(); }
  [[nodiscard]] const std::vector<State>& all() const { return boxes; }
  /// All cases in one box.
  [[nodiscard]] State hull() const;

private:
  void absorb(State box, std::size_t most);

  std::vector<State> boxes;
};

} // namespace proskill::analysis::flow
