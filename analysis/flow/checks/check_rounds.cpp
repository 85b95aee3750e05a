#include "analysis/flow/checks/checks.h"
#include "analysis/flow/checks/loop_statement.h"
#include "analysis/flow/result/instant_rounds.h"
#include "analysis/flow/result/loops.h"
#include "syntax/diagnostics/codes.h"

#include <fmt/format.h>

/// Finds loops that repeat without time passing, because a call is refused or a wait does not wait.
namespace proskill::analysis::flow {

namespace {

using syntax::Code;

class InstantRounds {
public:
  InstantRounds(Report& report, const Disturbances& others, ProcessId id)
      : report(report), others(others), id(id), process(report.system()[id]) {}

  void check() {
    const auto within = [this](NodeId node) {
      return report.solver.reachable(id, node) && mayTakeNoTime(report.solver, others, id, node);
    };
    for (const std::vector<NodeId>& loop : loopsOf(*process.graph, within))
      if (const auto round = instantRound(report.solver, others, id, loop)) tell(*round);
  }

private:
  void tell(const InstantRound& round) {
    const syntax::Statement& loop = loopStatement(process, round.nodes);
    const Location at = beginOf(report, process, loop);
    Finding finding = round.refusal ? tellRefused(at, *round.refusal) : tellAgain(at, round.wait);
    offerWait(finding, report, process, loop);
  }

  Finding tellRefused(Location at, const InstantRound::Refusal& refusal) {
    const Process& caller = report.system()[refusal.caller];
    const Process& callee = report.system()[caller.actions[refusal.call].target];
    const auto& skill = report.program.skills.all[callee.definition];
    const auto& precondition = skill->preconditions.at(refusal.precondition);
    Finding finding = report.findings.report(Code::RefusedInLoop, at, skill.name());
    finding.related(report.at(refusal.caller, refusal.call),
                    "is refused at once, and called again");
    finding.related(skill.at(precondition.range),
                    fmt::format("while `{}` is false", precondition.tag.text));
    return finding;
  }

  Finding tellAgain(Location at, NodeId wait) {
    const Location condition =
        report.system().at(process, (*process.graph)[wait].conditions.at(0)->range);
    const std::string& text = report.program.files[condition.file].document.text();
    return report.findings
        .report(Code::WaitsOnceInLoop, at,
                std::string_view(text).substr(condition.range.begin, condition.range.length()))
        .related(report.at(id, wait), "goes on at once, and is reached again");
  }

  Report& report;
  const Disturbances& others;
  ProcessId id;
  const Process& process;
};

} // namespace

void checkRounds(Report& report) {
  const Disturbances others(report.system());
  for (ProcessId id = 0; id < report.system().size(); ++id) {
    const Process& process = report.system()[id];
    if (process.graph && process.analysed) InstantRounds(report, others, id).check();
  }
}

} // namespace proskill::analysis::flow
