#pragma once

#include "codegen/model.h"
#include "verify/graph/state_graph.h"

#include <string>

namespace proskill::cli {

/// `proskill verify --graph`: explores the whole state graph, writes it to the file `target`
/// (format by its extension, `.aut` or `.txt`; no file for `counts`) and prints its size. Returns
/// the exit code.
[[nodiscard]] int exploreGraph(const std::string& target, verify::GraphKind kind,
                               const codegen::Model& model, const verify::Options& options);

} // namespace proskill::cli
