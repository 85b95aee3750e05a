#include "analysis/flow/checks/checks.h"
#include "analysis/names/walk.h"
#include "syntax/diagnostics/codes.h"

#include <fmt/format.h>
#include <unordered_set>

/// Finds calls of skills that can fail whose outcome the caller never tests.
namespace proskill::analysis::flow {

namespace {

using syntax::Expr;

void collectRead(const Expr& expr, std::unordered_set<std::string_view>& read) {
  if (expr.kind == syntax::ExprKind::Access) read.insert(expr.name.text);
  for (const Expr& operand : expr.operands) collectRead(operand, read);
}

std::unordered_set<std::string_view> skillsRead(const syntax::Block& body) {
  std::unordered_set<std::string_view> read;
  forEachStatement(body, [&](const syntax::Statement& statement) {
    collectRead(statement.condition, read);
    for (const auto& arm : statement.arms)
      if (arm.condition) collectRead(*arm.condition, read);
    for (const auto& argument : statement.arguments) collectRead(argument.value, read);
  });
  return read;
}

/// Calls that are never made, or that have another finding.
std::unordered_set<const syntax::Statement*> silentCalls(const Report& report) {
  std::unordered_set<const syntax::Statement*> silent;
  forEachNode(report, [&](ProcessId id, const Process&, NodeId node, const Node& each) {
    if (report.isExplained(id, node) || !report.solver.reachable(id, node))
      silent.insert(each.statement);
  });
  return silent;
}

/// Whether the skill ever returns a failure.
bool canFail(const Report& report, ProcessId skill) {
  const Process& process = report.system()[skill];
  for (NodeId node = 0; node < process.actions.size(); ++node) {
    const Node& each = (*process.graph)[node];
    if (each.kind == NodeKind::Outcome && !each.success && report.solver.reachable(skill, node))
      return true;
  }
  return false;
}

/// A branch for the user to fill in, which does not change what the skill does.
std::string lookAt(std::string_view callee) {
  return fmt::format("(if (/= {0}.status success) (printf \"{0} has failed\"))", callee);
}

void checkSkill(Report& report, const Definition<syntax::Skill>& skill,
                const std::unordered_set<const syntax::Statement*>& silent) {
  auto read = skillsRead(*skill->body);
  forEachStatement(*skill->body, [&](const syntax::Statement& statement) {
    if (statement.kind != syntax::StatementKind::Call || silent.contains(&statement)) return;
    const auto* callee = report.program.skills.find(statement.name.text);
    if (!callee || (*callee)->failures.empty() || !read.insert(statement.name.text).second) return;
    auto index = report.system().resolver().skill(statement.name.text);
    if (!index || !canFail(report, report.system().ofSkill(*index))) return;
    Location behind = skill.at({statement.range.end, statement.range.end});
    report.findings
        .report(syntax::Code::ResultIgnored, skill.at(statement.head.range), statement.name.text)
        .related(callee->at((*callee)->failures.front().tag.range), "it can fail")
        .fix("test its status", behind,
             lineAfter(report, skill.at(statement.range)) + lookAt(statement.name.text));
  });
}

} // namespace

void checkResults(Report& report) {
  const auto silent = silentCalls(report);
  for (const auto& skill : report.program.skills.all)
    if (skill->body) checkSkill(report, skill, silent);
}

} // namespace proskill::analysis::flow
