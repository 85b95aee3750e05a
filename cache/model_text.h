#pragma once

#include "fiacre/syntax/tree.h"

#include <string>

/// What verdicts depend on, as text.
namespace proskill::cache {

/// The text of the model without comments and without its properties, but with those that others
/// refer to by name.
[[nodiscard]] std::string textOf(fiacre::Program program);

/// Includes the number of the kind, since some kinds have no text in Fiacre.
[[nodiscard]] std::string textOf(const fiacre::Pattern& pattern, const std::string& main);

} // namespace proskill::cache
