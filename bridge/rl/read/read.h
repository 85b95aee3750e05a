#pragma once

#include "analysis/program/program.h"
#include "bridge/rl/read/parser.h"

namespace proskill::bridge::rl {

/// The skillsets and composites of a file and of those that it includes; of these first. They have
/// no includes.
[[nodiscard]] std::expected<Parsed, Errors> read(const analysis::FileSystem& files,
                                                 const std::filesystem::path& root);

} // namespace proskill::bridge::rl
