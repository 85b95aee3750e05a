#pragma once

#include "analysis/program/program.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace proskill::lsp {

/// The definitions in some lines of a file, counted from 0: names that select properties.
[[nodiscard]] std::vector<std::string> definedIn(const analysis::Program& program,
                                                 const std::filesystem::path& path,
                                                 std::uint32_t first, std::uint32_t last);

} // namespace proskill::lsp
