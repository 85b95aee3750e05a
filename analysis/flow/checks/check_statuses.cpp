#include "analysis/flow/checks/checks.h"

#include "analysis/names/types.h"
#include "syntax/diagnostics/codes.h"

#include <algorithm>
#include <fmt/format.h>

/// Finds statuses and results that a skill cannot have, and those that are read too early.
namespace proskill::analysis::flow {

namespace {

using syntax::Code;
using syntax::Expr;
using syntax::ExprKind;

class Statuses {
public:
  explicit Statuses(Report& report) : report(report) {}

  void check() {
    forEachReachedNode(
        report, [this](ProcessId process, const Process& self, NodeId nodeId, const Node& each) {
          id = process;
          node = nodeId;
          if (!each.statement) return;
          if (each.statement->kind == syntax::StatementKind::Case)
            return; // a `case` has to name all
          for (const Expr* condition : each.conditions) visit(self, *condition);
          if (each.statement->kind == syntax::StatementKind::Printf)
            for (const auto& argument : each.statement->arguments) print(self, argument.value);
        });
  }

private:
  void visit(const Process& process, const Expr& expr) {
    if ((expr.kind == ExprKind::Equal || expr.kind == ExprKind::NotEqual) &&
        expr.operands.size() == 2) {
      compare(process, expr.operands[0], expr.operands[1]);
      compare(process, expr.operands[1], expr.operands[0]);
    }
    for (const Expr& operand : expr.operands) visit(process, operand);
  }

  void print(const Process& process, const Expr& value) {
    if (value.kind != ExprKind::Access) return;
    if (auto skill = report.system().resolver().skill(value.name.text))
      readTooEarly(process, value, *skill);
  }

  void compare(const Process& process, const Expr& access, const Expr& word) {
    if (access.kind != ExprKind::Access || word.kind != ExprKind::Symbol) return;
    auto skill = report.system().resolver().skill(access.name.text);
    if (!skill) return;
    if (readTooEarly(process, access, *skill)) return;
    if (access.member.text != "status") return;
    if (auto why = whyNever(*skill, word.name.text)) {
      report.explain(id, node);
      const auto& definition = report.program.skills.all[*skill];
      report.findings
          .report(Code::ImpossibleStatus, report.system().at(process, word.range), access.name.text,
                  word.name.text)
          .related(definition.at(definition->name.range), *why);
    }
  }

  /// Whether the skill cannot have been called when its status is read here.
  bool readTooEarly(const Process& process, const Expr& access, std::size_t skill) {
    const Variables& variables = report.variables();
    bool isStatus = access.member.text == "status";
    VariableId variable =
        variables.of(isStatus ? VariableKind::Status : VariableKind::Result, skill);
    auto slot = process.slots.find(variable);
    if (!slot || report.solver.before(id, node).values[*slot] != variables[variable].initial)
      return false;
    if (calledBefore(skill)) return false;
    report.explain(id, node);
    Finding finding = report.findings.report(
        Code::StatusBeforeCall, report.system().at(process, access.range), access.name.text);
    for (const Site& site : report.system().callers(report.system().ofSkill(skill)))
      if (site.caller == id && report.solver.reachable(id, site.node)) {
        finding.related(report.at(id, site.node), "is called here, which does not lead there");
        break;
      }
    return true;
  }

  /// Whether a call of the skill precedes the node. Then it was refused, or another statement is
  /// the cause.
  [[nodiscard]] bool calledBefore(std::size_t skill) const {
    ProcessId callee = report.system().ofSkill(skill);
    const auto& sites = report.system().callers(callee);
    return std::ranges::any_of(sites, [&](const Site& site) {
      if (site.caller == id) return leads(*report.system()[id].graph, site.node, node);
      return report.solver.started(site.caller);
    });
  }

  static bool leads(const Graph& graph, NodeId from, NodeId to) {
    std::vector<bool> seen(graph.nodes.size());
    std::vector<NodeId> next{from};
    while (!next.empty()) {
      NodeId here = next.back();
      next.pop_back();
      for (const Edge& edge : graph[here].edges) {
        if (edge.target == to) return true;
        if (edge.target == kNoNode || seen[edge.target]) continue;
        seen[edge.target] = true;
        next.push_back(edge.target);
      }
    }
    return false;
  }

  /// The reason, for the place of the skill's definition; nullopt if it can have the status.
  [[nodiscard]] std::optional<std::string> whyNever(std::size_t index,
                                                    std::string_view status) const {
    const syntax::Skill& skill = report.program.skills.all[index].node();
    ProcessId process = report.system().ofSkill(index);
    if (status == "failure" && skill.failures.empty()) return "has no `:failure`";
    if (status == "failed_inv" && skill.invariants.empty()) return "has no `:invariant`";
    if (status == "interrupted" && !report.solver.mayBeInterrupted(process) &&
        !report.solver.mayBeStopped(process))
      return skill.interrupt ? "is never interrupted" : "has no `:interrupt`";
    return std::nullopt;
  }

  Report& report;
  ProcessId id = kNoProcess;
  NodeId node = kNoNode;
};

} // namespace

void checkStatuses(Report& report) { Statuses(report).check(); }

} // namespace proskill::analysis::flow
