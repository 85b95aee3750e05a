#pragma once

#include "analysis/flow/engine/system.h"

namespace proskill::analysis::flow {

/// Adds the variables that a process looks at: in conditions, in values, and before a move that may
/// be forbidden.
void addReads(const System& system, const Process& process, std::vector<VariableId>& reads);
void addReads(const syntax::Effects& effects, const Resolver& resolver, const Variables& variables,
              std::vector<VariableId>& reads);

/// The variables that a process sets, with those of its own skill.
[[nodiscard]] std::vector<VariableId> writesOf(const System& system, const Process& process);

/// Fills in what the nodes of a process do. \pre its slots are chosen
void compileActions(const System& system, Process& process);

} // namespace proskill::analysis::flow
