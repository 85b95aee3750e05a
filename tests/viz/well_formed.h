#pragma once

#include <string>

namespace proskill::viz::test {

/// Why a text is no well-formed XML document; empty where it is one. Tags and how they nest,
/// attributes and their quotes, entities, comments, characters.
[[nodiscard]] std::string whyNotWellFormed(const std::string& xml);

} // namespace proskill::viz::test
