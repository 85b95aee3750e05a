#include "verify/model/path_summary.h"

#include "verify/model/nodes.h"
#include "verify/model/value_bounds.h"

namespace proskill::verify {

void summarisePath(const System& system, Path& path) {
  addReads(system, path.guard, path.guardReads);
  path.guardReads.insert(system.instances[path.instance].location);
  path.mayFail = mayFail(system, path.guard);
  const auto reads = [&](NodeId node) {
    addReads(system, node, path.reads);
    path.mayFail = path.mayFail || mayFail(system, node);
  };
  for (std::size_t i = 0; i < path.code.size(); ++i) {
    const auto& instruction = path.code[i];
    if (instruction.kind == InstructionKind::On || instruction.kind == InstructionKind::JumpUnless)
      reads(instruction.node);
    if (instruction.kind == InstructionKind::Fail) path.mayFail = true;
    if (instruction.kind == InstructionKind::Jump && instruction.last <= i) path.mayFail = true;
  }
  for (const auto& assignment : path.assignments) {
    reads(assignment.value);
    path.writes.insert(assignment.target);
    path.mayFail = path.mayFail || assignment.checked;
  }
  if (path.tentative) path.guardReads |= path.reads;
}

} // namespace proskill::verify
