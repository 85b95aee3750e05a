#include "runtime/platform/ros1.h"

#include "runtime/platform/json.h"
#include "runtime/platform/messages.h"
#include "runtime/platform/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace proskill::runtime {

namespace {

constexpr std::array kTerminalStates{"succeeded", "aborted", "rejected", "preempted", "recalled"};

/// An error about a skill, which is shown at the skill.
struct WrongSkill {
  std::string why;
  std::string skill;
};

/// A name, a type or a path: a string that is not empty.
const std::string& wordAt(const Json& value, const std::string& key, const std::string& of) {
  if (!value.contains(key)) throw Wrong{of + ": `" + key + "` is missing"};
  const auto& word = stringAt(value, key);
  if (word.empty()) throw Wrong{of + ": `" + key + "` must not be empty"};
  return word;
}

/// `package/Type`
const std::string& typeAt(const Json& value, const std::string& of) {
  const auto& type = wordAt(value, "type", of);
  const auto slash = type.find('/');
  if (slash == 0 || slash == std::string::npos || slash + 1 == type.size())
    throw Wrong{of + ": the type `" + type + "` must have the form package/Type"};
  return type;
}

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const auto& name : names) all += (all.empty() ? "`" : ", `") + name + "`";
  return all;
}

/// Reads `below`, `above` and `equals` of a case.
Json conditionOf(const Json& value, const std::string& of) {
  Json condition = Json::object();
  for (const char* bound : {"below", "above"}) {
    if (!value.contains(bound)) continue;
    if (!value[bound].is_number()) throw Wrong{of + ": `" + bound + "` must be a number"};
    condition[bound] = value[bound];
  }
  if (!value.contains("equals")) return condition;
  if (!value["equals"].is_primitive() || value["equals"].is_null())
    throw Wrong{of + ": `equals` must be a number, a string, true or false"};
  condition["equals"] = value["equals"];
  return condition;
}

class Ros1Reader {
public:
  Ros1Reader(const analysis::Program& of, const Executable& with) : program(of), executable(with) {}

  /// \return the mapping in terms of the protocol: positions of arguments, names of events
  Json platform(const Json& file) {
    allowMembers(file,
                 {"kind", "$schema", "node", "patience", "actions", "variables", "events", "python",
                  "startup", "restarts", "restart_delay"},
                 "the platform");
    Json made{{"node", "proskill"},
              {"patience", 5.0},
              {"actions", Json::object()},
              {"sensors", Json::array()}};
    if (file.contains("node")) made["node"] = nodeOf(file);
    if (file.contains("patience")) made["patience"] = inSeconds(file["patience"], "patience");
    for (const auto& [skill, value] : objectAt(file, "actions"))
      made["actions"][skill] = action(performedNamed(skill), value);
    for (const auto& performed : executable.model.performed)
      if (!made["actions"].contains(performed.skill))
        throw WrongSkill{"the platform file has no action for `" + performed.skill + "`",
                         performed.skill};
    for (const auto& [name, value] : objectAt(file, "variables"))
      made["sensors"].push_back(variable(name, value));
    for (const auto& [name, value] : objectAt(file, "events"))
      made["sensors"].push_back(event(name, value));
    return made;
  }

private:
  using Performed = codegen::Performed;

  static std::string nodeOf(const Json& file) {
    const auto& node = wordAt(file, "node", "the platform");
    const auto isLetter = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    };
    if (!std::ranges::all_of(node, isLetter) || std::isdigit(static_cast<unsigned char>(node[0])))
      throw Wrong{"`node` must be a name of letters, digits and _"};
    return node;
  }

  static double inSeconds(const Json& value, const std::string& of) {
    return static_cast<double>(secondsOf(value, of)) / static_cast<double>(kSecond);
  }

  [[nodiscard]] const Performed& performedNamed(const std::string& name) const {
    const auto& all = executable.model.performed;
    const auto found = std::ranges::find(all, name, &Performed::skill);
    if (found != all.end()) return *found;
    std::vector<std::string> names;
    for (const auto& each : all) names.push_back(each.skill);
    throwUnknown("basic skill", name, names);
  }

  // --- Actions

  [[nodiscard]] Json action(const Performed& performed, const Json& value) const {
    const auto of = "`" + performed.skill + "`";
    if (!value.is_object()) throw Wrong{of + " must be an object"};
    if (value.contains("service")) return service(performed, value, of);
    if (value.contains("topic")) return topic(performed, value, of);
    if (!value.contains("action")) throw Wrong{of + ": `action`, `service` or `topic` is missing"};
    allowMembers(value, {"action", "type", "goal", "results"}, of);
    return {{"kind", "action"},
            {"name", wordAt(value, "action", of)},
            {"type", typeAt(value, of)},
            {"fields", fields(performed, value, "goal")},
            {"results", terminalStates(performed, value, of)}};
  }

  [[nodiscard]] Json service(const Performed& performed, const Json& value,
                             const std::string& of) const {
    allowMembers(value, {"service", "type", "request", "results"}, of);
    if (!value.contains("results")) throw Wrong{of + ": `results` is missing"};
    return {{"kind", "service"},
            {"name", wordAt(value, "service", of)},
            {"type", typeAt(value, of)},
            {"fields", fields(performed, value, "request")},
            {"results", resultCases(performed, value["results"], of)}};
  }

  [[nodiscard]] Json topic(const Performed& performed, const Json& value,
                           const std::string& of) const {
    allowMembers(value, {"topic", "type", "message", "result"}, of);
    return {{"kind", "topic"},
            {"name", wordAt(value, "topic", of)},
            {"type", typeAt(value, of)},
            {"fields", fields(performed, value, "message")},
            {"result", value.contains("result") ? result(performed, stringAt(value, "result"))
                                                : onlyResult(performed, "success", of)}};
  }

  /// Fields of a message by their paths: literals, and `$name` for an argument of the action.
  [[nodiscard]] Json fields(const Performed& performed, const Json& value,
                            const std::string& key) const {
    Json all = Json::array();
    for (const auto& [path, given] : objectAt(value, key)) {
      if (!given.is_primitive() || given.is_null())
        throw Wrong{fmt::format("`{}.{}.{}` must be a number, a string, true or false",
                                performed.skill, key, path)};
      Json one{{"path", path}};
      if (given.is_string() && given.get_ref<const std::string&>().starts_with('$'))
        setArgument(one, performed, given.get_ref<const std::string&>());
      else
        one["value"] = given;
      all.push_back(std::move(one));
    }
    return all;
  }

  void setArgument(Json& field, const Performed& performed, const std::string& name) const {
    const auto& skill = program.skills.find(performed.skill)->node();
    std::vector<std::string> names;
    if (skill.action) {
      for (std::size_t i = 0; i < skill.action->arguments.size(); ++i) {
        const auto& argument = skill.action->arguments[i];
        if (argument.kind != syntax::ExprKind::Parameter) continue;
        names.emplace_back(argument.name.text);
        if (names.back() != name) continue;
        field["argument"] = i;
        field["type"] = typeOf(skill, name);
        return;
      }
    }
    throwUnknown("argument of the action of `" + performed.skill + "`", name, names);
  }

  static std::string typeOf(const syntax::Skill& skill, const std::string& parameter) {
    for (const auto& input : skill.inputs)
      if (input.name.text == parameter) return std::string(input.type.text);
    return "";
  }

  // --- Results

  [[nodiscard]] std::string result(const Performed& performed, const std::string& name) const {
    std::vector<std::string> names;
    for (const auto& each : performed.results) names.push_back(resultName(each));
    if (std::ranges::find(names, name) == names.end())
      throwUnknown("result of `" + performed.skill + "`", name, names);
    return name;
  }

  static std::string onlyResult(const Performed& performed, const std::string& status,
                                const std::string& of) {
    std::vector<std::string> names;
    for (const auto& each : performed.results)
      if (each.status == status) names.push_back(resultName(each));
    if (names.size() != 1)
      throw Wrong{of + ": which " + status + " it is must be said: " + joined(names)};
    return names.front();
  }

  /// By terminal state of a goal. Without `results` a success is the only success, and the rest
  /// the only failure.
  [[nodiscard]] Json terminalStates(const Performed& performed, const Json& value,
                                    const std::string& of) const {
    Json all = Json::object();
    for (const auto& [state, given] : objectAt(value, "results")) {
      if (std::ranges::find(kTerminalStates, state) == kTerminalStates.end())
        throwUnknown("terminal state", state, {kTerminalStates.begin(), kTerminalStates.end()});
      all[state] = resultCases(performed, given, of);
    }
    if (!all.contains("succeeded"))
      all["succeeded"] = Json::array({{{"result", onlyResult(performed, "success", of)}}});
    const auto failures =
        std::ranges::count(performed.results, "failure", &Performed::Result::status);
    for (const char* state : {"aborted", "rejected"})
      if (!all.contains(state) && failures == 1)
        all[state] = Json::array({{{"result", onlyResult(performed, "failure", of)}}});
    return all;
  }

  /// A result, or a list of cases, of which the first that holds counts.
  [[nodiscard]] Json resultCases(const Performed& performed, const Json& value,
                                 const std::string& of) const {
    if (value.is_string())
      return Json::array({{{"result", result(performed, value.get<std::string>())}}});
    Json all = Json::array();
    for (const auto& each : listOf(value, of + ".results")) {
      allowMembers(each, {"field", "below", "above", "equals", "result"}, "a result of " + of);
      auto made = conditionOf(each, of);
      if (!made.empty()) made["field"] = wordAt(each, "field", of);
      if (made.empty() && each.contains("field"))
        throw Wrong{of + ": a `field` without `below`, `above` or `equals`"};
      made["result"] = result(performed, wordAt(each, "result", of));
      all.push_back(std::move(made));
    }
    if (all.empty()) throw Wrong{of + ": a list of results must not be empty"};
    return all;
  }

  // --- Sensors

  /// What variables and events have in common.
  static Json sensor(const std::string& name, const Json& value) {
    const auto of = "`" + name + "`";
    Json made{{"name", name},
              {"topic", wordAt(value, "topic", of)},
              {"type", typeAt(value, of)},
              {"field", wordAt(value, "field", of)},
              {"hysteresis", 0.0},
              {"timeout", nullptr},
              {"silent", nullptr}};
    if (value.contains("hysteresis")) {
      const auto& width = value["hysteresis"];
      if (!width.is_number() || width.get<double>() < 0)
        throw Wrong{of + ": `hysteresis` must be a number that is not negative"};
      made["hysteresis"] = width;
    }
    if (value.contains("timeout")) made["timeout"] = inSeconds(value["timeout"], name + ".timeout");
    if (value.contains("timeout") && made["timeout"] == 0.0)
      throw Wrong{of + ": `timeout` must be more than 0 s"};
    if (value.contains("timeout") != value.contains("silent"))
      throw Wrong{of + ": `timeout` and `silent` belong together"};
    return made;
  }

  [[nodiscard]] Json variable(const std::string& name, const Json& value) const {
    const auto of = "`" + name + "`";
    allowMembers(value, {"topic", "type", "field", "hysteresis", "timeout", "silent", "values"},
                 of);
    const auto* definition = program.stateVariables.find(name);
    if (!definition) throwUnknown("state variable", name, variableNames());
    if (definition->node().isNatural()) throw Wrong{of + " is a number; only values can be mapped"};
    auto made = sensor(name, value);
    if (value.contains("silent"))
      made["silent"] = eventThatSets(*definition, stringAt(value, "silent"));
    made["cases"] = Json::array();
    if (!value.contains("values")) throw Wrong{of + ": `values` is missing"};
    for (const auto& each : listOf(value["values"], name + ".values")) {
      allowMembers(each, {"value", "below", "above", "equals"}, "a value of " + of);
      auto one = conditionOf(each, of);
      one["event"] = eventThatSets(*definition, wordAt(each, "value", of));
      made["cases"].push_back(std::move(one));
    }
    rejectUnreachable(made["cases"], of);
    return made;
  }

  /// The first case without a condition is always taken.
  static void rejectUnreachable(const Json& cases, const std::string& of) {
    if (cases.empty()) throw Wrong{of + ": `values` must not be empty"};
    for (std::size_t i = 0; i + 1 < cases.size(); ++i)
      if (cases[i].size() == 1)
        throw Wrong{of + ": the values after the one without a condition are never reached"};
  }

  [[nodiscard]] Json event(const std::string& name, const Json& value) const {
    const auto of = "`" + name + "`";
    allowMembers(value, {"topic", "type", "field", "hysteresis", "below", "above", "equals"}, of);
    requireEvent(name);
    auto made = sensor(name, value);
    auto condition = conditionOf(value, of);
    if (condition.empty()) throw Wrong{of + ": `below`, `above` or `equals` is missing"};
    condition["event"] = name;
    made["cases"] = Json::array({std::move(condition)});
    return made;
  }

  void requireEvent(const std::string& name) const {
    std::vector<std::string> names;
    for (const auto& event : program.events.all) names.emplace_back(event.name());
    if (std::ranges::find(names, name) == names.end()) throwUnknown("event", name, names);
  }

  /// The event whose only effect is that the variable gets this value.
  [[nodiscard]] std::string
  eventThatSets(const analysis::Definition<syntax::StateVariable>& variable,
                const std::string& value) const {
    std::vector<std::string> values;
    for (const auto& state : variable->states) values.emplace_back(state.text);
    const auto name = std::string(variable.name());
    if (std::ranges::find(values, value) == values.end())
      throwUnknown("value of `" + name + "`", value, values);
    for (const auto& event : program.events.all) {
      const auto& effects = event->effects.items;
      if (effects.size() == 1 && effects[0].variable.text == name &&
          effects[0].value.name.text == value)
        return std::string(event.name());
    }
    throw Wrong{"no event sets `" + name + "` to `" + value + "`: add (defevent " + name + "_" +
                value + " :effects (" + name + " " + value + "))"};
  }

  [[nodiscard]] std::vector<std::string> variableNames() const {
    std::vector<std::string> names;
    for (const auto& variable : program.stateVariables.all) names.emplace_back(variable.name());
    return names;
  }

  const analysis::Program& program;
  const Executable& executable;
};

} // namespace

std::optional<Unusable> readRos1Platform(std::string_view text, const analysis::Program& program,
                                         const Executable& executable, ProcessSettings& settings) {
  try {
    const auto file = parsedFile(text);
    auto mapping = Ros1Reader(program, executable).platform(file);
    readLife(file, settings);
    mapping["startup"] = static_cast<double>(settings.startup) / static_cast<double>(kSecond);
    settings.settings = mapping.dump();
    const bool chosen = file.contains("python");
    settings.command = {chosen ? wordAt(file, "python", "the platform") : "/usr/bin/python3"};
  } catch (const Wrong& wrong) {
    return Unusable{wrong.why, ""};
  } catch (const WrongSkill& wrong) {
    return Unusable{wrong.why, wrong.skill};
  }
  return std::nullopt;
}

} // namespace proskill::runtime
