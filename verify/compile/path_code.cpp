#include "verify/compile/path_writer.h"

#include "verify/unsupported.h"

#include <algorithm>
#include <utility>

namespace proskill::verify {

using fiacre::Statement;
using fiacre::StatementKind;

namespace {

constexpr std::size_t kMostCode = 100'000; // of one path

} // namespace

bool isPlain(const Statement& statement) {
  switch (statement.kind) {
  case StatementKind::Null:
  case StatementKind::Comment:
  case StatementKind::Assign:
  case StatementKind::Tag:
  case StatementKind::To:
  case StatementKind::Loop: return true;
  case StatementKind::If:
  case StatementKind::Case:
  case StatementKind::While:
  case StatementKind::Sequence: return std::ranges::all_of(statement.children, isPlain);
  case StatementKind::Any:
  case StatementKind::On:
  case StatementKind::Wait:
  case StatementKind::Select:
  case StatementKind::Send:
  case StatementKind::Receive:
  case StatementKind::Start:
  case StatementKind::Sync:
  case StatementKind::Foreach:
  case StatementKind::Return: return false;
  }
  std::unreachable();
}

bool endsPath(const Statement& statement) {
  if (statement.kind == StatementKind::To || statement.kind == StatementKind::Loop) return true;
  return std::ranges::any_of(statement.children, endsPath);
}

Instruction& addInstruction(PathDraft& draft, InstructionKind kind) {
  draft.path.code.push_back({.kind = kind});
  return draft.path.code.back();
}

void noteOrigin(const Statement& statement, PathDraft& draft) {
  if (statement.origin == 0) return;
  addInstruction(draft, InstructionKind::Origin).first = statement.origin;
  if (draft.path.origin == 0) draft.path.origin = statement.origin;
}

RestOfPath withNext(RestOfPath rest, const Statement& next) {
  rest.push_back(&next);
  return rest;
}

/// Generates code for statements that neither wait nor communicate.
void PathWriter::codeAll(PathDraft& draft, RestOfPath rest) {
  while (!rest.empty() && !draft.ended) {
    const Statement& statement = *rest.back();
    rest.pop_back();
    if (draft.path.code.size() > kMostCode)
      unsupported("too many choices, one after the other", statement.origin);
    if (statement.kind == StatementKind::If || statement.kind == StatementKind::Case) {
      noteOrigin(statement, draft);
      auto inner = endsPath(statement) ? std::exchange(rest, {}) : RestOfPath{};
      statement.kind == StatementKind::If ? codeIf(statement, draft, inner)
                                          : codeCase(statement, draft, inner);
    } else if (statement.kind == StatementKind::While) {
      noteOrigin(statement, draft);
      codeWhile(statement, draft);
    } else {
      step(statement, draft, rest);
    }
  }
}

/// Generates code for both branches, each up to the end of the path.
void PathWriter::codeChoice(NodeId condition, PathDraft& draft, const RestOfPath& then,
                            const RestOfPath& otherwise) {
  draft.branched = true;
  const auto branch = draft.path.code.size();
  addInstruction(draft, InstructionKind::JumpUnless).node = condition;
  codeAll(draft, then);
  const bool thenEnded = std::exchange(draft.ended, false);
  const auto jump = draft.path.code.size();
  if (!thenEnded) addInstruction(draft, InstructionKind::Jump);
  draft.path.code[branch].last = static_cast<std::uint32_t>(draft.path.code.size());
  codeAll(draft, otherwise);
  if (!thenEnded) draft.path.code[jump].last = static_cast<std::uint32_t>(draft.path.code.size());
  draft.ended = draft.ended && thenEnded;
  draft.assigned = true;
}

void PathWriter::codeWhile(const Statement& statement, PathDraft& draft) {
  if (endsPath(statement)) unsupported("`to` or `loop` within a `while`", statement.origin);
  const auto again = static_cast<std::uint32_t>(draft.path.code.size());
  const NodeId condition = scalar(statement.values.at(0));
  addInstruction(draft, InstructionKind::JumpUnless).node = condition;
  draft.branched = draft.assigned = true;
  codeAll(draft, {&statement.children.at(0)});
  addInstruction(draft, InstructionKind::Jump).last = again;
  draft.path.code[again].last = static_cast<std::uint32_t>(draft.path.code.size());
}

void PathWriter::codeIf(const Statement& statement, PathDraft& draft, const RestOfPath& rest) {
  NodeId condition = scalar(statement.values.at(0));
  RestOfPath otherwise =
      statement.children.size() > 1 ? withNext(rest, statement.children[1]) : rest;
  if (auto known = nodes().constant(condition))
    return codeAll(draft, *known != 0 ? withNext(rest, statement.children.at(0)) : otherwise);
  codeChoice(condition, draft, withNext(rest, statement.children.at(0)), otherwise);
}

void PathWriter::codeCase(const Statement& statement, PathDraft& draft, const RestOfPath& rest) {
  draft.branched = true;
  Value tested = expressions.value(statement.values.at(0), *context.scope);
  std::vector<std::size_t> jumps;
  bool allEnded = true;
  for (std::size_t i = 0; i < statement.children.size(); ++i) {
    NodeId condition = expressions.matches(statement.values.at(i + 1), tested, *context.scope);
    const auto branch = draft.path.code.size();
    addInstruction(draft, InstructionKind::JumpUnless).node = condition;
    bind(statement.values[i + 1], tested, draft);
    codeAll(draft, withNext(rest, statement.children[i]));
    if (!std::exchange(draft.ended, false)) {
      allEnded = false;
      jumps.push_back(draft.path.code.size());
      addInstruction(draft, InstructionKind::Jump);
    }
    draft.path.code[branch].last = static_cast<std::uint32_t>(draft.path.code.size());
  }
  addInstruction(draft, InstructionKind::On).node = nodes().number(0); // no pattern matches
  draft.path.tentative = true;
  for (auto jump : jumps)
    draft.path.code[jump].last = static_cast<std::uint32_t>(draft.path.code.size());
  draft.ended = allEnded;
  draft.assigned = true;
}

} // namespace proskill::verify
