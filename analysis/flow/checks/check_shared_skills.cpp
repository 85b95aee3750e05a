#include "analysis/flow/checks/checks.h"
#include "syntax/diagnostics/codes.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

/// Finds skills that both the mission and a monitor, or two monitors, call. For parallel branches
/// see analysis/checks/check_parallel.cpp.
namespace proskill::analysis::flow {

namespace {

constexpr std::size_t kMostRelated = 10;

/// Caller of a skill: a skill or a branch that starts with the program. Either all calls of one
/// caller conflict, or none.
struct Caller {
  ProcessId root = kNoProcess;
  ProcessId skill = kNoProcess;
  auto operator<=>(const Caller&) const = default;
};

struct ByPlace {
  bool operator()(const Location& a, const Location& b) const {
    return std::tuple(a.file, a.range.begin) < std::tuple(b.file, b.range.begin);
  }
};

using Places = std::set<Location, ByPlace>;
using Calls = std::map<Caller, std::vector<Location>>;

class SharedSkills {
public:
  explicit SharedSkills(Report& report) : report(report), system(report.system()) {
    for (ProcessId id = 0; id < system.size(); ++id)
      if (system[id].root && system[id].kind == ProcessKind::Skill &&
          system.skill(system[id]).isComposite())
        roots.push_back(id);
  }

  void check() {
    if (roots.size() < 2) return;
    for (ProcessId id = 0; id < system.size(); ++id)
      if (system[id].kind == ProcessKind::Skill && system[id].analysed) checkSkill(id);
  }

private:
  void checkSkill(ProcessId skill) {
    // all callers hold a lock, so the skill is free
    if (system.exclusive(skill).contains(skill)) return;
    const Calls calls = callsOf(skill);
    Places contested;
    for (const auto& [caller, places] : calls) {
      auto mayRun = [&](const auto& other) { return mayBeAtOnce(caller, other.first); };
      if (std::ranges::any_of(calls, mayRun)) contested.insert(places.begin(), places.end());
    }
    if (!contested.empty()) tell(skill, contested);
  }

  [[nodiscard]] Calls callsOf(ProcessId skill) const {
    Calls calls;
    for (const Site& site : system.callers(skill)) {
      const Process& caller = system[site.caller];
      if (!caller.analysed || !report.solver.reachable(site.caller, site.node)) continue;
      const Node& node = (*caller.graph)[site.node];
      for (ProcessId root : roots)
        if (system.activity(root).contains(site.caller))
          calls[{root, skillOf(site.caller)}].push_back(
              system.at(caller, node.statement->head.range));
    }
    return calls;
  }

  [[nodiscard]] bool mayBeAtOnce(const Caller& a, const Caller& b) const {
    return a.root != b.root && a.skill != b.skill && system.concurrent(a.root).contains(b.root) &&
           !system.exclusive(a.skill).contains(b.skill);
  }

  [[nodiscard]] ProcessId skillOf(ProcessId id) const {
    return system.ofSkill(system[id].definition);
  }

  void tell(ProcessId skill, const Places& calls) {
    const auto last = std::prev(calls.end());
    Finding finding =
        report.findings.report(syntax::Code::CallMayWait, *last,
                               report.program.skills.all[system[skill].definition].name());
    std::size_t told = 0;
    for (auto call = calls.begin(); call != last && told < kMostRelated; ++call, ++told)
      finding.related(*call, "may run it at the same time");
  }

  Report& report;
  const System& system;
  std::vector<ProcessId> roots;
};

} // namespace

void checkSharedSkills(Report& report) { SharedSkills(report).check(); }

} // namespace proskill::analysis::flow
