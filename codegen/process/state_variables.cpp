#include "codegen/process/state_variables.h"

#include "codegen/process/skill_frame.h"
#include "codegen/term/effects.h"
#include "codegen/term/linear.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::codegen {
namespace {

using fiacre::Statement;
using Variable = analysis::Definition<syntax::StateVariable>;

void addExact(Context& context, const Variable& variable, const Actor& actor,
              fiacre::Process& process) {
  const auto place = process.origin;
  const bool isAlarmed = context.alarmed.contains(variable.name());
  if (!isAlarmed || !context.isExpanded()) {
    process.states = {{"legal", place}, {"error", place}};
    process.comment += isAlarmed ? "\nTags say where a move is forbidden."
                                 : "\nThe program makes no move that it forbids.";
    return;
  }
  const auto words = context.origins.of(actor, variable->name.range, "has made a forbidden move");
  addState(process, "legal", place,
           sequence({atOnce(), at(words, on(name(context.names.error(variable.name())))),
                     tag(context.names.tag({variable.name(), "forbidden"})), to("error")}));
  process.states.push_back({"error", place});
}

/// The polling automaton of the paper. It may be later than the variable.
class PollingAutomaton {
public:
  PollingAutomaton(Context& context, const Variable& variable, const Actor& actor,
                   fiacre::Process& process)
      : context(context), variable(variable), actor(actor), process(process) {}

  void add() {
    states.of("error", "error");
    // the first state is the initial one
    if (!variable->otherInits.empty()) addBeginning();
    addValue(variable->init.name);
    for (const auto& value : variable->states)
      if (value.text != variable->init.name.text) addValue(value);
    process.states.push_back({"error", process.origin});
  }

private:
  const std::string& stateOf(std::string_view value) { return states.of("value", value); }

  /// At the start of the program, moves to the chosen value.
  void addBeginning() {
    std::vector<Statement> values;
    for (const auto& value : variable->states)
      values.push_back(sequence({on(equal(name(context.names.variable(variable.name())),
                                          name(context.names.value(variable.name(), value.text)))),
                                 to(stateOf(value.text))}));
    addState(process, states.of("before", "before_"), process.origin,
             sequence({synchronise(beginPort(context)), select(std::move(values))}));
  }

  void addValue(const syntax::Name& from) {
    std::vector<Statement> moves;
    for (const auto& value : variable->states)
      if (value.text != from.text) moves.push_back(move(from, value));
    const auto place = context.origins.of(actor, from.range);
    if (moves.empty())
      process.states.push_back({stateOf(from.text), place});
    else
      addState(process, stateOf(from.text), place, sequence({atOnce(), select(std::move(moves))}));
  }

  Statement move(const syntax::Name& from, const syntax::Name& value) {
    const bool allowed = isAllowed(variable.node(), from.text, value.text);
    const auto words = context.origins.of(actor, variable->name.range,
                                          fmt::format("{} from `{}` to `{}`",
                                                      allowed ? "moves" : "makes a forbidden move",
                                                      from.text, value.text));
    const auto current = name(context.names.variable(variable.name()));
    auto go = at(words, to(allowed ? stateOf(value.text) : "error"));
    if (!allowed) go = saying("forbidden transition", std::move(go));
    return sequence({on(equal(current, name(context.names.value(variable.name(), value.text)))),
                     std::move(go)});
  }

  Context& context;
  const Variable& variable;
  const Actor& actor;
  fiacre::Process& process;
  UniqueNames states;
};

fiacre::Expr valueOf(Context& context, const syntax::StateVariable& variable,
                     const syntax::Expr& init) {
  if (variable.isNatural()) return number(init.number.numerator);
  return name(context.names.value(variable.name.text, init.name.text));
}

/// Chooses the initial value of one variable after the other; the last step starts the program.
class InitialChoice {
public:
  explicit InitialChoice(Context& context) : context(context) {
    for (const auto& each : context.program.stateVariables.all)
      if (!each->otherInits.empty()) open.push_back(&each);
  }

  fiacre::Process make() {
    process.name = context.names.process({"initial", "values"});
    process.comment = "Chooses initial values before anything else happens.";
    process.origin = context.origins.of({"start", 0}, {});
    // polling automata read the chosen value
    const bool apart = context.options.automata == StateVariableAutomata::Paper;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const bool isLast = i + 1 == open.size() && !apart;
      std::vector<Statement> all{isLast ? synchronise(beginPort(context)) : atOnce(),
                                 choice(*open[i])};
      if (isLast) addCalls(all);
      all.push_back(to(isLast ? kChosen : i + 1 == open.size() ? "begins" : stateOf(i + 1)));
      addState(process, stateOf(i), process.origin, sequence(std::move(all)));
    }
    if (apart) {
      const auto words = context.origins.of({"start", 0}, {}, "the program begins");
      std::vector<Statement> all{at(words, synchronise(beginPort(context)))};
      addCalls(all);
      all.push_back(to(kChosen));
      addState(process, "begins", process.origin, sequence(std::move(all)));
    }
    process.states.push_back({std::string(kChosen), process.origin});
    return std::move(process);
  }

private:
  static std::string stateOf(std::size_t i) { return fmt::format("choose_{}", i + 1); }

  Statement choice(const Variable& variable) {
    const Actor actor{std::string(variable.name()), variable.file};
    std::vector<Statement> values;
    const auto add = [&](const syntax::Expr& init) {
      auto value = valueOf(context, variable.node(), init);
      const auto words = context.origins.of(
          actor, init.range,
          fmt::format("starts with {}", variable->isNatural()
                                            ? std::to_string(init.number.numerator)
                                            : fmt::format("`{}`", init.name.text)));
      values.push_back(
          at(words, assign(name(context.names.variable(variable.name())), std::move(value))));
    };
    add(variable->init);
    for (const auto& other : variable->otherInits) add(other);
    return select(std::move(values));
  }

  /// Calls the mission and the monitors, which wait until then.
  void addCalls(std::vector<Statement>& all) {
    for (const auto& skill : context.plan.skills)
      if (skill.root)
        all.push_back(assign(context.cellField(skill.name(), "caller"), name("root")));
  }

  Context& context;
  std::vector<const Variable*> open;
  fiacre::Process process;
};

} // namespace

fiacre::Process stateVariableAutomaton(Context& context, const Variable& variable) {
  const Actor actor{std::string(variable.name()), variable.file};
  fiacre::Process process;
  process.name = context.names.process({"sv", variable.name(), "automata"});
  process.origin = context.origins.of(actor, variable->name.range);
  process.comment = context.definitionOf(variable);
  const bool polls =
      context.options.automata == StateVariableAutomata::Paper && !variable->isNatural();
  if (polls)
    PollingAutomaton(context, variable, actor, process).add();
  else
    addExact(context, variable, actor, process);
  return process;
}

fiacre::TypeDeclaration stateVariableType(Context& context, const Variable& variable) {
  fiacre::TypeDeclaration declaration;
  declaration.name = context.names.type(variable.name());
  if (variable->isNatural()) {
    const auto [low, high] = domainOf(variable.node());
    declaration.type = rangeType(low, high);
    return declaration;
  }
  declaration.type.kind = fiacre::TypeKind::Union;
  for (const auto& value : variable->states)
    declaration.type.members.push_back({context.names.value(variable.name(), value.text), {}, ""});
  return declaration;
}

fiacre::Expr initialValue(Context& context, const syntax::StateVariable& variable) {
  return valueOf(context, variable, variable.init);
}

const std::string& beginPort(Context& context) {
  return context.names.foreign({"program", "begins"});
}

fiacre::Process initialChoice(Context& context) { return InitialChoice(context).make(); }

void holdBack(Context& context, fiacre::Process& process) {
  const auto first = process.states.front().name;
  addState(process, "before_", process.origin,
           sequence({synchronise(beginPort(context)), to(first)}));
  std::ranges::rotate(process.states, process.states.end() - 1);
  // some compilers take the state of the first `from` as the initial one
  std::ranges::rotate(process.transitions, process.transitions.end() - 1);
}

} // namespace proskill::codegen
