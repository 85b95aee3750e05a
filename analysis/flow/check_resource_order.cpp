#include "analysis/flow/checks.h"
#include "syntax/codes.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

/// Resources that are asked for while others are held: in different orders by skills that may run
/// at once, or beyond what there is.
namespace proskill::analysis::flow {

namespace {

using syntax::Code;

/// A skill that holds `held` calls something that takes `wanted`.
struct Nesting {
  ProcessId holder = kNoProcess;
  std::size_t held = 0;
  std::size_t wanted = 0;
  Location call;
};

class ResourceOrder {
public:
  explicit ResourceOrder(Report& report) : report(report) {
    for (const auto& skill : report.program.skills.all) {
      std::vector<std::size_t> taken;
      for (const syntax::Name& name : skill->resources)
        if (auto found = report.program.resources.byName.find(name.text);
            found != report.program.resources.byName.end())
          taken.push_back(found->second);
      needs.push_back(std::move(taken));
    }
  }

  void check() {
    for (std::size_t skill = 0; skill < needs.size(); ++skill)
      for (std::size_t held : needs[skill]) follow(skill, held);
    for (std::size_t i = 0; i < nestings.size(); ++i)
      for (std::size_t j = i + 1; j < nestings.size(); ++j) compare(nestings[i], nestings[j]);
  }

private:
  [[nodiscard]] std::int64_t capacity(std::size_t resource) const {
    return report.variables()[report.variables().of(VariableKind::Used, resource)].domain.max();
  }

  /// All calls that the skill or its branches make while it holds the resource.
  void follow(std::size_t skill, std::size_t held) {
    const System& system = report.system();
    ProcessId holder = system.ofSkill(skill);
    if (!system[holder].analysed) return;
    for (ProcessId id = holder; id < system.size() && isOf(skill, id); ++id)
      for (NodeId node = 0; node < system[id].actions.size(); ++node)
        if ((*system[id].graph)[node].kind == NodeKind::Call && report.solver.reachable(id, node))
          followCall(skill, held, id, node);
  }

  [[nodiscard]] bool isOf(std::size_t skill, ProcessId id) const {
    const Process& process = report.system()[id];
    return process.definition == skill &&
           (process.kind == ProcessKind::Skill || process.kind == ProcessKind::Branch);
  }

  void followCall(std::size_t skill, std::size_t held, ProcessId caller, NodeId node) {
    const System& system = report.system();
    ProcessId target = system[caller].actions[node].target;
    if (target == kNoProcess) return;
    Location at = report.at(caller, node);
    forEach(system.activity(target), [&](std::size_t id) {
      const Process& process = system[static_cast<ProcessId>(id)];
      if (process.kind != ProcessKind::Skill) return;
      for (std::size_t wanted : needs[process.definition]) {
        if (wanted != held)
          nestings.push_back({system.ofSkill(skill), held, wanted, at});
        else if (capacity(held) == 1)
          reportNever(held, skill, process.definition, at);
      }
    });
  }

  void reportNever(std::size_t resource, std::size_t holder, std::size_t wanter, Location call) {
    const auto& skills = report.program.skills.all;
    if (!never.insert({resource, holder}).second) return;
    report.findings
        .report(Code::ResourceHeldByCaller, call, report.program.resources.all[resource].name(),
                skills[wanter].name(), skills[holder].name())
        .related(skills[holder].at(placeOf(*skills[holder].node, resource)), "taken here")
        .related(skills[wanter].at(placeOf(*skills[wanter].node, resource)), "wanted here");
  }

  [[nodiscard]] syntax::Range placeOf(const syntax::Skill& skill, std::size_t resource) const {
    std::string_view name = report.program.resources.all[resource].name();
    auto found = std::ranges::find(skill.resources, name, &syntax::Name::text);
    return found == skill.resources.end() ? skill.name.range : found->range;
  }

  void compare(const Nesting& a, const Nesting& b) {
    const System& system = report.system();
    if (a.held != b.wanted || a.wanted != b.held || a.holder == b.holder) return;
    if (capacity(a.held) != 1 || capacity(a.wanted) != 1) return;
    if (!system.concurrent(a.holder).contains(b.holder) ||
        system.exclusive(a.holder).contains(b.holder))
      return;
    if (!told.insert({a.held, b.call.file, b.call.range.begin}).second) return;
    const auto& resources = report.program.resources.all;
    report.findings
        .report(Code::ResourceOrder, b.call, resources[b.wanted].name(), resources[b.held].name())
        .related(a.call, fmt::format("`{}` is taken here while `{}` is held",
                                     resources[a.wanted].name(), resources[a.held].name()));
  }

  Report& report;
  std::vector<std::vector<std::size_t>> needs; ///< of each skill
  std::vector<Nesting> nestings;
  std::set<std::tuple<std::size_t, FileId, syntax::Offset>> told;
  std::set<std::pair<std::size_t, std::size_t>> never; ///< resource and holder
};

} // namespace

void checkResourceOrder(Report& report) { ResourceOrder(report).check(); }

} // namespace proskill::analysis::flow
