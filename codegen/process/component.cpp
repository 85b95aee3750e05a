#include "codegen/process/component.h"

#include "analysis/program/stop.h"
#include "codegen/plan/mentions.h"
#include "codegen/process/basic_skill.h"
#include "codegen/process/body_process.h"
#include "codegen/process/composite.h"
#include "codegen/process/environment.h"
#include "codegen/process/invariants.h"
#include "codegen/process/runtime_action.h"
#include "codegen/process/state_variables.h"
#include "codegen/term/inputs.h"
#include "codegen/term/skill_types.h"
#include "syntax/text/quote.h"
#include "syntax/text/utf8.h"
#include "syntax/tree/statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace proskill::codegen {
namespace {

using fiacre::Process;
using fiacre::Program;

class Assembly {
public:
  explicit Assembly(Context& context) : context(context) {}

  Program make() {
    registerResults();
    context.invariantActive = invariantActive(context);
    if (context.invariantActive) program.functions.push_back(*context.invariantActive);
    addProcesses();
    const SkillTypes skills(context);
    program.constants = skills.constants();
    for (const auto& variable : context.program.stateVariables.all)
      program.types.push_back(stateVariableType(context, variable));
    std::ranges::move(skills.types(), std::back_inserter(program.types));
    if (context.isRuntime()) declareRuntime();
    addComponent(skills);
    program.comment = head();
    return std::move(program);
  }

private:
  /// If the result of a skill is read, the type contains all results, whether a process uses them
  /// or not.
  void registerResults() {
    for (const auto& skill : context.plan.skills) {
      if (!skill.resultIsRead) continue;
      const auto add = [&](const auto& tagged, std::string_view status) {
        for (const auto& each : tagged)
          if (each.tag) static_cast<void>(context.result(skill.name(), status, each.tag.text));
      };
      add(skill.skill().successes, "success");
      add(skill.skill().failures, "failure");
      add(skill.skill().invariants, "failed_inv");
    }
  }

  /// Generates the processes. The automata of state variables come first, but are generated last,
  /// since they need to know the forbidden moves.
  void addProcesses() {
    std::vector<Process> others;
    for (const auto& event : context.program.events.all) {
      others.push_back(eventProcess(context, event));
      if (!hasEnvironmentProcess() || comesByItself(context, event.node())) wait(others.back());
    }
    for (const auto& skill : context.plan.skills) {
      analysis::stopIfAsked();
      const WrittenIn scope(context, skill);
      if (!skill.body)
        others.push_back(basicSkill(context, skill));
      else
        std::ranges::move(compositeSkill(context, skill), std::back_inserter(others));
    }
    if (context.plan.hasGeneralCaller() && context.hasEnvironment())
      wait(others.emplace_back(generalCaller(context)));
    if (hasEnvironmentProcess()) wait(others.emplace_back(environmentProcess(context)));
    for (const auto& variable : context.program.stateVariables.all)
      program.processes.push_back(stateVariableAutomaton(context, variable));
    if (context.hasInitialChoice()) program.processes.push_back(initialChoice(context));
    std::ranges::move(others, std::back_inserter(program.processes));
  }

  /// Makes a process wait until initial values have been chosen.
  void wait(Process& process) {
    if (context.hasInitialChoice()) holdBack(context, process);
  }

  void declareRuntime() {
    for (const auto& port : environmentPorts(context)) {
      fiacre::Port event;
      event.name = port;
      program.eventPorts.push_back({std::move(event), context.names.foreign({"c", port})});
    }
    declareActions(context, program);
  }

  // --- The component

  void addComponent(const SkillTypes& skills) {
    fiacre::Component component;
    component.name =
        context.names.process({"main", sanitised(context.program.files[0].path.stem().string())});
    component.variables = variables(skills);
    if (!context.isRuntime()) component.ports = ports();
    if (context.hasInitialChoice()) {
      auto& begins = component.ports.emplace_back();
      begins.name = beginPort(context);
      begins.interval = fiacre::Interval{.lower = 0, .upper = 0};
    }
    if (hasEnvironmentProcess()) {
      program.processes.back().ports = component.ports;
      for (auto& port : program.processes.back().ports) port.interval.reset();
    }
    for (auto& port : everyPorts(context)) component.ports.push_back(std::move(port));
    addActionPorts(component);
    for (auto& process : program.processes) bind(process, component);
    for (const auto& process : program.processes)
      component.instances.push_back(instanceOf(process));
    program.main = component.name;
    program.components.push_back(std::move(component));
  }

  /// Whether the model contains a process for the environment. In execution without one, the
  /// platform reports events.
  [[nodiscard]] bool hasEnvironmentProcess() const {
    return context.isExecuted() ? context.hasEnvironment() && context.plan.environment
                                : context.hasEnvironment();
  }

  void addActionPorts(fiacre::Component& component) {
    const auto add = [&](const std::string& port) { component.ports.emplace_back().name = port; };
    for (const auto& action : context.performed) {
      for (const auto& result : action.results) add(result.port);
      add(action.unknownPort);
      if (!action.stoppedPort.empty()) add(action.stoppedPort);
    }
  }

  std::vector<fiacre::Variable> variables(const SkillTypes& skills) {
    std::vector<fiacre::Variable> all;
    if (!context.plan.skills.empty())
      all.push_back({"skill", namedType("skill_array"), skills.initial(), ""});
    for (const auto& variable : context.program.stateVariables.all)
      all.push_back({context.names.variable(variable.name()),
                     namedType(context.names.type(variable.name())),
                     initialValue(context, variable.node()), ""});
    for (const auto& variable : context.program.stateVariables.all)
      if (context.isExpanded() && context.alarmed.contains(variable.name()))
        all.push_back({context.names.error(variable.name()), boolType(), boolean(false),
                       "a forbidden move was made"});
    for (const auto& resource : context.program.resources.all)
      all.push_back({context.names.used(resource.name()),
                     rangeType(0, context.capacity(resource.name())), number(0), ""});
    for (const auto& skill : context.plan.skills)
      if (skill.branchEnds)
        all.push_back({context.names.outcome(skill.name()), namedType("skill_result"),
                       name("no_result"), "how a branch has ended the skill"});
    addOwnOutcomes(all);
    std::ranges::move(inputVariables(context), std::back_inserter(all));
    return all;
  }

  void addOwnOutcomes(std::vector<fiacre::Variable>& all) {
    const auto add = [&](const auto& of, std::string_view field, std::string_view type,
                         std::string_view initial) {
      all.push_back({context.names.own(of.first, of.second, field), namedType(type), name(initial),
                     fmt::format("of the last call of {} by {}", of.second, of.first)});
    };
    for (const auto& [of, kept] : context.plan.ownOutcomes.all()) {
      if (kept.status) add(of, "status", "skill_status", "no_status");
      if (kept.result) add(of, "val", "skill_result", "no_result");
    }
  }

  /// The ports. Events of the program's own environment are urgent.
  std::vector<fiacre::Port> ports() {
    std::vector<fiacre::Port> all;
    for (const auto& name : environmentPorts(context)) {
      fiacre::Port port;
      port.name = name;
      if (hasEnvironmentProcess() && context.plan.environment)
        port.interval = fiacre::Interval{.lower = 0, .upper = 0};
      all.push_back(std::move(port));
    }
    return all;
  }

  /// Passes the variables and ports that a process mentions.
  static void bind(Process& process, const fiacre::Component& component) {
    const auto mentioned = mentionedIn(process);
    for (const auto& variable : component.variables)
      if (mentioned.names.contains(variable.name))
        process.parameters.push_back({variable.name, variable.type, true});
    if (!process.ports.empty()) return;
    for (auto port : component.ports)
      if (mentioned.ports.contains(port.name)) {
        port.interval.reset();
        process.ports.push_back(std::move(port));
      }
  }

  static fiacre::Instance instanceOf(const Process& process) {
    fiacre::Instance instance;
    instance.process = process.name;
    for (const auto& port : process.ports) instance.ports.push_back(port.name);
    for (const auto& parameter : process.parameters) {
      instance.arguments.push_back(name(parameter.name));
      instance.references.push_back(true);
    }
    return instance;
  }

  // --- The head of the file

  [[nodiscard]] std::string head() const {
    const auto file = syntax::printable(context.program.files[0].path.filename().string());
    std::string text = file + ": " + edition() + ".\n";
    text += fmt::format("One unit of time is {} s.", toString(context.times.unit()));
    if (context.plan.mission)
      text += fmt::format("\nThe mission is {}.", context.plan.mission->name());
    for (const auto& renaming : context.names.renamings())
      text += fmt::format("\n`{}` is `{}` here: its own name is taken or reserved.",
                          renaming.preferred, renaming.name);
    if (context.isPerformed()) text += argumentsText();
    return text;
  }

  /// `move 2: (move 1.5)`: the action of `move` if its `ArgIndex` is 2.
  [[nodiscard]] std::string argumentsText() const {
    std::string text;
    for (const auto& call : context.arguments.actions()) {
      text += fmt::format("\n{} {}: ({}", call.skill, call.number, call.command);
      for (const auto& argument : call.arguments)
        text += " " + (argument.empty() ? std::string("?") : argument);
      text += ")";
    }
    return text.empty() ? text : "\nThe action of a skill, by its ArgIndex:" + text;
  }

  [[nodiscard]] std::string edition() const {
    switch (context.options.edition) {
    case Edition::Compact: return "a model for verification, compact";
    case Edition::Expanded: return "a model for verification, every state named";
    case Edition::Tina: return "a model for Tina";
    case Edition::Runtime: return "a program for the executor, in H-Fiacre";
    case Edition::Executed: return "the model that `proskill run` executes";
    }
    std::unreachable();
  }

  Context& context;
  Program program;
};

} // namespace

Program buildProgram(Context& context) { return Assembly(context).make(); }

Places placesOf(const Program& program) {
  Places places;
  std::uint32_t place = 0;
  for (const auto& instance : program.components.back().instances)
    places.emplace(instance.process, ++place);
  return places;
}

std::map<std::string, Obliged> obligedProcesses(Context& context) {
  const auto isOpen = [](const std::optional<syntax::Interval>& interval) {
    return !interval || !interval->upper;
  };
  const auto waitsOpenly = [&](const BodyState& state) {
    return state.statement && syntax::hasDuration(*state.statement) &&
           !state.statement->duration.upper;
  };
  std::map<std::string, Obliged> all;
  for (const auto& skill : context.plan.skills) {
    if (!skill.body) {
      if (isOpen(skill.skill().timeInterval))
        all.emplace(context.names.process({"skill", skill.name()}),
                    Obliged{std::string(skill.name()), syntax::backquoted(skill.name())});
      continue;
    }
    forEachThread(*skill.body, [&](const BodyAutomaton& thread) {
      if (std::ranges::any_of(thread.states, waitsOpenly))
        all.emplace(
            processOf(context, skill, thread),
            Obliged{std::string(skill.name()), "a wait of " + syntax::backquoted(skill.name())});
    });
  }
  return all;
}

} // namespace proskill::codegen
