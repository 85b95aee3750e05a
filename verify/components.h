#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace proskill::verify {

/// The strongly connected components of a graph: by node, a node that stands for its component.
/// R. Tarjan, "Depth-first search and linear graph algorithms", SIAM Journal on Computing 1972.
/// \param successor the i-th of a node, kNone behind the last
[[nodiscard]] std::vector<std::uint32_t>
componentsOf(std::size_t nodes,
             const std::function<std::uint32_t(std::uint32_t node, std::size_t i)>& successor);

} // namespace proskill::verify
