#include "codegen/process/state_variables.h"

#include "codegen/process/skill_frame.h"
#include "codegen/term/effects.h"
#include "codegen/term/linear.h"

#include <fmt/format.h>

namespace proskill::codegen {
namespace {

using fiacre::Statement;
using Variable = analysis::Definition<syntax::StateVariable>;

void addExact(Context& context, const Variable& variable, const Actor& actor,
              fiacre::Process& process) {
  const auto place = process.origin;
  if (!context.alarmed.contains(variable.name())) {
    process.states = {{"legal", place}, {"error", place}};
    process.comment += "\nNothing that the program does is forbidden to it.";
    return;
  }
  const auto words = context.origins.of(actor, variable->name.range, "has made a forbidden move");
  std::vector<Statement> alarm{atOnce(), at(words, on(name(context.names.error(variable.name()))))};
  if (context.isExpanded()) alarm.push_back(tag(context.names.tag({variable.name(), "forbidden"})));
  alarm.push_back(to("error"));
  addState(process, "legal", place, sequence(std::move(alarm)));
  process.states.push_back({"error", place});
}

/// The polling automaton: it may lag behind the variable, as the paper's does.
class PollingAutomaton {
public:
  PollingAutomaton(Context& context, const Variable& variable, const Actor& actor,
                   fiacre::Process& process)
      : context(context), variable(variable), actor(actor), process(process) {}

  void add() {
    states.of("error", "error");
    // The first state is the initial one.
    addValue(variable->init.name);
    for (const auto& value : variable->states)
      if (value.text != variable->init.name.text) addValue(value);
    process.states.push_back({"error", process.origin});
  }

private:
  const std::string& stateOf(std::string_view value) { return states.of("value", value); }

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
  if (variable.isNatural()) return number(variable.init.number.numerator);
  return name(context.names.value(variable.name.text, variable.init.name.text));
}

} // namespace proskill::codegen
