#include "bridge/rl/emit.h"

#include "bridge/rl/reserved.h"
#include "bridge/text/locate.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace proskill::bridge::rl {
namespace {

using analysis::Definition;
using Kind = syntax::ExprKind;

class Emitter {
public:
  explicit Emitter(const analysis::Program& program) : program(program), named(program) {}

  std::string skillset(const std::string& name) {
    for (const auto& each : program.resources.all)
      fail({each.file, each->name.range}, "a resource with a capacity");
    for (const auto& each : program.stateVariables.all) variable(each);
    for (const auto& each : program.events.all) event(each);
    for (const auto& each : program.skills.all) skill(each);
    for (const auto& each : program.environments.all)
      note({each.file, each->name.range}, "an environment");
    for (const auto& each : program.properties.all)
      note({each.file, each->name.range}, "a property");
    for (const auto& [word, made] : named.renamed())
      notes.push_back({{program.files.front().path, 1, 1},
                       fmt::format("`{}` is a keyword of RL, and becomes `{}`", word, made)});
    std::string types;
    for (const auto& type : used) types += fmt::format("type {}\n", type);
    return fmt::format("{}{}skillset {} {{\n{}}}\n", types, types.empty() ? "" : "\n", name, text);
  }

  Errors errors;
  std::vector<Note> notes;

private:
  void line(int depth, const std::string& words) {
    text += std::string(static_cast<std::size_t>(depth) * 4, ' ') + words + "\n";
  }
  void fail(analysis::Location at, std::string_view what) {
    errors.push_back({placeOf(program, at), fmt::format("RL cannot say this: {}", what)});
  }
  void note(analysis::Location at, std::string_view what) {
    notes.push_back({placeOf(program, at), fmt::format("not in RL: {}", what)});
  }

  void variable(const Definition<syntax::StateVariable>& each) {
    file = each.file;
    if (each->isNatural()) return fail(each.at(each->name.range), "a number");
    if (!each->otherInits.empty()) return fail(each.at(each->init.range), "several initial values");
    line(1, fmt::format("resource {} {{", named(each.name())));
    std::string states;
    for (const auto& state : each->states) states += fmt::format("{} ", named(state.text));
    line(2, fmt::format("state {{ {}}}", states));
    const auto initial = each->init.name ? each->init.name.text : each->states.front().text;
    line(2, fmt::format("initial {}", named(initial)));
    if (each->transitionsKind == syntax::Transitions::Listed) {
      line(2, "transition {");
      for (const auto& move : each->transitions)
        line(3, fmt::format("{} -> {}", named(move.from.text), named(move.to.text)));
      line(2, "}");
    } else {
      line(2, "transition all");
    }
    line(1, "}");
  }

  void event(const Definition<syntax::Event>& each) {
    file = each.file;
    if (each->every) note(each.at(each->every->range), "the time between two events");
    line(1, fmt::format("event {} {{", named(each.name())));
    if (each->guard) line(2, "guard " + condition(*each->guard));
    effects(2, "effect", each->effects);
    line(1, "}");
  }

  void effects(int depth, const char* keyword, const syntax::Effects& all) {
    if (all.items.empty()) return;
    line(depth, fmt::format("{} {{", keyword));
    for (const auto& effect : all.items) {
      const auto* variable = program.stateVariables.find(effect.variable.text);
      if (effect.value.kind != Kind::Symbol || !variable || !isState(*variable, effect.value))
        fail({file, effect.range}, "an effect that is not a state");
      else
        line(depth + 1,
             fmt::format("{} -> {}", named(effect.variable.text), named(effect.value.name.text)));
    }
    line(depth, "}");
  }

  static bool isState(const Definition<syntax::StateVariable>& variable,
                      const syntax::Expr& value) {
    for (const auto& state : variable->states)
      if (state.text == value.name.text) return true;
    return false;
  }

  void skill(const Definition<syntax::Skill>& each) {
    file = each.file;
    if (each->isComposite()) return note(each.at(each->name.range), "a composite skill");
    if (!each->resources.empty())
      return fail(each.at(each->resources.front().range), "a resource with a capacity");
    if (each->unstoppable) fail(each.at(each->name.range), "a skill that must not be stopped");
    if (each->action && !isNamesake(each.node()))
      note(each.at(each->action->range), "an action of another form");
    if (each->timeInterval) note(each.at(each->timeInterval->range), "how long a skill takes");
    line(1, fmt::format("skill {} {{", named(each.name())));
    inputs(each.node());
    for (const auto& it : each->preconditions)
      line(2, fmt::format("precondition {}: {}", named(it.tag.text), condition(it.condition)));
    effects(2, "start", each->start);
    for (const auto& it : each->invariants) {
      line(2, fmt::format("invariant {} {{", named(it.tag.text)));
      line(3, "guard " + condition(it.guard));
      effects(3, "effect", it.effects);
      line(2, "}");
    }
    if (each->interrupt) {
      line(2, "interrupt {");
      line(3, "interrupting false");
      if (each->interrupt->effects.items.empty()) line(3, "effect { }"); // the grammar demands one
      effects(3, "effect", each->interrupt->effects);
      line(2, "}");
    }
    if (each->successes.empty()) line(2, "success done { }");
    outcomes("success", each->successes);
    outcomes("failure", each->failures);
    line(1, "}");
  }

  /// Whether the action has the name of its skill, and the skill's inputs as its arguments.
  static bool isNamesake(const syntax::Skill& skill) {
    const auto& action = *skill.action;
    return action.command.text == skill.name.text &&
           std::ranges::equal(
               action.arguments, skill.inputs, [](const syntax::Expr& argument, const auto& input) {
                 return argument.kind == Kind::Parameter && argument.name.text == input.name.text;
               });
  }

  void inputs(const syntax::Skill& skill) {
    for (const auto& input : skill.inputs) {
      line(2, fmt::format("input {}: {}", named(input.name.text.substr(1)), input.type.text));
      used.insert(std::string(input.type.text));
    }
  }

  void outcomes(const char* keyword, const syntax::List<syntax::Outcome>& all) {
    for (const auto& it : all) {
      line(2, fmt::format("{} {} {{", keyword, it.tag ? named(it.tag.text) : "done"));
      effects(3, "effect", it.effects);
      if (it.postcondition) line(3, "postcondition " + condition(*it.postcondition));
      line(2, "}");
    }
  }

  // --- Conditions, with parentheses around all but comparisons

  std::string joined(const syntax::Expr& expr, std::string_view word) {
    std::string all;
    for (const auto& operand : expr.operands)
      all += (all.empty() ? "" : fmt::format(" {} ", word)) + condition(operand);
    if (all.empty()) return word == "and" ? "true" : "false";
    return "(" + all + ")";
  }

  std::string comparison(std::string_view variable, const syntax::Expr& value,
                         std::string_view word) {
    const auto* known = program.stateVariables.find(variable);
    if (known && value.kind == Kind::Symbol && isState(*known, value))
      return fmt::format("{} {} {}", named(variable), word, named(value.name.text));
    fail({file, value.range}, "a comparison that is not of a state variable with a state");
    return "true";
  }

  std::string equality(const syntax::Expr& expr, std::string_view word) {
    const auto& left = expr.operands.front();
    const auto& right = expr.operands.back();
    const bool isLeft =
        left.kind == Kind::Symbol && program.stateVariables.find(left.name.text) != nullptr;
    return isLeft ? comparison(left.name.text, right, word)
                  : comparison(right.name.text, left, word);
  }

  std::string condition(const syntax::Expr& expr) {
    switch (expr.kind) {
    case Kind::True: return "true";
    case Kind::False: return "false";
    case Kind::Test: return comparison(expr.name.text, expr.operands.front(), "==");
    case Kind::Equal: return equality(expr, "==");
    case Kind::NotEqual: return equality(expr, "!=");
    case Kind::And: return joined(expr, "and");
    case Kind::Or: return joined(expr, "or");
    case Kind::Not: return "(not " + condition(expr.operands.front()) + ")";
    case Kind::Implies: return joined(expr, "=>");
    case Kind::Equivalent: {
      const auto left = condition(expr.operands.front());
      const auto right = condition(expr.operands.back());
      return fmt::format("(({0} => {1}) and ({1} => {0}))", left, right);
    }
    case Kind::Parameter: fail({file, expr.range}, "a test of an input"); return "true";
    case Kind::Less:
    case Kind::LessEqual:
    case Kind::Greater:
    case Kind::GreaterEqual:
    case Kind::Missing:
    case Kind::Number:
    case Kind::Symbol:
    case Kind::String:
    case Kind::Access:
    case Kind::Add:
    case Kind::Subtract:
    case Kind::Running:
    case Kind::Called:
    case Kind::Ended:
    case Kind::Occurs:
    case Kind::At:
    case Kind::Value:
    case Kind::Globally:
    case Kind::Finally:
    case Kind::Next:
    case Kind::Until:
    case Kind::WeakUntil:
    case Kind::Release:
    case Kind::StrongRelease:
      fail({file, expr.range}, "a condition that is not about states");
      return "true";
    }
    std::unreachable();
  }

  const analysis::Program& program;
  const Names named;
  syntax::FileId file = 0;
  std::string text;
  std::set<std::string> used;
};

} // namespace

std::expected<Emitted, Errors> emitSkillset(const analysis::Program& program,
                                            const std::string& name) {
  Emitter emitter(program);
  Emitted emitted{emitter.skillset(name), std::move(emitter.notes)};
  if (!emitter.errors.empty()) return std::unexpected(std::move(emitter.errors));
  return emitted;
}

} // namespace proskill::bridge::rl
