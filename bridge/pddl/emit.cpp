#include "bridge/pddl/emit.h"

#include "analysis/program/outcomes.h"
#include "bridge/pddl/terms.h"
#include "bridge/text/locate.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::bridge::pddl {
namespace {

/// Declarations shared by domains and problems, so that both use the same names.
class Vocabulary {
public:
  explicit Vocabulary(const analysis::Program& program) : program(program), terms(program, errors) {
    for (const auto& skill : program.skills.all)
      if (!skill->isComposite()) static_cast<void>(idle(skill.name()));
    for (const auto& resource : program.resources.all) static_cast<void>(left(resource.name()));
  }

  /// True while the skill does not run.
  std::string idle(std::string_view skill) {
    return "(" + terms.name(fmt::format("idle {}", skill), fmt::format("{}-is-idle", skill)) + ")";
  }
  /// How many more skills may hold a resource.
  std::string left(std::string_view resource) {
    return "(" + terms.name(fmt::format("left {}", resource), fmt::format("{}-left", resource)) +
           ")";
  }

  const analysis::Program& program;
  Errors errors;
  Terms terms;
};

std::string indented(const std::vector<std::string>& lines, std::size_t depth) {
  std::string text;
  for (const auto& line : lines) text += "\n" + std::string(depth, ' ') + line;
  return text;
}

class DomainWriter {
public:
  DomainWriter(const analysis::Program& program, Outcomes outcomes)
      : program(program), outcomes(outcomes), words(program) {}

  std::string write(const std::string& name) {
    for (const auto& skill : program.skills.all) add(skill);
    for (const auto& event : program.events.all) add(event);
    for (const auto& environment : program.environments.all) {
      note({environment.file, environment->name.range},
           "an environment; events occur when a plan needs them");
      actions += fmt::format("\n  ; environment {}\n", environment.name());
    }
    const bool counts = words.terms.usesNumbers || !program.resources.all.empty();
    return fmt::format(
        "(define (domain {})\n  (:requirements :strips :typing :negative-preconditions\n"
        "    :disjunctive-preconditions :durative-actions :duration-inequalities{})\n"
        "  (:predicates{}\n  )\n{}{})\n",
        name, counts ? " :numeric-fluents" : "", indented(predicates(), 4), functions(), actions);
  }

  Vocabulary& vocabulary() { return words; }
  std::vector<Note> notes;

private:
  /// Once for a place, which may be written for many values of inputs.
  void note(analysis::Location at, std::string_view what) {
    const Note made{placeOf(program, at), fmt::format("not in PDDL: {}", what)};
    if (std::ranges::find(notes, made) == notes.end()) notes.push_back(made);
  }

  std::vector<std::string> predicates() {
    std::vector<std::string> all;
    for (const auto& variable : program.stateVariables.all)
      if (!variable->isNatural())
        for (const auto& state : variable->states)
          all.push_back(fmt::format("{} ; ({} {})", words.terms.has(variable.name(), state.text),
                                    variable.name(), state.text));
    for (const auto& skill : program.skills.all)
      if (!skill->isComposite())
        all.push_back(fmt::format("{} ; {} is idle", words.idle(skill.name()), skill.name()));
    return all;
  }

  std::string functions() {
    std::vector<std::string> all;
    for (const auto& variable : program.stateVariables.all)
      if (variable->isNatural())
        all.push_back(
            fmt::format("{} ; {}", words.terms.function(variable.name()), variable.name()));
    for (const auto& resource : program.resources.all)
      all.push_back(fmt::format("{} ; {} left", words.left(resource.name()), resource.name()));
    return all.empty() ? "" : fmt::format("  (:functions{}\n  )\n", indented(all, 4));
  }

  void add(const analysis::Definition<syntax::Skill>& skill) {
    if (skill->isComposite()) return note({skill.file, skill->name.range}, "a composite skill");
    words.terms.in(skill.file);
    const auto bindings = bindingsOf(program, skill.node());
    if (!bindings)
      words.errors.push_back({placeOf(program, {skill.file, skill->name.range}),
                              "PDDL cannot say this: " + bindings.error()});
    else
      for (const auto& binding : *bindings) addOutcomes(skill, binding);
    words.terms.bind({});
  }

  void addOutcomes(const analysis::Definition<syntax::Skill>& skill, const Binding& binding) {
    words.terms.bind(binding);
    if (skill->successes.empty()) addOutcome(skill, binding, "success", nullptr);
    for (const auto& outcome : skill->successes) addOutcome(skill, binding, "success", &outcome);
    if (outcomes == Outcomes::All)
      for (const auto& outcome : skill->failures) addOutcome(skill, binding, "failure", &outcome);
  }

  void addOutcome(const analysis::Definition<syntax::Skill>& skill, const Binding& binding,
                  std::string_view status, const syntax::Outcome* outcome) {
    const auto tag = outcome ? outcome->tag.text : std::string_view();
    const bool isOnly = analysis::outcomesOf(skill.node()).size() == 1;
    const bool several = skill->successes.size() > 1 || outcomes == Outcomes::All;
    const auto wish = several && !tag.empty() ? fmt::format("{}--{}", skill.name(), tag)
                                              : std::string(skill.name());
    std::string values;
    std::string inputs;
    for (const auto& input : skill->inputs) {
      const auto value = binding.find(input.name.text);
      const auto given = value == binding.end() ? "" : wordOf(value->second);
      if (!given.empty()) values += "-" + given;
      inputs += given.empty() ? fmt::format(" {}:{}", bare(input.name.text), input.type.text)
                              : fmt::format(" {}={}", bare(input.name.text), given);
    }
    const auto name =
        words.terms.name(fmt::format("action {} {}{}", skill.name(), tag, values), wish + values);
    actions += fmt::format(
        "\n  ; skill {} ({}{}{}){}{}\n  (:durative-action {}\n    :parameters ()\n"
        "    :duration {}\n    :condition (and{})\n    :effect (and{}))\n",
        skill.name(), status, tag.empty() ? "" : " ", tag, isOnly ? " only" : "", inputs, name,
        duration(skill.node()), indented(conditions(skill.node(), outcome), 6),
        indented(effects(skill, outcome), 6));
  }

  static std::string wordOf(const syntax::Expr& value) {
    if (value.kind == syntax::ExprKind::Number) return syntax::toString(value.number);
    if (value.kind == syntax::ExprKind::Symbol) return std::string(value.name.text);
    return value.kind == syntax::ExprKind::True ? "true" : "false";
  }

  /// An excluded bound is included, since plans have no infinitely small differences anyway.
  std::string duration(const syntax::Skill& skill) {
    if (!skill.timeInterval) return "(>= ?duration 0)";
    const auto least = fmt::format("(>= ?duration {})", decimal(skill.timeInterval->lower));
    if (!skill.timeInterval->upper) return least;
    return fmt::format("(and {} (<= ?duration {}))", least, decimal(*skill.timeInterval->upper));
  }

  static std::string decimal(const syntax::Rational& number) {
    if (number.denominator == 1) return fmt::format("{}", number.numerator);
    return fmt::format("{:.6f}", static_cast<double>(number.numerator) /
                                     static_cast<double>(number.denominator));
  }

  std::vector<std::string> conditions(const syntax::Skill& skill, const syntax::Outcome* outcome) {
    std::vector<std::string> all{"(at start " + words.idle(skill.name.text) + ")"};
    for (const auto& each : skill.preconditions)
      all.push_back("(at start " + words.terms.condition(each.condition) + ")");
    for (const auto& each : skill.resources)
      all.push_back("(at start (>= " + words.left(each.text) + " 1))");
    for (const auto& each : skill.invariants)
      all.push_back("(over all " + words.terms.condition(each.guard) + ")");
    for (const auto& effect : skill.start.items)
      for (const auto& each : words.terms.allowing(effect))
        all.push_back("(at start " + each + ")");
    if (outcome) addAllowing(skill, outcome->effects, all);
    return all;
  }

  /// What allows the effects at the end must hold all the time, since the platform chooses the end.
  void addAllowing(const syntax::Skill& skill, const syntax::Effects& atEnd,
                   std::vector<std::string>& to) {
    for (const auto& effect : atEnd.items) {
      const bool isSetBefore =
          std::ranges::any_of(skill.start.items, [&](const syntax::Effect& other) {
            return other.variable.text == effect.variable.text;
          });
      for (const auto& each : words.terms.allowing(effect)) {
        if (!isSetBefore) to.push_back("(at start " + each + ")");
        to.push_back("(over all " + each + ")");
      }
    }
  }

  std::vector<std::string> effects(const analysis::Definition<syntax::Skill>& skill,
                                   const syntax::Outcome* outcome) {
    std::vector<std::string> all;
    // A postcondition may repeat effects. Planners take a repeated effect for a conflict.
    const auto at = [&](const char* when, const std::vector<std::string>& some) {
      for (const auto& each : some)
        if (auto effect = fmt::format("(at {} {})", when, each);
            std::ranges::find(all, effect) == all.end())
          all.push_back(std::move(effect));
    };
    const auto resources = [&](const char* word) {
      std::vector<std::string> some;
      for (const auto& each : skill->resources)
        some.push_back(fmt::format("({} {} 1)", word, words.left(each.text)));
      return some;
    };
    at("start", {"(not " + words.idle(skill.name()) + ")"});
    at("start", resources("decrease"));
    at("start", words.terms.effects(skill->start));
    at("end", {words.idle(skill.name())});
    at("end", resources("increase"));
    if (!outcome) return all;
    at("end", words.terms.effects(outcome->effects));
    if (!outcome->postcondition) return all;
    if (const auto made = words.terms.making(*outcome->postcondition))
      at("end", *made);
    else
      note(skill.at(outcome->postcondition->range), "a postcondition that is not a value");
    return all;
  }

  void add(const analysis::Definition<syntax::Event>& event) {
    words.terms.in(event.file);
    std::string guard = event->guard ? words.terms.condition(*event->guard) : "(and)";
    for (const auto& effect : event->effects.items)
      for (const auto& each : words.terms.allowing(effect))
        guard = fmt::format("(and {} {})", guard, each);
    const auto name =
        words.terms.name(fmt::format("event {}", event.name()), std::string(event.name()));
    actions +=
        fmt::format("\n  ; event {}{}\n  (:action {}\n    :parameters ()\n    :precondition {}"
                    "\n    :effect (and{}))\n",
                    event.name(), event->every ? " by itself" : "", name, guard,
                    indented(words.terms.effects(event->effects), 6));
  }

  const analysis::Program& program;
  Outcomes outcomes;
  Vocabulary words;
  std::string actions;
};

/// The facts that are true when a program begins.
std::vector<std::string> initialFacts(Vocabulary& words, std::vector<Note>& notes) {
  std::vector<std::string> all;
  for (const auto& variable : words.program.stateVariables.all) {
    if (!variable->otherInits.empty())
      notes.push_back({placeOf(words.program, variable.at(variable->initRange())),
                       "not in PDDL: several initial values; the first one is taken"});
    if (variable->isNatural())
      all.push_back(fmt::format("(= {} {})", words.terms.function(variable.name()),
                                syntax::toString(variable->init.number)));
    else if (variable->init.name)
      all.push_back(words.terms.has(variable.name(), variable->init.name.text));
    else
      all.push_back(words.terms.has(variable.name(), variable->states.front().text));
  }
  for (const auto& skill : words.program.skills.all)
    if (!skill->isComposite()) all.push_back(words.idle(skill.name()));
  for (const auto& resource : words.program.resources.all)
    all.push_back(
        fmt::format("(= {} {})", words.left(resource.name()),
                    resource->capacity ? syntax::toString(resource->capacity->number) : "1"));
  return all;
}

} // namespace

std::expected<Emitted, Errors> emitDomain(const analysis::Program& program, const std::string& name,
                                          Outcomes outcomes) {
  DomainWriter writer(program, outcomes);
  Emitted emitted{writer.write(name), std::move(writer.notes)};
  auto& errors = writer.vocabulary().errors;
  if (!errors.empty()) return std::unexpected(std::move(errors));
  return emitted;
}

std::expected<Emitted, Errors> emitProblem(const analysis::Program& program,
                                           const std::string& name, const syntax::Expr& goal,
                                           analysis::FileId file) {
  Vocabulary words(program);
  words.terms.in(file);
  Emitted emitted;
  const auto facts = initialFacts(words, emitted.notes);
  emitted.text =
      fmt::format("(define (problem {0}-goal)\n  (:domain {0})\n  (:init{1})\n  (:goal {2}))\n",
                  name, indented(facts, 4), words.terms.condition(goal));
  if (!words.errors.empty()) return std::unexpected(std::move(words.errors));
  return emitted;
}

} // namespace proskill::bridge::pddl
