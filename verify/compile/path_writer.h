#pragma once

#include "verify/compile/paths.h"

#include <map>

namespace proskill::verify {

/// The remaining statements; the next one is last.
using RestOfPath = std::vector<const fiacre::Statement*>;

/// A path that is being written.
struct PathDraft {
  Path path;
  bool assigned = false; ///< something was assigned, so an `on` can no longer be part of the guard
  bool branched = false; ///< control flow has branched, so the cells' values are no longer known
  std::map<CellId, NodeId> current; ///< the values assigned so far, over the state before the path
  bool ended = false;               ///< by `to` or `loop`
};

/// Follows the statement of a `from` to each of its ends and writes a path for each way through it.
/// \throw CompileError
class PathWriter {
public:
  PathWriter(PathContext& of, Expressions& in) : context(of), expressions(in) {}

  void write(PathDraft draft, RestOfPath rest);
  std::vector<Path> found;

private:
  // path_writer.cpp: statements that split the path, and statements that do not branch
  bool step(const fiacre::Statement& statement, PathDraft& draft, RestOfPath& rest);

  // path_code.cpp: choices within one path
  void codeAll(PathDraft& draft, RestOfPath rest);
  void codeIf(const fiacre::Statement& statement, PathDraft& draft, const RestOfPath& rest);
  void codeCase(const fiacre::Statement& statement, PathDraft& draft, const RestOfPath& rest);
  void codeChoice(NodeId condition, PathDraft& draft, const RestOfPath& then,
                  const RestOfPath& otherwise);
  void codeWhile(const fiacre::Statement& statement, PathDraft& draft);

  void require(NodeId condition, PathDraft& draft, fiacre::OriginId origin);
  void assign(const fiacre::Statement& statement, PathDraft& draft);
  void end(const fiacre::Statement& statement, PathDraft& draft);
  void synchronise(const fiacre::Statement& statement, PathDraft& draft);
  [[nodiscard]] NodeId beforePath(NodeId value, const PathDraft& draft);
  void splitIf(const fiacre::Statement& statement, const PathDraft& draft, const RestOfPath& rest);
  void splitCase(const fiacre::Statement& statement, const PathDraft& draft,
                 const RestOfPath& rest);
  void select(const fiacre::Statement& statement, const PathDraft& draft, const RestOfPath& rest);
  void bind(const fiacre::Expr& pattern, const Value& tested, PathDraft& draft);
  void any(const fiacre::Statement& statement, const PathDraft& draft, const RestOfPath& rest);
  void foreach (const fiacre::Statement& statement, RestOfPath & rest);
  void send(const fiacre::Statement& statement, PathDraft& draft);
  void receive(const fiacre::Statement& statement, PathDraft& draft);
  void addAssignments(PathDraft& draft, std::uint32_t first);
  void finish(PathDraft draft);

  Nodes& nodes() { return expressions.nodes(); }
  NodeId scalar(const fiacre::Expr& expr) { return expressions.scalar(expr, *context.scope); }

  PathContext& context;
  Expressions& expressions;
};

/// Whether a statement only assigns, branches on data and ends paths.
[[nodiscard]] bool isPlain(const fiacre::Statement& statement);
/// Whether a statement contains `to` or `loop`.
[[nodiscard]] bool endsPath(const fiacre::Statement& statement);

Instruction& addInstruction(PathDraft& draft, InstructionKind kind);
/// Marks the following code as coming from this statement.
void noteOrigin(const fiacre::Statement& statement, PathDraft& draft);
[[nodiscard]] RestOfPath withNext(RestOfPath rest, const fiacre::Statement& next);

} // namespace proskill::verify
