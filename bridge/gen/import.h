#pragma once

#include "analysis/program/program.h"
#include "bridge/text/imported.h"
#include "bridge/text/leaves.h"
#include "bridge/text/place.h"

#include <expected>

namespace proskill::bridge::gen {

/// Reads components of GenoM3 with what they include, and translates them.
/// docs/import.md says what becomes of each part.
/// \param leaves durations and results of services
/// \param folder of the program: comments give paths of originals from there
[[nodiscard]] std::expected<Imported, Errors> importComponents(const analysis::FileSystem& files,
                                                               const std::filesystem::path& root,
                                                               const Leaves& leaves,
                                                               const std::filesystem::path& folder);

} // namespace proskill::bridge::gen
