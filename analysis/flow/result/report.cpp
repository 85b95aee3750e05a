#include "analysis/flow/result/report.h"

#include <algorithm>
#include <fmt/format.h>

namespace proskill::analysis::flow {

Location definitionOf(const Report& report, VariableId id) {
  const Variable& variable = report.variables()[id];
  const Program& program = report.program;
  if (variable.kind == VariableKind::StateVariable) {
    const auto& definition = program.stateVariables.all[variable.definition];
    return definition.at(definition->name.range);
  }
  if (variable.kind == VariableKind::Used) {
    const auto& definition = program.resources.all[variable.definition];
    return definition.at(definition->name.range);
  }
  const auto& definition = program.skills.all[variable.definition];
  return definition.at(definition->name.range);
}

std::string lineAfter(const Report& report, Location statement) {
  std::string_view text = report.program.files[statement.file].document.text();
  std::size_t line = text.rfind('\n', statement.range.begin);
  std::size_t begin = line == std::string_view::npos ? 0 : line + 1;
  std::string_view before = text.substr(begin, statement.range.begin - begin);
  if (before.find_first_not_of(" \t") != std::string_view::npos) return " ";
  return "\n" + std::string(before);
}

Location withSpaceAround(const Report& report, Location part) {
  const syntax::Document& document = report.program.files[part.file].document;
  std::string_view text = document.text();
  auto isSpace = [&](std::size_t at) { return std::string_view(" \t\r\n").contains(text[at]); };
  auto [begin, end] = part.range;
  while (begin > 0 && isSpace(begin - 1)) --begin;
  if (begin == 0 || text[begin - 1] == '(') {
    while (end < text.size() && isSpace(end)) ++end;
    return {part.file, {begin, end}};
  }
  // what follows must not become part of a preceding comment
  bool comment = std::ranges::any_of(document.comments(), [begin](const syntax::Range& each) {
    return each.begin < begin && begin <= each.end;
  });
  if (comment && !text.substr(end).starts_with('\n')) begin = part.range.begin;
  return {part.file, {begin, end}};
}

State anyState(const Report& report, const Process& process) {
  State state{.reachable = true, .values = {}};
  for (VariableId variable : process.slots.variables())
    state.values.push_back(report.variables()[variable].domain.all());
  return state;
}

State everyState(const Report& report, const Process& process) {
  State state{.reachable = true, .values = {}};
  for (VariableId variable : process.slots.variables())
    state.values.push_back(report.solver.ever(variable));
  return state;
}

void blameSkill(Report& report, std::size_t skill) {
  for (VariableKind kind : {VariableKind::Status, VariableKind::Result})
    report.blamed.insert(report.variables().of(kind, skill));
}

bool isBlamed(const Report& report, const Process& process,
              const std::vector<Condition>& conditions) {
  std::set<Slot> slots;
  for (const Condition& condition : conditions) collectSlots(condition, slots);
  return std::ranges::any_of(
      slots, [&](Slot slot) { return report.blamed.contains(process.slots[slot]); });
}

namespace {

std::set<const syntax::Outcome*> returnedBy(const Report& report, ProcessId skill) {
  std::set<const syntax::Outcome*> returned;
  const Process& process = report.system()[skill];
  for (NodeId node = 0; node < process.actions.size(); ++node)
    if ((*process.graph)[node].kind == NodeKind::Outcome && report.solver.reachable(skill, node))
      returned.insert((*process.graph)[node].outcome);
  return returned;
}

void noteUnreturned(Report& report, std::size_t index) {
  const ProcessId id = report.system().ofSkill(index);
  const syntax::Skill& skill = report.program.skills.all[index].node();
  if (!skill.isComposite() || !report.solver.started(id)) return;
  const auto returned = returnedBy(report, id);
  const VariableId status = report.variables().of(VariableKind::Status, index);
  const VariableId result = report.variables().of(VariableKind::Result, index);
  ValueSet tags;
  for (const auto& [outcomes, ends] : {std::pair(&skill.successes, Status::Success),
                                       std::pair(&skill.failures, Status::Failure)}) {
    bool any = false;
    for (const syntax::Outcome& outcome : *outcomes) {
      const Domain& domain = report.variables()[result].domain;
      const auto tag = domain.numberOf(outcome.tag.text);
      any |= returned.contains(&outcome);
      if (tag && !returned.contains(&outcome)) tags |= domain.saturated({*tag, *tag});
    }
    any |= ends == Status::Success && returned.contains(nullptr);
    if (!any && !outcomes->empty())
      report.unreturned[status] |= ValueSet::of(static_cast<unsigned>(ends));
  }
  if (!tags.empty()) report.unreturned[result] = tags;
}

} // namespace

void noteUnreturned(Report& report) {
  for (std::size_t i = 0; i < report.program.skills.all.size(); ++i) noteUnreturned(report, i);
}

bool dependsOnUnreturned(const Report& report, ProcessId process, NodeId node,
                         const Condition& condition, bool holds) {
  std::set<Slot> slots;
  collectSlots(condition, slots);
  auto mayGoAnotherWay = [&](State state) {
    bool widened = false;
    for (Slot slot : slots) {
      auto missing = report.unreturned.find(report.system()[process].slots[slot]);
      if (missing == report.unreturned.end()) continue;
      state.values[slot] |= missing->second;
      widened = true;
    }
    return widened && (holds ? mayHold(state, condition) : mayFail(state, condition));
  };
  return std::ranges::any_of(report.solver.cases(process, node), mayGoAnotherWay);
}

void addValues(Finding& finding, Report& report, const Process& process, const State& state,
               const std::vector<Condition>& conditions) {
  std::set<Slot> slots;
  for (const Condition& condition : conditions) collectSlots(condition, slots);
  for (Slot slot : slots) {
    VariableId variable = process.slots[slot];
    report.told.insert(variable);
    finding.related(definitionOf(report, variable),
                    fmt::format("`{}` can only be {} there", report.variables().name(variable),
                                report.variables().words(variable, state.values[slot])));
  }
}

} // namespace proskill::analysis::flow
