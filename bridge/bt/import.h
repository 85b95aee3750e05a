#pragma once

#include "analysis/program/program.h"
#include "bridge/text/imported.h"
#include "bridge/text/leaves.h"
#include "bridge/text/place.h"

namespace proskill::bridge::bt {

/// Reads a file of BehaviorTree.CPP v4 with what it includes, and translates a tree.
/// docs/import.md says what becomes of each node.
/// \param main the tree to translate; empty: the main tree
/// \param folder of the program: comments give paths of originals from there
[[nodiscard]] std::expected<Imported, Errors>
importTree(const analysis::FileSystem& files, const std::filesystem::path& root,
           const Leaves& leaves, const std::filesystem::path& folder, const std::string& main = {});

} // namespace proskill::bridge::bt
