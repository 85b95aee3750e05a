#include "analysis/flow/checks/checks.h"
#include "syntax/diagnostics/codes.h"
#include "syntax/tree/enumerate.h"

#include <algorithm>
#include <deque>
#include <fmt/format.h>
#include <map>

/// Finds resources that are taken while others are held: in different orders by parallel skills, or
/// beyond their capacity.
namespace proskill::analysis::flow {

namespace {

using syntax::Code;

constexpr std::size_t kMostLooks = 2'000'000; ///< limit of steps, which only very large programs
                                              ///< reach

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
    for (const Nesting& nesting : nestings) {
      for (const Nesting* other : known[{nesting.wanted, nesting.held}]) compare(*other, nesting);
      known[{nesting.held, nesting.wanted}].push_back(&nesting);
    }
    addUp();
  }

private:
  [[nodiscard]] std::int64_t capacity(std::size_t resource) const {
    return report.variables()[report.variables().of(VariableKind::Used, resource)].domain.max();
  }

  /// Follows all calls that the skill or its branches make while it holds the resource.
  void follow(std::size_t skill, std::size_t held) {
    const System& system = report.system();
    ProcessId holder = system.ofSkill(skill);
    if (!system[holder].analysed || looks > kMostLooks) return;
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
      if (process.kind != ProcessKind::Skill || ++looks > kMostLooks) return;
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
                skills[wanter].name(), fmt::format("`{}` itself", skills[holder].name()))
        .related(skills[holder].at(placeOf(skills[holder].node(), resource)), "taken here")
        .related(skills[wanter].at(placeOf(skills[wanter].node(), resource)), "wanted here");
  }

  /// Adds up what the callers on a path take of a resource with a capacity.
  void addUp() {
    const System& system = report.system();
    std::vector<std::size_t> order; // callers come before callees
    for (std::size_t skill = 0; skill < needs.size(); ++skill)
      if (system[system.ofSkill(skill)].analysed) order.push_back(skill);
    std::ranges::sort(order, std::ranges::greater(),
                      [&](std::size_t skill) { return system.rank(system.ofSkill(skill)); });
    held.resize(needs.size());
    for (std::size_t skill : order) {
      for (const Site& site : system.callers(system.ofSkill(skill)))
        if (system[site.caller].analysed && report.solver.reachable(site.caller, site.node))
          addCaller(skill, site);
      for (std::size_t resource : needs[skill]) held[skill][resource].push_back(skill);
    }
  }

  void addCaller(std::size_t skill, const Site& site) {
    for (const auto& [resource, holders] : held[report.system()[site.caller].definition]) {
      bool wants = std::ranges::find(needs[skill], resource) != needs[skill].end();
      auto most = static_cast<std::size_t>(capacity(resource));
      if (wants && most > 1 && holders.size() >= most)
        reportBeyond(resource, holders, skill, report.at(site.caller, site.node));
      else if (holders.size() < most && held[skill][resource].size() < holders.size())
        held[skill][resource] = holders;
    }
  }

  void reportBeyond(std::size_t resource, const std::vector<std::size_t>& holders,
                    std::size_t wanter, Location call) {
    const auto& skills = report.program.skills.all;
    auto names =
        holders | std::views::transform([&](std::size_t holder) { return skills[holder].name(); });
    Finding finding = report.findings.report(Code::ResourceHeldByCaller, call,
                                             report.program.resources.all[resource].name(),
                                             skills[wanter].name(), syntax::enumerateNames(names));
    for (std::size_t holder : holders)
      finding.related(skills[holder].at(placeOf(skills[holder].node(), resource)), "taken here");
    finding.related(skills[wanter].at(placeOf(skills[wanter].node(), resource)), "wanted here");
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
  std::vector<std::vector<std::size_t>> needs; ///< by skill
  std::deque<Nesting> nestings;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<const Nesting*>> known;
  std::size_t looks = 0; ///< number of skills examined
  /// By skill: the callers on a path to it that may have taken a resource.
  std::vector<std::map<std::size_t, std::vector<std::size_t>>> held;
  std::set<std::tuple<std::size_t, FileId, syntax::Offset>> told;
  std::set<std::pair<std::size_t, std::size_t>> never; ///< resource and holder
};

} // namespace

void checkResourceOrder(Report& report) { ResourceOrder(report).check(); }

} // namespace proskill::analysis::flow
