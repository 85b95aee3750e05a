#pragma once

#include "analysis/flow/result/report.h"

/// Shared parts of findings about loops.
namespace proskill::analysis::flow {

/// The statement of the outermost `while` or `do` among the nodes; otherwise their first statement.
[[nodiscard]] const syntax::Statement& loopStatement(const Process& process,
                                                     const std::vector<NodeId>& loop);
/// The location of its first word.
[[nodiscard]] Location beginOf(const Report& report, const Process& process,
                               const syntax::Statement& loop);
/// Adds a fix that inserts a wait after the last statement of the loop, if the loop has statements.
void offerWait(Finding& finding, const Report& report, const Process& process,
               const syntax::Statement& loop);

} // namespace proskill::analysis::flow
