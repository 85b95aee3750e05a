#pragma once

#include <string>
#include <string_view>

namespace proskill::cli {

/// Prints `error: …` to standard error. \return kFailed
int fail(std::string_view message);

/// A text for standard output. On a terminal, without control characters; otherwise unchanged.
[[nodiscard]] std::string forOutput(std::string_view text);

} // namespace proskill::cli
