#pragma once

#include "bridge/bt/tree/tree.h"
#include "bridge/text/leaves.h"

#include <set>

namespace proskill::test {

/// What can be seen of a tree in all of its runs.
struct Observed {
  bool success = false;
  bool failure = false;
  bool skipped = false;
  std::set<std::string> started;                          ///< names of actions
  std::set<std::pair<std::string, std::string>> together; ///< two that run at once, in order

  friend bool operator==(const Observed&, const Observed&) = default;
};

/// Whether everything that is seen in `part` is seen in `whole`.
[[nodiscard]] bool covers(const Observed& whole, const Observed& part);
[[nodiscard]] std::string inWords(const Observed& observed);

/// Explores a tree tick by tick, as BehaviorTree.CPP executes it: the tree is ticked at any time;
/// an action that is ticked runs on or ends with a result that it may have; a condition has any
/// result at each reading. It shares the tree with the translation, and nothing else.
/// \return nothing if there are more than `limit` states, or 100 times as many ticks
[[nodiscard]] std::optional<Observed> observe(const bridge::bt::Node& tree,
                                              const bridge::Leaves& leaves, std::size_t limit);

} // namespace proskill::test
