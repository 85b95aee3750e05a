#pragma once

#include "ide/snapshot/snapshot.h"

namespace proskill::ide {

/// A diagnostic, and the program to which its locations refer.
struct Finding {
  std::shared_ptr<const AnalysedProgram> owner;
  const syntax::Diagnostic* diagnostic = nullptr;
};

/// The diagnostics of a file in all programs that include it. A diagnostic that several of them
/// have is returned once.
[[nodiscard]] std::vector<Finding> diagnostics(const Snapshot& snapshot,
                                               const std::filesystem::path& file);

} // namespace proskill::ide
