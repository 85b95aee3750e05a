#pragma once

#include "analysis/program/program.h"
#include "bridge/text/imported.h"
#include "bridge/text/place.h"

#include <expected>

namespace proskill::bridge::rl {

/// Reads skillsets of the robot language (RL) with what they include, and translates them.
/// docs/import.md says what becomes of each part.
/// \param folder of the program: comments give paths of originals from there
[[nodiscard]] std::expected<Imported, Errors> importSkillsets(const analysis::FileSystem& files,
                                                              const std::filesystem::path& root,
                                                              const std::filesystem::path& folder);

} // namespace proskill::bridge::rl
