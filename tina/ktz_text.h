#pragma once

#include <cstdint>
#include <expected>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace proskill::tina {

/// A state graph in the text format of `ktzio`.
struct KtzGraph {
  struct State {
    /// Places and variables with their values, by index in `properties`.
    std::vector<std::pair<std::uint32_t, std::int64_t>> has;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges; ///< label and target
  };
  std::vector<std::string> properties;
  std::vector<std::string> labels;
  std::vector<State> states; ///< 0 is the initial state
};

/// Reads the text; the error names the line. The numbers of states and edges in the header must
/// match, so that truncated files are detected.
[[nodiscard]] std::expected<KtzGraph, std::string> readKtzText(std::istream& in);

} // namespace proskill::tina
