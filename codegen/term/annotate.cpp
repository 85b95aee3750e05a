#include "codegen/term/annotate.h"

namespace proskill::codegen {
namespace {

bool isOfOneLine(const fiacre::Statement& statement) { return statement.children.empty(); }

void annotate(fiacre::Statement& statement, const fiacre::Provenance& provenance) {
  if (statement.comment.empty() && isOfOneLine(statement) &&
      statement.kind != fiacre::StatementKind::Sequence)
    statement.comment = provenance.origins[statement.origin].description;
  for (auto& child : statement.children) annotate(child, provenance);
}

} // namespace

void annotate(fiacre::Program& program, const fiacre::Provenance& provenance) {
  for (auto& process : program.processes)
    for (auto& from : process.transitions) annotate(from.statement, provenance);
}

} // namespace proskill::codegen
