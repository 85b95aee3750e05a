#pragma once

#include "analysis/program/program.h"
#include "viz/pictures.h"

#include <string>

namespace proskill::viz::test {

/// The program of one file, `p.proskill`.
[[nodiscard]] analysis::Program program(std::string text);

/// A program of the examples.
[[nodiscard]] analysis::Program example(const std::string& path);

/// The picture, which must exist.
[[nodiscard]] Graph picture(const analysis::Program& program, Kind kind,
                            const std::string& name = "", bool forbidden = false);

/// A graph as lines: each node as `role label {detail; detail}`, in its cluster if it has one, then
/// each edge as `from -> to`, with its role and label.
[[nodiscard]] std::string outline(const Graph& graph);

/// The text that a node comes from.
[[nodiscard]] std::string origin(const analysis::Program& program, const Node& node);

} // namespace proskill::viz::test
