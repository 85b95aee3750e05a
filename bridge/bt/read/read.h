#pragma once

#include "analysis/program/program.h"
#include "bridge/bt/tree/tree.h"

namespace proskill::bridge::bt {

inline constexpr std::size_t kMostFiles = 1000;

/// Reads a file and what it includes, and checks everything that BehaviorTree.CPP requires.
/// A file that is included twice is read once; a cycle of includes is an error.
/// \param main the tree to execute; empty: as the file says
/// \return the trees, or all errors in the order in which they were found
[[nodiscard]] std::expected<Forest, Errors> read(const analysis::FileSystem& files,
                                                 const std::filesystem::path& root,
                                                 const std::string& main = {});

} // namespace proskill::bridge::bt
