#pragma once

#include "analysis/flow/engine/system.h"

namespace proskill::analysis::flow {

/// Appends the variables that a process reads: in conditions, in values, and before a move that may
/// be forbidden.
void addReads(const System& system, const Process& process, std::vector<VariableId>& reads);
void addReads(const syntax::Effects& effects, const Resolver& resolver, const Variables& variables,
              std::vector<VariableId>& reads);

/// The variables that a process sets, including those of its own skill.
[[nodiscard]] std::vector<VariableId> writesOf(const System& system, const Process& process);

/// Fills in the actions of a process's nodes. \pre its slots are known
void compileActions(const System& system, Process& process);

} // namespace proskill::analysis::flow
