#pragma once

#include "bridge/rl/read/composite.h"

#include <expected>
#include <string_view>

namespace proskill::bridge::rl {

/// A file as it is written.
struct Parsed {
  std::vector<Word> includes;
  std::vector<Skillset> skillsets;
  std::vector<Composite> composites;
};

inline constexpr std::size_t kDeepestExpr = 200;

/// Reads a file of skillsets or composites. Both dialects are accepted, with their parts in any
/// order. \return what it contains, or its first error
[[nodiscard]] std::expected<Parsed, Error> parse(std::string_view text,
                                                 const std::filesystem::path& file);

} // namespace proskill::bridge::rl
