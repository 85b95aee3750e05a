#pragma once

#include "codegen/model.h"
#include "verify/graph/state_graph.h"

#include <string>

namespace proskill::cli {

/// `proskill verify --graph`: explores the whole state graph, writes it into a file whose name says
/// the format (`.aut`, `.txt`), or into none where `target` is `counts`, and prints its size.
/// Returns the exit code.
[[nodiscard]] int exploreGraph(const std::string& target, verify::GraphKind kind,
                               const codegen::Model& model, const verify::Options& options);

} // namespace proskill::cli
