#pragma once

#include "tests/bridge/ticker.h"

#include <map>

namespace proskill::test {

/// The skills of a program that stand for an action, by its name.
using Copies = std::map<std::string, std::vector<std::string>>;

/// Properties that ask for what can be seen of the skill `Main`.
/// \param maySkip whether `Main` has the outcome `skipped`
[[nodiscard]] std::string questions(const Copies& actions, bool maySkip);

/// What the verifier says about a program with such properties. Nothing if it is too large.
[[nodiscard]] std::optional<Observed> verified(const std::string& text);

} // namespace proskill::test
