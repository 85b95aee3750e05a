#pragma once

#include "analysis/flow/result/report.h"

/// What findings about loops have in common.
namespace proskill::analysis::flow {

/// The outermost `while` or `do` of some nodes, or what they begin with.
[[nodiscard]] const syntax::Statement& loopStatement(const Process& process,
                                                     const std::vector<NodeId>& loop);
/// Its first word.
[[nodiscard]] Location beginOf(const Report& report, const Process& process,
                               const syntax::Statement& loop);
/// Where the loop has statements, behind the last of them.
void offerWait(Finding& finding, const Report& report, const Process& process,
               const syntax::Statement& loop);

} // namespace proskill::analysis::flow
