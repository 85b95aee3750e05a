#include "runtime/platform/ros_mapping.h"

#include <algorithm>

namespace proskill::runtime {

namespace {

class SensorReader {
public:
  SensorReader(const analysis::Program& of, Ros kind, Errors& by)
      : program(of), ros(kind), errors(by) {}

  [[nodiscard]] Json sensors(const Json& file) {
    Json all = Json::array();
    errors.attempt([&] {
      for (const auto& [name, value] : objectAt(file, "variables"))
        all.push_back(errors.attempt([&] { return variable(name, value); }));
    });
    errors.attempt([&] {
      for (const auto& [name, value] : objectAt(file, "events"))
        all.push_back(errors.attempt([&] { return event(name, value); }));
    });
    return all;
  }

private:
  /// What variables and events have in common.
  [[nodiscard]] Json sensor(const std::string& name, const Json& value) {
    const auto of = "`" + name + "`";
    Json made{{"name", name},
              {"topic", errors.attempt([&] { return wordAt(value, "topic", of); })},
              {"type", errors.attempt([&] { return typeAt(value, of, ros, "msg"); })},
              {"field", errors.attempt([&] { return wordAt(value, "field", of); })},
              {"hysteresis", errors.attempt([&] { return hysteresisOf(value, of); })},
              {"timeout", errors.attempt([&] { return timeoutOf(value, name); })},
              {"silent", nullptr}};
    if (value.contains("timeout") != value.contains("silent"))
      errors.note({of + ": `timeout` and `silent` belong together", &value});
    return made;
  }

  static Json hysteresisOf(const Json& value, const std::string& of) {
    if (!value.contains("hysteresis")) return 0.0;
    const auto& width = value["hysteresis"];
    if (width.is_number() && width.get<double>() >= 0) return width;
    throw Wrong{of + ": `hysteresis` must be a number that is not negative", &width};
  }

  static Json timeoutOf(const Json& value, const std::string& name) {
    if (!value.contains("timeout")) return nullptr;
    const auto timeout = inSeconds(value["timeout"], name + ".timeout");
    if (timeout > 0) return timeout;
    throw Wrong{"`" + name + "`: `timeout` must be more than 0 s", &value["timeout"]};
  }

  [[nodiscard]] Json variable(const std::string& name, const Json& value) {
    const auto of = "`" + name + "`";
    allowMembers(value, {"topic", "type", "field", "hysteresis", "timeout", "silent", "values"}, of,
                 errors);
    const auto* definition = program.stateVariables.find(name);
    if (!definition) throw unknown("state variable", name, variableNames());
    if (definition->node().isNatural())
      throw Wrong{of + " is a number; only values can be mapped", &name};
    auto made = sensor(name, value);
    errors.attempt([&] {
      if (value.contains("silent"))
        made["silent"] = eventThatSets(*definition, stringAt(value, "silent"));
    });
    if (!value.contains("values")) throw Wrong{of + ": `values` is missing", &value};
    made["cases"] = Json::array();
    for (const auto& each : listOf(value["values"], name + ".values"))
      made["cases"].push_back(errors.attempt([&] { return valueCase(*definition, each, of); }));
    rejectUnreachable(made["cases"], value["values"], of);
    return made;
  }

  [[nodiscard]] Json valueCase(const analysis::Definition<syntax::StateVariable>& variable,
                               const Json& each, const std::string& of) {
    allowMembers(each, {"value", "below", "above", "equals"}, "a value of " + of, errors);
    auto one = conditionOf(each, of);
    one["event"] = eventThatSets(variable, wordAt(each, "value", of));
    return one;
  }

  /// The first case without a condition is always taken.
  static void rejectUnreachable(const Json& cases, const Json& values, const std::string& of) {
    if (cases.empty()) throw Wrong{of + ": `values` must not be empty", &values};
    for (std::size_t i = 0; i + 1 < cases.size(); ++i)
      if (cases[i].size() == 1)
        throw Wrong{of + ": the values after the one without a condition are never reached",
                    &values[i + 1]};
  }

  [[nodiscard]] Json event(const std::string& name, const Json& value) {
    const auto of = "`" + name + "`";
    allowMembers(value, {"topic", "type", "field", "hysteresis", "below", "above", "equals"}, of,
                 errors);
    requireEvent(name);
    auto made = sensor(name, value);
    auto condition = conditionOf(value, of);
    if (condition.empty()) throw Wrong{of + ": `below`, `above` or `equals` is missing", &value};
    condition["event"] = name;
    made["cases"] = Json::array({std::move(condition)});
    return made;
  }

  void requireEvent(const std::string& name) const {
    std::vector<std::string> names;
    for (const auto& event : program.events.all) names.emplace_back(event.name());
    if (std::ranges::find(names, name) == names.end()) throw unknown("event", name, names);
  }

  /// The event whose only effect is that the variable gets this value.
  [[nodiscard]] std::string
  eventThatSets(const analysis::Definition<syntax::StateVariable>& variable,
                const std::string& value) const {
    std::vector<std::string> values;
    for (const auto& state : variable->states) values.emplace_back(state.text);
    const auto name = std::string(variable.name());
    if (std::ranges::find(values, value) == values.end())
      throw unknown("value of `" + name + "`", value, values);
    for (const auto& event : program.events.all) {
      const auto& effects = event->effects.items;
      if (effects.size() == 1 && effects[0].variable.text == name &&
          effects[0].value.name.text == value)
        return std::string(event.name());
    }
    throw Wrong{"no event sets `" + name + "` to `" + value + "`: add (defevent " + name + "_" +
                    value + " :effects (" + name + " " + value + "))",
                &value};
  }

  [[nodiscard]] std::vector<std::string> variableNames() const {
    std::vector<std::string> names;
    for (const auto& variable : program.stateVariables.all) names.emplace_back(variable.name());
    return names;
  }

  const analysis::Program& program;
  Ros ros;
  Errors& errors;
};

} // namespace

Json rosSensors(const analysis::Program& program, const Json& file, Ros ros, Errors& errors) {
  return SensorReader(program, ros, errors).sensors(file);
}

} // namespace proskill::runtime
