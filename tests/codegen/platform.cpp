#include "tests/codegen/platform.h"

#include "codegen/plan/mentions.h"
#include "codegen/term/build.h"

#include <algorithm>

namespace proskill::test {
namespace {

using namespace codegen; // NOLINT: short words for building trees
using fiacre::Process;
using fiacre::Statement;
using fiacre::StatementKind;

constexpr std::string_view kPrefix = "Fiacre_";
constexpr std::string_view kTask = "_action_task";

/// Variables that represent a task: 0 idle, 1 running, 2 returned.
std::string phaseOf(std::string_view task) { return std::string(task) + "_phase"; }
std::string resultOf(std::string_view task) { return std::string(task) + "_result"; }
std::string abortOf(std::string_view task) { return std::string(task) + "_abort"; }

std::string skillOf(std::string_view task) {
  return std::string(task.substr(kPrefix.size(), task.size() - kPrefix.size() - kTask.size()));
}

class Closing {
public:
  Closing(const codegen::Model& runtime, const analysis::Program& source)
      : program(runtime.fiacre), source(source), ticks(runtime.unit.denominator) {}

  fiacre::Program close() {
    for (auto& process : program.processes)
      for (auto& from : process.transitions) replace(from.statement);
    addVariables();
    for (const auto& task : program.tasks) program.processes.push_back(platform(task));
    addEnvironment();
    bindAll();
    program.tasks.clear();
    program.externs.clear();
    program.eventPorts.clear();
    return std::move(program);
  }

private:
  fiacre::Component& component() { return program.components[0]; }

  void replace(Statement& statement) {
    for (auto& child : statement.children) replace(child);
    if (statement.kind == StatementKind::Start) {
      statement = sequence({atOnce(), on(equal(name(phaseOf(statement.name)), number(0))),
                            assign(name(abortOf(statement.name)), boolean(false)),
                            assign(name(phaseOf(statement.name)), number(1))});
    } else if (statement.kind == StatementKind::Sync) {
      const auto target = statement.targets[0];
      statement = sequence({atOnce(), on(equal(name(phaseOf(statement.name)), number(2))),
                            assign(name(phaseOf(statement.name)), number(0)),
                            assign(target, name(resultOf(statement.name)))});
    } else if (statement.kind == StatementKind::Assign &&
               statement.values[0].kind == fiacre::ExprKind::Construct) {
      replaceInterruption(statement);
    }
  }

  void replaceInterruption(Statement& statement) {
    const auto function = statement.values[0].name;
    for (const auto& task : program.tasks)
      if (function == std::string(kPrefix) + skillOf(task.name) + "_interrupt_action")
        statement = assign(name(abortOf(task.name)), boolean(true));
  }

  void addVariables() {
    for (const auto& task : program.tasks) {
      auto& variables = component().variables;
      variables.push_back({phaseOf(task.name), rangeType(0, 2), number(0), ""});
      variables.push_back({resultOf(task.name), namedType("skill_result"), name("no_result"), ""});
      variables.push_back({abortOf(task.name), boolType(), boolean(false), ""});
    }
  }

  fiacre::Interval durationOf(const syntax::Skill& skill) const {
    return skill.timeInterval ? inTicks(*skill.timeInterval) : fiacre::Interval{};
  }

  fiacre::Interval inTicks(const syntax::Interval& given) const {
    fiacre::Interval interval;
    const auto ticksOf = [&](syntax::Rational seconds) {
      return seconds.numerator * ticks / seconds.denominator;
    };
    interval.lower = ticksOf(given.lower) + (given.lowerOpen ? 1 : 0);
    if (given.upper) interval.upper = ticksOf(*given.upper) - (given.upperOpen ? 1 : 0);
    return interval;
  }

  Process platform(const fiacre::Task& task) {
    const auto skill = skillOf(task.name);
    const auto& node = source.skills.find(skill)->node();
    const auto give = [&](const std::string& result) {
      return sequence({assign(name(resultOf(task.name)), name(result)),
                       assign(name(phaseOf(task.name)), number(2)), to("idle")});
    };
    std::vector<Statement> returns;
    const auto addOutcome = [&](std::string_view status, std::string_view tag) {
      returns.push_back(sequence({wait(durationOf(node)), give(resultName(skill, status, tag))}));
    };
    for (const auto& outcome : node.successes) addOutcome("success", outcome.tag.text);
    if (node.successes.empty()) addOutcome("success", "");
    for (const auto& outcome : node.failures) addOutcome("failure", outcome.tag.text);
    returns.push_back(sequence(
        {atOnce(), on(name(abortOf(task.name))), give(resultName(skill, "interrupted", ""))}));
    Process process;
    process.name = task.name + "_platform";
    process.states = {{"idle", 0}, {"running", 0}};
    process.transitions = {
        {"idle",
         sequence({atOnce(), on(equal(name(phaseOf(task.name)), number(1))), to("running")}), ""},
        {"running", select(std::move(returns)), ""}};
    return process;
  }

  static std::string resultName(std::string_view skill, std::string_view status,
                                std::string_view tag) {
    auto text = std::string(skill) + "_" + std::string(status);
    if (!tag.empty()) text += "_" + std::string(tag);
    return text;
  }

  void addEnvironment() {
    Process environment;
    environment.name = "platform_environment";
    environment.states = {{"start_", 0}};
    std::vector<Statement> choices;
    for (const auto& event : program.eventPorts) {
      component().ports.push_back(event.port);
      if (const auto* every = everyOf(event.port.name)) {
        component().ports.back().interval = fiacre::Interval{.lower = 0, .upper = 0};
        addEvery(event.port.name, *every);
        continue;
      }
      choices.push_back(synchronise(event.port.name));
    }
    if (!choices.empty())
      environment.transitions = {
          {"start_", sequence({select(std::move(choices)), to("start_")}), ""}};
    program.processes.push_back(std::move(environment));
  }

  /// The event of a port; null if it occurs at any time.
  const syntax::Interval* everyOf(std::string_view port) const {
    for (const auto& event : source.events.all) {
      const bool isIt = port.starts_with(event.name()) &&
                        port.find_first_not_of('_', event.name().size()) == std::string_view::npos;
      if (isIt && event->every) return &*event->every;
    }
    return nullptr;
  }

  void addEvery(const std::string& port, const syntax::Interval& every) {
    Process process;
    process.name = port + "_platform";
    process.states = {{"waits", 0}, {"due", 0}};
    process.transitions = {{"waits", sequence({wait(inTicks(every)), to("due")}), ""},
                           {"due", sequence({synchronise(port), to("waits")}), ""}};
    program.processes.push_back(std::move(process));
  }

  /// Computes the ports and variables of each process again.
  void bindAll() {
    component().instances.clear();
    for (auto& process : program.processes) {
      process.parameters.clear();
      process.ports.clear();
      const auto mentioned = mentionedIn(process);
      fiacre::Instance instance;
      instance.process = process.name;
      for (const auto& variable : component().variables) {
        if (!mentioned.names.contains(variable.name)) continue;
        process.parameters.push_back({variable.name, variable.type, true});
        instance.arguments.push_back(name(variable.name));
        instance.references.push_back(true);
      }
      for (const auto& port : component().ports) {
        if (!mentioned.ports.contains(port.name)) continue;
        process.ports.push_back(port);
        instance.ports.push_back(port.name);
      }
      component().instances.push_back(std::move(instance));
    }
  }

  fiacre::Program program;
  const analysis::Program& source;
  std::int64_t ticks;
};

} // namespace

fiacre::Program withPlatform(const codegen::Model& runtime, const analysis::Program& program) {
  return Closing(runtime, program).close();
}

} // namespace proskill::test
