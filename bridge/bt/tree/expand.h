#pragma once

#include "bridge/bt/tree/tree.h"

namespace proskill::bridge::bt {

inline constexpr std::size_t kMostNodes = 20'000;
inline constexpr std::size_t kDeepestTree = 250;

/// The main tree with a copy of each tree in place of its uses: every SubTree has one child. Values
/// of ports like `{goal}` become names of entries that are unique in the whole, so that equal
/// values mean the same entry.
[[nodiscard]] std::expected<Node, Errors> expand(const Forest& forest);

} // namespace proskill::bridge::bt
