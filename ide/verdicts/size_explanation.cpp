#include "ide/verdicts/size_explanation.h"

#include "ide/verdicts/verification.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <map>

namespace proskill::ide {

namespace {

using syntax::Expr;

constexpr std::string_view kWatchdog = "watchdog of ";
constexpr std::size_t kMostListed = 3;

/// "`a`, `b`, `c` and 4 more".
std::string quoted(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < kMostListed; ++i)
    text += fmt::format("{}`{}`", i == 0 ? "" : ", ", names[i]);
  if (names.size() > kMostListed) text += fmt::format(" and {} more", names.size() - kMostListed);
  return text;
}

/// Names the parts of a model in the program's terms.
class Parts {
public:
  Parts(const analysis::Program& of, const codegen::Model& with) : program(of), model(with) {
    for (const auto& each : model.provenance.watched) shown.emplace(each.lvalue, each.display);
  }

  /// A location belongs to its actor, a field of a skill to the skill.
  std::string of(const verify::SizeCell& cell) {
    if (cell.isLocation) {
      const auto& origin = model.provenance.origins[cell.process];
      auto name = origin.actor.empty() ? cell.name : origin.actor;
      if (origin.begin < origin.end)
        places.try_emplace(name, analysis::Location{origin.file, {origin.begin, origin.end}});
      return name;
    }
    const auto open = cell.name.find('[');
    const auto close = cell.name.find(']');
    if (cell.name.starts_with("skill[") && close != std::string::npos)
      return threadOf(cell.name.substr(open + 1, close - open - 1));
    const auto found = shown.find(cell.name);
    return found == shown.end() ? cell.name : found->second;
  }

  [[nodiscard]] std::optional<analysis::Location> placeOf(const std::string& name) const {
    if (const auto* variable = program.stateVariables.find(name))
      return variable->at(variable->node().name.range);
    const auto found = places.find(name);
    return found == places.end() ? std::nullopt : std::optional(found->second);
  }

private:
  [[nodiscard]] std::string threadOf(const std::string& index) const {
    std::size_t number = model.threads.size();
    std::from_chars(index.data(), index.data() + index.size(), number);
    return number < model.threads.size() ? model.threads[number] : index;
  }

  const analysis::Program& program;
  const codegen::Model& model;
  std::map<std::string, std::string> shown;
  std::map<std::string, analysis::Location> places;
};

enum class Kind : std::uint8_t { Variable, Skill, Monitor, Watchdog, Branch, Event, Other };

Kind kindOf(const analysis::Program& program, const std::string& part) {
  if (program.stateVariables.find(part)) return Kind::Variable;
  if (const auto* skill = program.skills.find(part))
    return skill->node().monitor ? Kind::Monitor : Kind::Skill;
  if (part.starts_with(kWatchdog)) return Kind::Watchdog;
  if (part.find(" branch ") != std::string::npos) return Kind::Branch;
  return program.events.find(part) ? Kind::Event : Kind::Other;
}

std::string wordsFor(Kind kind) {
  switch (kind) {
  case Kind::Variable: return "all state variables";
  case Kind::Skill: return "all other skills";
  case Kind::Monitor: return "all monitors";
  case Kind::Watchdog: return "all watchdogs";
  case Kind::Branch: return "all parallel branches";
  case Kind::Event: return "all events";
  case Kind::Other: return "the rest";
  }
  return "";
}

bool mentions(const Expr& expr, std::string_view variable) {
  return expr.name.text == variable || std::ranges::any_of(expr.operands, [&](const Expr& each) {
           return mentions(each, variable);
         });
}

/// Sentences about a part, and what would help.
class Advice {
public:
  explicit Advice(const analysis::Program& of) : program(of) {}

  std::vector<std::string> about(const verify::SizePart& part) {
    said.clear();
    switch (kindOf(program, part.name)) {
    case Kind::Variable: ofVariable(part, program.stateVariables.find(part.name)->node()); break;
    case Kind::Monitor: say("It is a monitor, which runs beside everything else."); break;
    case Kind::Skill:
      if (part.clocks > 0) say("Its clock runs beside others.");
      break;
    case Kind::Watchdog: ofWatchdog(part.name.substr(kWatchdog.size())); break;
    case Kind::Branch: say("It runs beside the other branches of its `//` or `race`."); break;
    case Kind::Event:
      if (part.clocks > 0) say("The clock of its `:every` always runs.");
      break;
    case Kind::Other: break;
    }
    return std::move(said);
  }

private:
  void ofVariable(const verify::SizePart& part, const syntax::StateVariable& variable) {
    constexpr std::uint64_t kMany = 5;
    const auto name = variable.name.text;
    if (variable.isNatural() && part.values >= kMany)
      say(isAsked(name)
              ? "A smaller `:max` leaves fewer states."
              : "No property of the program is about its value: a smaller `:max`, or names "
                "for the ranges that skills test, leave fewer states.");
    const auto events = settersOf(name, true);
    if (!events.empty())
      say(fmt::format("{} may change it at any moment: a `:guard`, or an environment, says when. "
                      "`:every` does so, too, but adds a clock.",
                      quoted(events)));
    const auto skills = settersOf(name, false);
    if (events.empty() && !skills.empty())
      say(fmt::format("{} set it: if they always left it with the same value, it would not "
                      "multiply the states after them.",
                      quoted(skills)));
  }

  static bool sets(const syntax::Effects& effects, std::string_view variable) {
    return std::ranges::any_of(effects.items,
                               [&](const auto& it) { return it.variable.text == variable; });
  }

  static bool sets(const syntax::Skill& skill, std::string_view variable) {
    const auto in = [&](const syntax::Outcome& outcome) { return sets(outcome.effects, variable); };
    return sets(skill.start, variable) || std::ranges::any_of(skill.successes, in) ||
           std::ranges::any_of(skill.failures, in);
  }

  /// Events that come at any moment, or skills.
  [[nodiscard]] std::vector<std::string> settersOf(std::string_view variable, bool events) const {
    std::vector<std::string> names;
    if (!events) {
      for (const auto& skill : program.skills.all)
        if (sets(skill.node(), variable)) names.emplace_back(skill.name());
      return names;
    }
    for (const auto& event : program.events.all)
      if (!event->every && !event->guard && sets(event->effects, variable))
        names.emplace_back(event.name());
    return names;
  }

  [[nodiscard]] bool isAsked(std::string_view variable) const {
    return std::ranges::any_of(program.properties.all, [&](const auto& property) {
      return std::ranges::any_of(property->operands,
                                 [&](const Expr& each) { return mentions(each, variable); });
    });
  }

  void ofWatchdog(const std::string& skill) {
    say(fmt::format("It measures the `:time_interval` of `{}`, and its clock runs as long as this "
                    "skill. Without the interval, `--durations` still measures the skill.",
                    skill));
  }

  void say(std::string sentence) { said.push_back(std::move(sentence)); }

  const analysis::Program& program;
  std::vector<std::string> said;
};

} // namespace

std::expected<SizeExplanation, verify::Unsupported>
explainSize(const analysis::Program& program, const codegen::Model& model,
            const std::vector<std::string>& names, verify::Options options) {
  options.limits.seconds = kSecondsOfExplanation;
  options.limits.classes =
      std::min(options.limits.classes.value_or(kClassesOfExplanation), kClassesOfExplanation);
  options.progress = {};
  const auto asked = askedOf(model, names);
  Parts parts(program, model);
  auto counts = verify::explainSize(
      model.fiacre, model.provenance, asked.questions,
      [&](const verify::SizeCell& cell) { return parts.of(cell); },
      [&](const std::string& part) { return wordsFor(kindOf(program, part)); }, options);
  if (!counts) return std::unexpected(counts.error());
  SizeExplanation made{std::move(*counts), {}, {}, {}};
  Advice advice(program);
  for (const auto& part : made.counts.parts)
    made.rows.push_back({part.name, parts.placeOf(part.name), part.values, part.clocks, part.factor,
                         advice.about(part)});
  const auto isAll = [&](const verify::SizePart& kind) { // the factor says nothing
    return kind.factor > 0.999 * static_cast<double>(made.counts.classes);
  };
  for (const auto& kind : made.counts.kinds)
    if (!isAll(kind))
      made.kinds.push_back({kind.name, {}, kind.values, kind.clocks, kind.factor, {}});
  for (const auto i : made.counts.apart) made.apart.push_back(asked.checks[i]->name);
  return made;
}

std::vector<std::string> sizeSummary(const SizeExplanation& explanation) {
  const auto& counts = explanation.counts;
  std::vector<std::string> all;
  if (counts.classes == 0) return {"Nothing was explored: " + counts.stopped + "."};
  const double ofTime = static_cast<double>(counts.classes) / static_cast<double>(counts.states);
  all.push_back(
      counts.complete
          ? fmt::format("There are {} classes that no other includes: {} discrete states, "
                        "{:.1f} combinations of clocks for each.",
                        counts.classes, counts.states, ofTime)
          : fmt::format("There are more classes than are counted here. This is about the "
                        "first {}: {} discrete states, {:.1f} combinations of clocks for "
                        "each. Among all, factors are mostly greater.",
                        counts.classes, counts.states, ofTime));
  if (explanation.rows.empty())
    all.emplace_back("No part multiplies them: they follow each other.");
  if (!explanation.apart.empty())
    all.push_back(
        fmt::format("Explored apart, each with the whole program, and not counted here: {}.",
                    quoted(explanation.apart)));
  return all;
}

} // namespace proskill::ide
