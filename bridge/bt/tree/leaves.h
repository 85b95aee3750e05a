#pragma once

#include "bridge/bt/tree/tree.h"

#include <set>

namespace proskill::bridge::bt {

/// What an action or a condition can do. Durations are seconds, from the tick that starts a leaf to
/// the tick that sees its end.
struct Leaf {
  std::string least = "0";
  std::string most; ///< empty: unbounded
  bool succeeds = true;
  bool fails = true;
  bool changes = true; ///< a condition: it may change at any time
  std::optional<Kind> kind;

  /// Whether it always ends in the tick that starts it.
  [[nodiscard]] bool isInstant() const { return most == "0"; }
};

/// The side file about leaves: by the name of a node, or by its type.
class Leaves {
public:
  /// \return the leaves of a JSON text, or what is wrong with it
  [[nodiscard]] static std::expected<Leaves, std::string> read(std::string_view json);

  [[nodiscard]] const Leaf& of(const Node& node) const;
  /// Entries of the file that no node was looked up by.
  [[nodiscard]] std::vector<std::string> unused() const;
  /// The longest time between two ticks, as a number of seconds; empty: unbounded.
  std::string tick;

private:
  std::map<std::string, Leaf, std::less<>> known;
  mutable std::set<std::string> used;
  Leaf any;
};

} // namespace proskill::bridge::bt
