#include "analysis/flow/engine/compile.h"

#include "analysis/names/types.h"

#include <map>

namespace proskill::analysis::flow {

namespace {

/// The resources that a skill takes, with amounts.
std::map<std::size_t, std::int64_t> resourcesOf(const System& system, const Process& process) {
  std::map<std::size_t, std::int64_t> taken;
  const auto& table = system.program().resources;
  for (const syntax::Name& name : system.skill(process).resources)
    if (auto found = table.byName.find(name.text); found != table.byName.end())
      ++taken[found->second];
  return taken;
}

const syntax::Event* emittedBy(const System& system, const Node& node) {
  if (node.kind != NodeKind::Emit) return nullptr;
  const auto* event = system.program().events.find(node.statement->name.text);
  return event ? &event->node() : nullptr;
}

const syntax::Effects* effectsOf(const System& system, const Node& node) {
  if (node.kind != NodeKind::Emit) return node.effects;
  const auto* event = emittedBy(system, node);
  return event ? &event->effects : nullptr;
}

/// The variables for the skill itself that its transitions change.
class Bookkeeping {
public:
  Bookkeeping(const System& system, const Process& process, std::vector<Assignment>& assignments)
      : system(system), process(process), assignments(assignments) {}

  void start() { use(Term::Kind::Add); }
  /// The call has reset the outcome of the last run.
  void refused() { set(VariableKind::Called, 0); }
  /// Without a tag there is no result.
  void end(Status status, std::string_view tag) {
    const Domain& tags = system.variables()[of(VariableKind::Result)].domain;
    set(VariableKind::Result, tags.numberOf(tag).value_or(0));
    set(VariableKind::Status, static_cast<std::int64_t>(status));
    set(VariableKind::Called, 0);
    use(Term::Kind::Subtract);
  }

private:
  [[nodiscard]] VariableId of(VariableKind kind) const {
    return system.variables().of(kind, process.definition);
  }
  void set(VariableKind kind, std::int64_t number) {
    assignments.push_back(system.resolver().constant(of(kind), number, process.slots));
  }
  void use(Term::Kind change) {
    for (const auto& [resource, count] : resourcesOf(system, process)) {
      VariableId variable = system.variables().of(VariableKind::Used, resource);
      Assignment taken = system.resolver().constant(variable, count, process.slots);
      Term amount = taken.value;
      const Domain* domain = &system.variables()[variable].domain;
      Term used{.kind = Term::Kind::Variable, .slot = taken.slot.value_or(0), .domain = domain};
      taken.value = taken.slot ? Term{.kind = change, .operands = {used, amount}} : Term{};
      assignments.push_back(std::move(taken));
    }
  }

  const System& system;
  const Process& process;
  std::vector<Assignment>& assignments;
};

void addBookkeeping(const System& system, const Process& process, const Node& node,
                    std::vector<Assignment>& assignments) {
  Bookkeeping keep(system, process, assignments);
  switch (node.kind) {
  case NodeKind::Start: keep.start(); return;
  case NodeKind::Refused: keep.refused(); return;
  case NodeKind::Outcome:
    keep.end(node.success ? Status::Success : Status::Failure,
             node.outcome ? node.outcome->tag.text : kNoResult);
    return;
  case NodeKind::InvariantFailure:
    keep.end(Status::FailedInvariant, node.invariant->tag.text);
    return;
  case NodeKind::Interrupted: keep.end(Status::Interrupted, kNoResult); return;
  case NodeKind::Run:
  case NodeKind::Call:
  case NodeKind::Interrupt:
  case NodeKind::Wait:
  case NodeKind::Delay:
  case NodeKind::Test:
  case NodeKind::Choose:
  case NodeKind::Fork:
  case NodeKind::Set:
  case NodeKind::Emit:
  case NodeKind::Step:
  case NodeKind::Leave:
  case NodeKind::End: return;
  }
}

void compileNode(const System& system, const Process& process, const Node& node, Action& action) {
  const Resolver& resolver = system.resolver();
  for (const syntax::Expr* condition : node.conditions)
    action.conditions.push_back(resolver.condition(*condition, process.slots));
  if (const auto* event = emittedBy(system, node); event && event->guard)
    action.conditions.push_back(resolver.condition(*event->guard, process.slots));
  if (const syntax::Effects* effects = effectsOf(system, node))
    action.assignments = resolver.assignments(*effects, process.slots);
  if (process.kind == ProcessKind::Skill) addBookkeeping(system, process, node, action.assignments);
}

} // namespace

void addReads(const syntax::Effects& effects, const Resolver& resolver, const Variables& variables,
              std::vector<VariableId>& reads) {
  for (const syntax::Effect& effect : effects.items) {
    resolver.addReads(effect.value, reads);
    auto variable = resolver.stateVariable(effect.variable.text);
    if (variable && variables[*variable].restricted) reads.push_back(*variable);
  }
}

void addReads(const System& system, const Process& process, std::vector<VariableId>& reads) {
  const Variables& variables = system.variables();
  for (NodeId id = 0; id < process.graph->nodes.size(); ++id) {
    const Node& node = (*process.graph)[id];
    for (const syntax::Expr* condition : node.conditions)
      system.resolver().addReads(*condition, reads);
    if (const auto* event = emittedBy(system, node); event && event->guard)
      system.resolver().addReads(*event->guard, reads);
    if (node.statement && node.statement->kind == syntax::StatementKind::Printf)
      for (const auto& argument : node.statement->arguments)
        system.resolver().addReads(argument.value, reads);
    if (node.outcome && node.outcome->postcondition)
      system.resolver().addReads(*node.outcome->postcondition, reads);
    if (const syntax::Effects* effects = effectsOf(system, node))
      addReads(*effects, system.resolver(), variables, reads);
    ProcessId target = process.actions[id].target;
    if (node.kind == NodeKind::Interrupt && target != kNoProcess)
      reads.push_back(variables.of(VariableKind::Called, system[target].definition));
  }
  if (process.kind == ProcessKind::Skill)
    for (const auto& [resource, count] : resourcesOf(system, process))
      reads.push_back(variables.of(VariableKind::Used, resource));
}

std::vector<VariableId> writesOf(const System& system, const Process& process) {
  std::vector<VariableId> writes;
  auto add = [&](const syntax::Effects* effects) {
    if (!effects) return;
    for (const syntax::Effect& effect : effects->items)
      if (auto variable = system.resolver().stateVariable(effect.variable.text))
        writes.push_back(*variable);
  };
  if (process.kind == ProcessKind::Events) return writes;
  for (const Node& node : process.graph->nodes) add(effectsOf(system, node));
  if (process.kind == ProcessKind::Skill)
    for (VariableKind kind : {VariableKind::Status, VariableKind::Result, VariableKind::Called})
      writes.push_back(system.variables().of(kind, process.definition));
  if (process.kind == ProcessKind::Skill)
    for (const auto& [resource, count] : resourcesOf(system, process))
      writes.push_back(system.variables().of(VariableKind::Used, resource));
  return writes;
}

void compileEvent(const System& system, Process& process, std::size_t number) {
  const auto& event = system.program().events.all[number];
  Action& action = process.actions[number];
  if (event->guard)
    action.conditions.push_back(system.resolver().condition(*event->guard, process.slots));
  if (system.isFree(number))
    action.assignments = system.resolver().assignments(event->effects, process.slots);
}

void compileActions(const System& system, Process& process) {
  if (process.kind == ProcessKind::Events) {
    for (std::size_t event = 0; event < process.actions.size(); ++event)
      compileEvent(system, process, event);
    return;
  }
  for (NodeId id = 0; id < process.graph->nodes.size(); ++id)
    compileNode(system, process, (*process.graph)[id], process.actions[id]);
}

} // namespace proskill::analysis::flow
