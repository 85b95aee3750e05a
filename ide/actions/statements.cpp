#include "ide/actions/statements.h"

#include <algorithm>

namespace proskill::ide {

namespace {

using syntax::Statement;
using syntax::StatementKind;

bool holds(syntax::Range outer, syntax::Range inner) {
  return outer.begin <= inner.begin && inner.end <= outer.end;
}

std::span<const Statement> selectedIn(const syntax::Block& block, syntax::Range selection) {
  for (const auto& statement : block.statements) {
    if (!holds(statement.range, selection)) continue;
    std::span<const Statement> inner;
    const bool ofCall = statement.kind == StatementKind::Case &&
                        holds(statement.branches[0].range, selection); // not a statement by itself
    forEachBlock(statement, [&](const syntax::Block& part) {
      if (inner.empty() && !ofCall && holds(part.range, selection))
        inner = selectedIn(part, selection);
    });
    return inner.empty() ? std::span(&statement, 1) : inner;
  }
  const auto& all = block.statements;
  auto begin = std::ranges::find_if(
      all, [&](const Statement& it) { return it.range.begin >= selection.begin; });
  auto end = std::find_if(begin, all.end(),
                          [&](const Statement& it) { return it.range.end > selection.end; });
  return {begin, end};
}

} // namespace

void forEachBlock(const Statement& statement,
                  const std::function<void(const syntax::Block&)>& visit) {
  for (const auto& arm : statement.arms) visit(arm.body);
  for (const auto& branch : statement.branches) visit(branch);
}

Selected selectedStatements(const ActionContext& context) {
  Selected result;
  result.form = context.form();
  if (!result.form) return result;
  result.skill = result.form->as<syntax::Skill>();
  if (result.skill && result.skill->body)
    result.statements = selectedIn(*result.skill->body, context.selection);
  return result;
}

bool contains(std::span<const Statement> statements, std::initializer_list<StatementKind> kinds) {
  return std::ranges::any_of(statements, [&](const Statement& statement) {
    bool found = std::ranges::find(kinds, statement.kind) != kinds.end();
    forEachBlock(statement, [&](const syntax::Block& block) {
      found = found || contains(block.statements, kinds);
    });
    return found;
  });
}

bool breaksOut(std::span<const Statement> statements) {
  return std::ranges::any_of(statements, [](const Statement& statement) {
    if (statement.kind == StatementKind::Break) return true;
    if (statement.kind == StatementKind::While || statement.kind == StatementKind::DoUntil)
      return false;
    bool found = false;
    forEachBlock(statement,
                 [&](const syntax::Block& block) { found = found || breaksOut(block.statements); });
    return found;
  });
}

} // namespace proskill::ide
