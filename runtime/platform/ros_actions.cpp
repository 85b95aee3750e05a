#include "runtime/platform/ros_mapping.h"

#include "runtime/platform/messages.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::runtime {

namespace {

std::vector<std::string> terminalStatesOf(Ros ros) {
  switch (ros) {
  case Ros::One: return {"succeeded", "aborted", "rejected", "preempted", "recalled"};
  case Ros::Two: return {"succeeded", "aborted", "rejected", "canceled"};
  }
  return {};
}

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const auto& name : names) all += (all.empty() ? "`" : ", `") + name + "`";
  return all;
}

class ActionReader {
public:
  ActionReader(const analysis::Program& of, Ros kind, Errors& by)
      : program(of), ros(kind), errors(by) {}

  [[nodiscard]] Json action(const codegen::Performed& performed, const Json& value) {
    const auto of = "`" + performed.skill + "`";
    if (!value.is_object()) throw Wrong{of + " must be an object", &value};
    if (value.contains("service")) return service(performed, value, of);
    if (value.contains("topic")) return topic(performed, value, of);
    if (!value.contains("action"))
      throw Wrong{of + ": `action`, `service` or `topic` is missing", &value};
    allowMembers(value, {"action", "type", "goal", "results"}, of, errors);
    return {{"kind", "action"},
            {"name", errors.attempt([&] { return wordAt(value, "action", of); })},
            {"type", errors.attempt([&] { return typeAt(value, of, ros, "action"); })},
            {"fields", errors.attempt([&] { return fields(performed, value, "goal"); })},
            {"results", errors.attempt([&] { return terminalStates(performed, value, of); })}};
  }

private:
  using Performed = codegen::Performed;

  [[nodiscard]] Json service(const Performed& performed, const Json& value, const std::string& of) {
    allowMembers(value, {"service", "type", "request", "results"}, of, errors);
    if (!value.contains("results")) errors.note({of + ": `results` is missing", &value});
    return {{"kind", "service"},
            {"name", errors.attempt([&] { return wordAt(value, "service", of); })},
            {"type", errors.attempt([&] { return typeAt(value, of, ros, "srv"); })},
            {"fields", errors.attempt([&] { return fields(performed, value, "request"); })},
            {"results", casesOfService(performed, value, of)}};
  }

  [[nodiscard]] Json topic(const Performed& performed, const Json& value, const std::string& of) {
    allowMembers(value, {"topic", "type", "message", "result"}, of, errors);
    return {{"kind", "topic"},
            {"name", errors.attempt([&] { return wordAt(value, "topic", of); })},
            {"type", errors.attempt([&] { return typeAt(value, of, ros, "msg"); })},
            {"fields", errors.attempt([&] { return fields(performed, value, "message"); })},
            {"result", errors.attempt([&] { return resultOfTopic(performed, value, of); })}};
  }

  [[nodiscard]] static std::string resultOfTopic(const Performed& performed, const Json& value,
                                                 const std::string& of) {
    return value.contains("result") ? result(performed, stringAt(value, "result"))
                                    : onlyResult(performed, "success", of, value);
  }

  [[nodiscard]] Json casesOfService(const Performed& performed, const Json& value,
                                    const std::string& of) {
    if (!value.contains("results")) return nullptr;
    return errors.attempt([&] { return resultCases(performed, value["results"], of); });
  }

  /// Fields of a message by their paths: literals, and `$name` for an argument of the action.
  [[nodiscard]] Json fields(const Performed& performed, const Json& value, const std::string& key) {
    Json all = Json::array();
    for (const auto& [path, given] : objectAt(value, key)) {
      if (!given.is_primitive() || given.is_null()) {
        errors.note({fmt::format("`{}.{}.{}` must be a number, a string, true or false",
                                 performed.skill, key, path),
                     &given});
        continue;
      }
      Json one{{"path", path}};
      errors.attempt([&] { setValue(one, performed, given); });
      all.push_back(std::move(one));
    }
    return all;
  }

  void setValue(Json& field, const Performed& performed, const Json& given) const {
    if (given.is_string() && given.get_ref<const std::string&>().starts_with('$'))
      setArgument(field, performed, given.get_ref<const std::string&>());
    else
      field["value"] = given;
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
    throw unknown("argument of the action of `" + performed.skill + "`", name, names);
  }

  static std::string typeOf(const syntax::Skill& skill, const std::string& parameter) {
    for (const auto& input : skill.inputs)
      if (input.name.text == parameter) return std::string(input.type.text);
    return "";
  }

  // --- Results

  [[nodiscard]] static std::string result(const Performed& performed, const std::string& name) {
    std::vector<std::string> names;
    for (const auto& each : performed.results) names.push_back(resultName(each));
    if (std::ranges::find(names, name) == names.end())
      throw unknown("result of `" + performed.skill + "`", name, names);
    return name;
  }

  static std::string onlyResult(const Performed& performed, const std::string& status,
                                const std::string& of, const Json& value) {
    std::vector<std::string> names;
    for (const auto& each : performed.results)
      if (each.status == status) names.push_back(resultName(each));
    if (names.size() != 1)
      throw Wrong{of + ": which " + status + " it is must be said: " + joined(names), &value};
    return names.front();
  }

  /// The terminal states of a goal that the file names.
  [[nodiscard]] Json namedStates(const Performed& performed, const Json& value,
                                 const std::string& of) {
    const auto known = terminalStatesOf(ros);
    Json all = Json::object();
    for (const auto& [state, given] : objectAt(value, "results")) {
      if (std::ranges::find(known, state) == known.end())
        errors.note(unknown("terminal state", state, known));
      all[state] = errors.attempt([&] { return resultCases(performed, given, of); });
    }
    return all;
  }

  /// By terminal state of a goal. Without `results` a success is the only success, and the rest
  /// the only failure.
  [[nodiscard]] Json terminalStates(const Performed& performed, const Json& value,
                                    const std::string& of) {
    auto all = namedStates(performed, value, of);
    if (!all.contains("succeeded"))
      all["succeeded"] = Json::array({{{"result", onlyResult(performed, "success", of, value)}}});
    const auto failures =
        std::ranges::count(performed.results, "failure", &Performed::Result::status);
    for (const char* state : {"aborted", "rejected"})
      if (!all.contains(state) && failures == 1)
        all[state] = Json::array({{{"result", onlyResult(performed, "failure", of, value)}}});
    return all;
  }

  /// A result, or a list of cases, of which the first that holds counts.
  [[nodiscard]] Json resultCases(const Performed& performed, const Json& value,
                                 const std::string& of) {
    if (value.is_string())
      return Json::array({{{"result", result(performed, value.get_ref<const std::string&>())}}});
    Json all = Json::array();
    for (const auto& each : listOf(value, of + ".results"))
      all.push_back(errors.attempt([&] { return resultCase(performed, each, of); }));
    if (all.empty()) throw Wrong{of + ": a list of results must not be empty", &value};
    return all;
  }

  [[nodiscard]] Json resultCase(const Performed& performed, const Json& each,
                                const std::string& of) {
    allowMembers(each, {"field", "below", "above", "equals", "result"}, "a result of " + of,
                 errors);
    auto made = conditionOf(each, of);
    if (!made.empty()) made["field"] = wordAt(each, "field", of);
    if (made.empty() && each.contains("field"))
      throw Wrong{of + ": a `field` without `below`, `above` or `equals`", &each};
    made["result"] = result(performed, wordAt(each, "result", of));
    return made;
  }

  const analysis::Program& program;
  Ros ros;
  Errors& errors;
};

} // namespace

Json rosAction(const analysis::Program& program, const codegen::Performed& performed,
               const Json& value, Ros ros, Errors& errors) {
  return ActionReader(program, ros, errors).action(performed, value);
}

} // namespace proskill::runtime
