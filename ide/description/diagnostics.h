#pragma once

#include "ide/snapshot/snapshot.h"

namespace proskill::ide {

/// A diagnostic, and the program that its places are in.
struct Finding {
  std::shared_ptr<const AnalysedProgram> owner;
  const syntax::Diagnostic* diagnostic = nullptr;
};

/// What is wrong with a file in any program that it belongs to; what several of them say is given
/// once.
[[nodiscard]] std::vector<Finding> diagnostics(const Snapshot& snapshot,
                                               const std::filesystem::path& file);

} // namespace proskill::ide
