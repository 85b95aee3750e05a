#include "analysis/flow/result/origins.h"

#include <fmt/format.h>

namespace proskill::analysis::flow {

namespace {

constexpr std::size_t kMostOrigins = 3;

} // namespace

Origins::Origins(const Report& report) : report(report), writes(report.variables().size()) {
  forEachReachedNode(report,
                     [this](ProcessId, const Process& process, NodeId node, const Node& each) {
                       if (each.kind != NodeKind::Emit)
                         add(this->report.system().at(process, {}).file, process.actions[node]);
                     });
  const auto& events = report.program.events.all;
  for (std::size_t event = 0; event < events.size(); ++event)
    add(events[event].file, report.system()[report.system().ofEvents()].actions[event]);
}

void Origins::add(FileId file, const Action& action) {
  for (const Assignment& each : action.assignments) {
    if (!each.source || each.value.kind != Term::Kind::Number) continue;
    if (!seen.insert(each.source).second) continue;
    const Domain& domain = report.variables()[each.variable].domain;
    writes[each.variable].push_back(
        {{file, each.source->range}, domain.saturated({each.value.number, each.value.number})});
  }
}

std::vector<Origin> Origins::of(VariableId id, ValueSet values) const {
  std::vector<Origin> origins;
  const Variable& variable = report.variables()[id];
  if (variable.initial.within(values)) {
    const auto& definition = report.program.stateVariables.all[variable.definition];
    origins.push_back(
        {definition.at(definition->initRange()),
         fmt::format("starts as {}", report.variables().words(id, variable.initial))});
  }
  for (const Write& write : writes[id]) {
    if (origins.size() == kMostOrigins) break;
    if (write.to.within(values))
      origins.push_back(
          {write.at, fmt::format("becomes {} here", report.variables().words(id, write.to))});
  }
  return origins;
}

} // namespace proskill::analysis::flow
