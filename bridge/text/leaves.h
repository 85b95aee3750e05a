#pragma once

#include "bridge/text/place.h"

#include <expected>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::bridge {

/// What an action, a condition or a service can do. Durations are seconds; in a behavior tree, from
/// the tick that starts a leaf to the tick that sees its end.
struct Leaf {
  std::string least = "0";
  std::string most; ///< empty: unbounded
  bool succeeds = true;
  bool fails = true;
  bool changes = true;             ///< a condition: it may change at any time
  bool hasDuration = false;        ///< the file says how long it takes
  std::optional<bool> isCondition; ///< nothing: as its text says

  /// Its duration as ProSkill writes it: `[2,5]`; empty: any time.
  [[nodiscard]] std::string interval() const;
  /// Whether it always ends in the tick that starts it.
  [[nodiscard]] bool isInstant() const { return most == "0"; }
};

/// The side file about leaves.
class Leaves {
public:
  /// \return the leaves of a JSON text, or all that is wrong with it, in the order of the text
  [[nodiscard]] static std::expected<Leaves, Errors> read(std::string_view json,
                                                          const std::filesystem::path& file = {});

  /// From now on, leaves of a type end in the tick that starts them, unless the file says how long
  /// they take.
  void assumeInstant(const std::string& type);
  /// By its own name, or by its type.
  [[nodiscard]] const Leaf& of(const std::string& name, const std::string& type = {}) const;
  /// Entries of the file that nothing was looked up by.
  [[nodiscard]] std::vector<std::string> unused() const;
  /// The longest time between two ticks, as a number of seconds; empty: unbounded.
  std::string tick;

private:
  friend class LeavesReader;

  std::map<std::string, Leaf, std::less<>> known;
  mutable std::set<std::string> used;
  Leaf any;
};

} // namespace proskill::bridge
