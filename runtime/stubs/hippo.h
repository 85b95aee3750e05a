#pragma once

#include "runtime/stubs/stubs.h"

namespace proskill::runtime {

/// A project for Hippo: the model in H-Fiacre, the functions in C that it calls, and the files of
/// `cStubs`, whose actions it performs.
/// \param ticksPerSecond of the model
/// \pre the program has no errors
[[nodiscard]] std::expected<std::vector<StubFile>, codegen::GenerationError>
hippoProject(const analysis::Program& program, const std::string& mainSkill,
             std::int64_t ticksPerSecond);

} // namespace proskill::runtime
