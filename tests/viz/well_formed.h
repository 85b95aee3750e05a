#pragma once

#include <string>

namespace proskill::viz::test {

/// Why a text is not a well-formed XML document; empty if it is. Checks tags and their nesting,
/// attributes and quotes, entities, comments, characters.
[[nodiscard]] std::string whyNotWellFormed(const std::string& xml);

} // namespace proskill::viz::test
