#pragma once

#include "runtime/stubs/stubs.h"

#include <filesystem>

namespace proskill::cli {

/// Writes files for users to fill in, and prints which. Files of users, and generated files that
/// users have changed, are not overwritten; in the latter case nothing is written.
/// \return an exit code
int writeStubFiles(const std::vector<runtime::StubFile>& files,
                   const std::filesystem::path& directory);

} // namespace proskill::cli
