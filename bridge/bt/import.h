#pragma once

#include "analysis/program/program.h"
#include "bridge/bt/tree/leaves.h"

namespace proskill::bridge::bt {

/// A behavior tree as a program.
struct Imported {
  std::string text;
  bool exact = true; ///< nothing was approximated
  /// For people: what was imported, what was approximated, and what verdicts mean.
  std::vector<std::string> summary;
};

/// Reads a file of BehaviorTree.CPP v4 with what it includes, and translates its main tree.
/// docs/import.md says what becomes of each node.
[[nodiscard]] std::expected<Imported, Errors> importTree(const analysis::FileSystem& files,
                                                         const std::filesystem::path& root,
                                                         const Leaves& leaves);

} // namespace proskill::bridge::bt
