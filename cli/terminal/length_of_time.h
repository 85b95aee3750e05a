#pragma once

#include "cli/terminal/help.h"
#include "runtime/machine/executable.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace proskill::cli {

/// An option with a length of time: `90`, `90s`, `5m`, `2h`, `1d`. Shorter ones than the least are
/// refused.
CLI::Option* addLengthOfTime(CLI::App& command, const std::string& name,
                             std::optional<runtime::Nanoseconds>& chosen, const std::string& help,
                             const char* inGroup, runtime::Nanoseconds least = 1);
/// Removes a number from 0 to 1e9 from the beginning of a word.
[[nodiscard]] std::optional<double> takeNumber(std::string_view& word);

} // namespace proskill::cli
