#include "analysis/flow/checks/checks.h"
#include "analysis/names/walk.h"
#include "syntax/diagnostics/codes.h"

#include <fmt/format.h>
#include <optional>
#include <unordered_map>
#include <utility>

/// Finds unreachable statements, and outcomes that no path through a body returns.
namespace proskill::analysis::flow {

namespace {

using syntax::Block;
using syntax::Code;
using syntax::Statement;
using syntax::StatementKind;

class Unreachable {
public:
  explicit Unreachable(Report& report) : report(report) {
    forEachNode(report, [this](ProcessId id, const Process&, NodeId node, const Node& each) {
      if (each.statement) note(*each.statement, id, node);
    });
  }

  void check() {
    for (const Process& process : report.system().all()) {
      if (!process.analysed || !process.graph || process.kind == ProcessKind::Branch) continue;
      bool isSkill = process.kind == ProcessKind::Skill;
      const auto& skills = report.program.skills.all;
      const auto& environments = report.program.environments.all;
      file = isSkill ? skills[process.definition].file : environments[process.definition].file;
      if (isSkill && skills[process.definition]->body)
        checkBlock(*skills[process.definition]->body);
      if (!isSkill) checkBlock(environments[process.definition]->body);
      if (isSkill) checkOutcomes(skills[process.definition]);
    }
  }

private:
  struct Seen {
    bool reached = false;
    ProcessId process = kNoProcess;
    NodeId node = kNoNode;
  };

  void note(const Statement& statement, ProcessId id, NodeId node) {
    bool reached = report.solver.reachable(id, node);
    Seen& seen = statements.try_emplace(&statement, Seen{reached, id, node}).first->second;
    seen.reached |= reached;
  }

  /// A `do` is reached if its body is.
  [[nodiscard]] bool reached(const Statement& statement) const {
    if (statement.kind == StatementKind::DoUntil && !statement.branches.empty() &&
        !statement.branches.front().statements.empty() &&
        reached(statement.branches.front().statements.front()))
      return true;
    if (const Statement* call = syntax::callOf(statement)) return reached(*call);
    auto found = statements.find(&statement);
    return found == statements.end() || found->second.reached;
  }

  void checkBlock(const Block& block) {
    const Statement* before = nullptr;
    for (const Statement& statement : block.statements) {
      if (!reached(statement)) {
        if (before && reached(*before))
          reportAfter(*before, statement, lastUnreached(block, statement));
      } else {
        for (const auto& arm : statement.arms) checkBlock(arm.body);
        for (const Block& branch : statement.branches) checkBlock(branch);
      }
      before = &statement;
    }
  }

  /// The last statement of a block before one that is reached by other paths.
  [[nodiscard]] const Statement& lastUnreached(const Block& block, const Statement& first) const {
    const Statement* last = &first;
    const Statement* end = block.statements.data() + block.statements.size();
    while (last + 1 != end && !reached(last[1])) ++last;
    return *last;
  }

  void reportAfter(const Statement& before, const Statement& statement, const Statement& last) {
    auto seen = statements.find(&before);
    if (seen != statements.end() && report.isExplained(seen->second.process, seen->second.node))
      return;
    auto reason = whyNothingFollows(before);
    if (!reason) return;
    report.findings.report(Code::UnreachableStatement, {file, statement.range})
        .related({file, before.head.range.empty() ? before.range : before.head.range}, *reason)
        .fix("remove the unreachable statements",
             withSpaceAround(report, {file, {statement.range.begin, last.range.end}}), "");
  }

  /// The reason; nullopt if another finding covers it.
  [[nodiscard]] std::optional<std::string> whyNothingFollows(const Statement& before) const {
    switch (before.kind) {
    case StatementKind::Success:
    case StatementKind::Failure: return "ends the skill here";
    case StatementKind::Goto: return fmt::format("goes on at `{}`", before.name.text);
    case StatementKind::Break: return "leaves the loop here";
    case StatementKind::While:
    case StatementKind::DoUntil: return "this loop never ends";
    case StatementKind::If:
    case StatementKind::Case:
    case StatementKind::Choose: return "no path through this continues";
    case StatementKind::Parallel: return "not all of these branches can end";
    case StatementKind::Race: return "none of these branches can end";
    case StatementKind::Call: return fmt::format("`{}` never returns", before.name.text);
    case StatementKind::Unknown:
    case StatementKind::Interrupt:
    case StatementKind::WaitCondition:
    case StatementKind::WaitTime:
    case StatementKind::Label:
    case StatementKind::Set:
    case StatementKind::Printf:
    case StatementKind::Emit: return std::nullopt;
    }
    std::unreachable();
  }

  /// Outcomes that a statement names are reported at that statement instead.
  void checkOutcomes(const Definition<syntax::Skill>& skill) {
    if (!skill->isComposite()) return;
    auto check = [&](const syntax::List<syntax::Outcome>& outcomes, StatementKind kind) {
      for (const syntax::Outcome& outcome : outcomes)
        if (outcome.tag && !isNamed(*skill->body, kind, outcome.tag.text))
          report.findings.report(Code::OutcomeNeverReturned, skill.at(outcome.tag.range),
                                 skill.name(), outcome.tag.text);
    };
    check(skill->successes, StatementKind::Success);
    check(skill->failures, StatementKind::Failure);
  }

  static bool isNamed(const Block& block, StatementKind kind, std::string_view tag) {
    bool named = false;
    forEachStatement(block, [&](const Statement& statement) {
      named |= statement.kind == kind && statement.name.text == tag;
    });
    return named;
  }

  Report& report;
  std::unordered_map<const Statement*, Seen> statements;
  FileId file = 0;
};

} // namespace

void checkUnreachable(Report& report) { Unreachable(report).check(); }

} // namespace proskill::analysis::flow
