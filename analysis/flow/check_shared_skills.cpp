#include "analysis/flow/checks.h"
#include "syntax/codes.h"

#include <algorithm>
#include <tuple>

/// Skills that are called by more than one of those that start with the program: the mission and
/// the monitors. Parallel branches are the matter of analysis/check_parallel.cpp.
namespace proskill::analysis::flow {

namespace {

constexpr std::size_t kMostRelated = 10;

/// A call, by what starts with the program.
struct Call {
  Site site;
  ProcessId root = kNoProcess;
  Location at;
};

class SharedSkills {
public:
  explicit SharedSkills(Report& report) : report(report), system(report.system()) {
    for (ProcessId id = 0; id < system.size(); ++id)
      if (system[id].root && system[id].kind == ProcessKind::Skill && !system[id].repeats)
        roots.push_back(id);
  }

  void check() {
    if (roots.size() < 2) return;
    for (ProcessId id = 0; id < system.size(); ++id)
      if (system[id].kind == ProcessKind::Skill && system[id].analysed) checkSkill(id);
  }

private:
  void checkSkill(ProcessId skill) {
    // Whoever calls it holds a lock, so that it is free.
    if (system.exclusive(skill).contains(skill)) return;
    const std::vector<Call> calls = callsOf(skill);
    std::vector<Location> contested;
    for (const Call& call : calls) {
      auto mayRun = [&](const Call& other) { return mayBeAtOnce(call, other); };
      if (std::ranges::any_of(calls, mayRun) && std::ranges::count(contested, call.at) == 0)
        contested.push_back(call.at);
    }
    if (!contested.empty()) tell(skill, std::move(contested));
  }

  [[nodiscard]] std::vector<Call> callsOf(ProcessId skill) const {
    std::vector<Call> calls;
    for (const Site& site : system.callers(skill)) {
      const Process& caller = system[site.caller];
      if (!caller.analysed || !report.solver.reachable(site.caller, site.node)) continue;
      const Node& node = (*caller.graph)[site.node];
      for (ProcessId root : roots)
        if (system.activity(root).contains(site.caller))
          calls.push_back({site, root, system.at(caller, node.statement->head.range)});
    }
    return calls;
  }

  [[nodiscard]] bool mayBeAtOnce(const Call& a, const Call& b) const {
    if (a.root == b.root || !system.concurrent(a.root).contains(b.root)) return false;
    const ProcessId first = skillOf(a.site.caller);
    const ProcessId second = skillOf(b.site.caller);
    return first != second && !system.exclusive(first).contains(second);
  }

  [[nodiscard]] ProcessId skillOf(ProcessId id) const {
    return system.ofSkill(system[id].definition);
  }

  void tell(ProcessId skill, std::vector<Location> calls) {
    std::ranges::sort(calls, {},
                      [](const Location& at) { return std::tuple(at.file, at.range.begin); });
    Finding finding =
        report.findings.report(syntax::Code::CallMayWait, calls.back(),
                               report.program.skills.all[system[skill].definition].name());
    calls.pop_back();
    for (std::size_t i = 0; i < std::min(calls.size(), kMostRelated); ++i)
      finding.related(calls[i], "may run it at the same time");
  }

  Report& report;
  const System& system;
  std::vector<ProcessId> roots;
};

} // namespace

void checkSharedSkills(Report& report) { SharedSkills(report).check(); }

} // namespace proskill::analysis::flow
