#pragma once

#include "bridge/gen/read/component.h"

#include <expected>
#include <string_view>

namespace proskill::bridge::gen {

/// A file as it is written.
struct Parsed {
  std::vector<Word> includes;
  std::vector<Component> components;
  std::vector<Word> exceptions; ///< outside of components
  std::vector<Word> ignored;    ///< directives of the preprocessor that matter
};

/// Reads a `.gen` file of GenoM3.
/// \return what it contains, or its first error
[[nodiscard]] std::expected<Parsed, Error> parse(std::string_view text,
                                                 const std::filesystem::path& file);

} // namespace proskill::bridge::gen
