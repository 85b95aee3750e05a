#include "analysis/flow/checks/checks.h"
#include "analysis/flow/result/counters.h"
#include "analysis/flow/result/origins.h"
#include "syntax/diagnostics/codes.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <set>

/// Finds forbidden moves of state variables, and naturals that leave their range.
namespace proskill::analysis::flow {

namespace {

using syntax::Code;

constexpr unsigned kMostAlternatives = 4; ///< in a condition written by a fix

/// The possible effects of an assignment in the text, over all its nodes.
struct Assigned {
  VariableId variable = 0;
  std::size_t order = 0; ///< in which the program reaches them
  Location at;
  const syntax::Effect* effect = nullptr;
  const syntax::Statement* set = nullptr; ///< a `set` with no other effect
  bool byEvent = false;
  ValueSet from;
  ValueSet clean;                         ///< of `from`: no move from here is forbidden
  ValueSet broken;                        ///< of `from`: every move from here is forbidden
  std::map<unsigned, ValueSet> forbidden; ///< the forbidden moves
  bool fallsShort = false;
  bool overshoots = false;
};

class Moves {
public:
  explicit Moves(Report& report) : report(report), origins(report), counters(report.system()) {}

  void check() {
    forEachReachedNode(report, [this](ProcessId id, const Process& process, NodeId node,
                                      const Node& each) { visit(id, process, node, each); });
    if (report.system().hasFreeEvents()) visitEvents();
    std::vector<const Assigned*> inOrder;
    for (const auto& [key, assigned] : found) inOrder.push_back(&assigned);
    std::ranges::sort(inOrder, {}, &Assigned::order);
    std::vector<const Assigned*> told;
    for (const Assigned* assigned : inOrder) {
      if (assigned->forbidden.empty()) continue;
      if (follows(*assigned))
        entailed.insert(assigned->variable);
      else
        told.push_back(assigned);
    }
    for (const Assigned* assigned : told) reportForbidden(*assigned);
    for (const Assigned* assigned : inOrder)
      if (assigned->fallsShort || (assigned->overshoots && !staysBelow(assigned->variable)))
        reportRange(*assigned);
  }

private:
  void visit(ProcessId id, const Process& process, NodeId nodeId, const Node& node) {
    for (const Edge& edge : node.edges) {
      if (!edge.sets) continue;
      for (State state : report.solver.cases(id, nodeId)) {
        if (edge.guard != Guard::None)
          refineAll(state, process.actions[nodeId].conditions, edge.guard == Guard::Holds);
        if (state.reachable) add(process, node, process.actions[nodeId], state);
      }
    }
  }

  void add(const Process& process, const Node& node, const Action& action, const State& state) {
    for (const Assignment& each : action.assignments) {
      if (!each.source || !report.variables()[each.variable].restricted || !each.slot) continue;
      bool emits = node.kind == NodeKind::Emit;
      const void* key = emits ? static_cast<const void*>(node.statement) : each.source;
      Location at = report.system().at(process, emits ? node.range : each.source->range);
      Assigned& here = note({key, each.variable}, each, state, at, false);
      if (node.kind == NodeKind::Set && node.effects->items.size() == 1) here.set = node.statement;
    }
  }

  /// An event may occur in any state.
  void visitEvents() {
    const System& system = report.system();
    const Process& process = system[system.ofEvents()];
    const State state = everyState(report, process);
    for (NodeId event = 0; event < process.actions.size(); ++event) {
      State before = state;
      refineAll(before, process.actions[event].conditions, true);
      if (before.reachable) visitEvent(process.actions[event], event, before);
    }
  }

  void visitEvent(const Action& action, NodeId event, const State& state) {
    for (const Assignment& each : action.assignments)
      if (each.slot && report.variables()[each.variable].restricted)
        note({each.source, each.variable}, each, state,
             report.program.events.all[event].at(each.source->range), true);
  }

  Assigned& note(std::pair<const void*, VariableId> key, const Assignment& assignment,
                 const State& state, Location at, bool byEvent) {
    const Variable& variable = report.variables()[assignment.variable];
    Assigned& here = found.try_emplace(key, Assigned{.order = found.size()}).first->second;
    here.variable = assignment.variable;
    here.at = at;
    here.effect = assignment.source;
    here.byEvent = byEvent;
    for (const Move& move : moves(assignment, variable.domain, state)) {
      ValueSet wrong = variable.forbidden(move.from, move.to);
      bool outside = move.mayFallShort || move.mayOvershoot;
      ValueSet one = ValueSet::of(move.from);
      here.from |= one;
      here.fallsShort |= move.mayFallShort;
      here.overshoots |= move.mayOvershoot;
      if (!wrong.empty()) here.forbidden[move.from] |= wrong;
      if (wrong.empty() && !outside) here.clean |= one;
      if (wrong == move.to || move.alwaysOutside) here.broken |= one;
    }
    here.broken = here.broken - here.clean;
    return here;
  }

  /// Whether a certain error explains it: it is a consequence of one, or starts from the same
  /// values.
  bool follows(const Assigned& it) {
    if (it.from != it.broken) return false;
    ValueSet& known = explained[it.variable];
    bool toldBefore = it.from.within(known);
    known |= it.from;
    for (const auto& [index, targets] : it.forbidden) known |= targets;
    return toldBefore;
  }

  void reportForbidden(const Assigned& it) {
    report.told.insert(it.variable);
    ValueSet from;
    ValueSet to;
    for (const auto& [index, targets] : it.forbidden) from |= ValueSet::of(index), to |= targets;
    const Variables& variables = report.variables();
    using Told = syntax::CodeFor<3>;
    const auto code = it.from == it.broken ? Told(Code::ForbiddenMove)
                      : it.byEvent         ? Told(Code::EventMayBeForbidden)
                                           : Told(Code::MayBeForbiddenMove);
    Finding finding = report.findings.report(code, it.at, variables.name(it.variable),
                                             variables.words(it.variable, from),
                                             variables.words(it.variable, to));
    for (const Origin& origin : origins.of(it.variable, from))
      finding.related(origin.at, origin.description);
    bool isWhole = !entailed.contains(it.variable); // otherwise the next forbidden move would
                                                    // appear
    if (from.count() == 1 && to.count() == 1 && isWhole)
      offerTransition(finding, it.variable, from, to);
    offerWait(finding, it);
  }

  /// Offers to wait until the move is allowed, and to move in the same step, if others can change
  /// the variable.
  void offerWait(Finding& finding, const Assigned& it) {
    if (!it.set || !endsWell(it)) return;
    auto condition = conditionFor(it.variable, it.clean);
    if (!condition) return;
    std::string_view effect = std::string_view(report.program.files[it.at.file].document.text())
                                  .substr(it.effect->range.begin, it.effect->range.length());
    finding.fix(fmt::format("wait for {} in the same step", *condition),
                {it.at.file, it.set->range}, fmt::format("(^ {} :effects {})", *condition, effect));
  }

  /// Whether some event leads to a value from which the move is allowed. Events come whatever the
  /// program does; what other skills do may depend on this one.
  [[nodiscard]] bool endsWell(const Assigned& it) const {
    const System& system = report.system();
    if (!system.hasFreeEvents()) return false;
    const Domain& domain = report.variables()[it.variable].domain;
    bool ends = false;
    for (const Action& event : system[system.ofEvents()].actions)
      for (const Assignment& each : event.assignments)
        ends |= each.variable == it.variable && each.value.kind == Term::Kind::Number &&
                domain.saturated({each.value.number, each.value.number}).within(it.clean);
    return ends;
  }

  /// A condition for any of these values; nullopt if it is long or impossible.
  [[nodiscard]] std::optional<std::string> conditionFor(VariableId id, ValueSet values) const {
    if (values.empty()) return std::nullopt;
    const Variable& variable = report.variables()[id];
    const std::string name = report.variables().name(id);
    const unsigned last = variable.domain.size() - 1;
    if (variable.domain.isNumeric()) {
      if (values == ValueSet::firstOf(values.count()))
        return fmt::format("(<= {} {})", name, variable.domain.at(values.count() - 1).last);
      if (values == variable.domain.all() - ValueSet::firstOf(last + 1 - values.count()))
        return fmt::format("(>= {} {})", name, variable.domain.at(last + 1 - values.count()).first);
      return std::nullopt;
    }
    std::string all;
    forEach(values, [&](unsigned value) {
      all += fmt::format(" ({} {})", name, report.variables().words(id, ValueSet::of(value)));
    });
    if (values.count() > kMostAlternatives) return std::nullopt;
    return values.count() == 1 ? all.substr(1) : fmt::format("(or{})", all);
  }

  void offerTransition(Finding& finding, VariableId id, ValueSet from, ValueSet to) {
    const auto& definition = report.program.stateVariables.all[report.variables()[id].definition];
    if (definition->transitions.empty()) return;
    std::string pair = fmt::format("({} {})", report.variables().words(id, from),
                                   report.variables().words(id, to));
    syntax::Offset end = definition->transitions.back().range.end;
    finding.fix(fmt::format("allow the move {}", pair), definition.at({end, end}), " " + pair);
  }

  /// Whether the natural counts something whose number is within its range.
  [[nodiscard]] bool staysBelow(VariableId variable) {
    const auto most = counters.most(variable);
    return most && *most <= report.variables()[variable].domain.max();
  }

  void reportRange(const Assigned& it) {
    const Domain& domain = report.variables()[it.variable].domain;
    using Told = syntax::CodeFor<2>;
    const auto code = it.from == it.broken ? Told(Code::LeavesRange)
                      : it.byEvent         ? Told(Code::EventMayLeaveRange)
                                           : Told(Code::MayLeaveRange);
    std::string limit = it.overshoots ? fmt::format("above {}", domain.max())
                                      : fmt::format("below {}", domain.min());
    if (it.overshoots && it.fallsShort) limit += fmt::format(" or below {}", domain.min());
    Finding finding =
        report.findings.report(code, it.at, report.variables().name(it.variable), limit);
    finding.related(
        definitionOf(report, it.variable),
        fmt::format("can be {} there", report.variables().words(it.variable, it.from - it.clean)));
    for (const Origin& origin : origins.of(it.variable, it.from - it.clean))
      finding.related(origin.at, origin.description);
    offerWait(finding, it);
  }

  Report& report;
  Origins origins;
  Counters counters;
  std::map<std::pair<const void*, VariableId>, Assigned> found;
  std::map<VariableId, ValueSet> explained; ///< values whose forbidden moves were reported
  std::set<VariableId> entailed;            ///< variables with forbidden moves that are
                                            ///< consequences of others
};

} // namespace

void checkMoves(Report& report) { Moves(report).check(); }

} // namespace proskill::analysis::flow
