#pragma once

#include "tests/support/random/random_source.h"

#include <string>

namespace proskill::test {

/// A random file of BehaviorTree.CPP with one tree, `Main`. Its actions are called a0, a1, …; their
/// types are `Any`, `Good`, which succeeds, `Bad`, which fails, and `Quick`, which ends in the tick
/// that starts it.
[[nodiscard]] std::string randomTree(std::uint64_t seed);
/// The side file about these types.
inline constexpr auto kRandomLeaves = R"({"leaves": {"Good": {"outcomes": ["success"]},
                                                     "Bad": {"outcomes": ["failure"]},
                                                     "Quick": {"duration": [0, 0]}}})";

} // namespace proskill::test
