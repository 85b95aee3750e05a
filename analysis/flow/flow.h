#pragma once

#include "analysis/flow/engine/solver.h"
#include "analysis/names/index.h"

#include <vector>

namespace proskill::analysis::flow {

/// The result of the flow analysis: what may be true at each place of a program. It refers to the
/// program. \pre the program has no errors of form, names or types
struct Flow {
  explicit Flow(const Program& program) : system(program), solver(system) {}
  Flow(const Flow&) = delete; ///< the solver refers to the system
  Flow& operator=(const Flow&) = delete;

  System system;
  Solver solver;
};

/// Diagnostics about values, flow and time of a program, PS05xx to PS11xx, in the order of the
/// files. \pre the program has no errors of form, names or types
/// \param style false: without the hints of PS11xx, which take long in a large program
[[nodiscard]] std::vector<syntax::Diagnostic> checkFlow(const Program& program, const Index& index,
                                                        bool style = true);
[[nodiscard]] std::vector<syntax::Diagnostic> checkFlow(const Flow& flow, const Index& index,
                                                        bool style = true);

} // namespace proskill::analysis::flow
