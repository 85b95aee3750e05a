#pragma once

#include "analysis/flow/engine/solver.h"
#include "analysis/names/index.h"

#include <vector>

namespace proskill::analysis::flow {

/// What may be true where in a program, for all who ask. Looks into the program. \pre the program
/// has no errors of form, names or types.
struct Flow {
  explicit Flow(const Program& program) : system(program), solver(system) {}
  Flow(const Flow&) = delete; ///< the solver looks into the system
  Flow& operator=(const Flow&) = delete;

  System system;
  Solver solver;
};

/// What is wrong with the values, the flow and the time of a program: PS05xx to PS11xx, in the
/// order of the files. \pre the program has no errors of form, names or types.
/// \param style false: without the hints of PS11xx, which cost a while in a large program
[[nodiscard]] std::vector<syntax::Diagnostic> checkFlow(const Program& program, const Index& index,
                                                        bool style = true);
[[nodiscard]] std::vector<syntax::Diagnostic> checkFlow(const Flow& flow, const Index& index,
                                                        bool style = true);

} // namespace proskill::analysis::flow
