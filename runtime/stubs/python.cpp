#include "runtime/stubs/stub_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::runtime {

namespace {

/// Python reserves members such as `_X_` of enumerations, and `__X` does not become one.
std::string memberName(std::string_view word) {
  const auto begin = word.find_first_not_of('_');
  if (begin == 0) return upperSnake(word);
  const auto rest = begin == std::string_view::npos ? std::string_view() : word.substr(begin);
  const bool isName = !rest.empty() && (rest.front() < '0' || rest.front() > '9');
  return (isName ? "" : "VALUE_") + upperSnake(rest);
}

/// An Enum class whose members have the program's names as values.
std::string enumeration(const std::string& name, const std::string& about,
                        const std::vector<std::string>& words) {
  std::string text = fmt::format("\n\nclass {}(enum.Enum):\n    \"\"\"{}\"\"\"\n\n", name, about);
  auto members = StubNames::ofPython();
  for (const auto& word : words)
    text += fmt::format("    {} = \"{}\"\n", members.unique(memberName(word)), word);
  return text;
}

/// Python gives names that begin with `__` a meaning of their own.
std::string methodFor(const std::string& skill) {
  return skill.starts_with("__") ? "skill" + skill : skill;
}

/// Writes the stubs in Python.
class PythonStubs {
public:
  explicit PythonStubs(const StubProgram& of) : program(of) {
    for (const auto& variable : program.variables)
      variables.push_back(names.unique(upperCamel(variable.name)));
    for (const auto& action : program.actions)
      results.push_back(names.unique(upperCamel(action.skill) + "Result"));
    auto methods = names;
    for (const auto* const own : {"report", "interrupt", "log", "platform", "_abc_impl"})
      methods.take(own);
    for (const auto& action : program.actions) {
      functions.push_back(methods.unique(methodFor(action.skill)));
      parameters.push_back(parametersOf(action));
    }
  }

  [[nodiscard]] StubFile generated() const {
    std::string text = fmt::format("\"\"\"The actions of {}, as a class to fill in.\"\"\"\n\n"
                                   "import abc\nimport enum\n\n"
                                   "from proskill import Platform, Stop\n",
                                   program.file);
    for (std::size_t i = 0; i < variables.size(); ++i)
      text +=
          enumeration(variables[i], fmt::format("The values of `{}`.", program.variables[i].name),
                      program.variables[i].values);
    for (std::size_t i = 0; i < results.size(); ++i)
      text += enumeration(results[i], fmt::format("How `{}` ends.", program.actions[i].skill),
                          program.actions[i].results);
    if (!program.events.empty()) text += enumeration("Event", "What may happen.", program.events);
    if (!program.interrupts.empty())
      text += enumeration("Skill", "What may be interrupted from outside.", program.interrupts);
    text += base();
    return {"actions.py", withStubMark("#", text + factory()), false};
  }

  [[nodiscard]] StubFile users() const {
    std::vector<std::string> imported{"Actions", "platform_of"};
    imported.insert(imported.end(), results.begin(), results.end());
    imported.insert(imported.end(), variables.begin(), variables.end());
    std::ranges::sort(imported);
    std::string text =
        fmt::format("\"\"\"Performs the actions of {}. This file is yours: `proskill "
                    "stubs` does not write it again.\"\"\"\n\n"
                    "from actions import (\n",
                    program.file);
    for (const auto& name : imported) text += fmt::format("    {},\n", name);
    text += ")\nfrom proskill import Stop\n\n\nclass Robot(Actions):\n";
    for (std::size_t i = 0; i < functions.size(); ++i)
      text += fmt::format("{}    {}\n        raise NotImplementedError\n", i == 0 ? "" : "\n",
                          signature(i));
    if (functions.empty()) text += "    pass\n";
    return {"robot.py", text + "\n\nif __name__ == \"__main__\":\n    platform_of(Robot()).run()\n",
            true};
  }

private:
  struct Parameter {
    std::string name;
    std::string type;
    bool isValue = false;
  };

  [[nodiscard]] std::vector<Parameter> parametersOf(const StubAction& action) const {
    std::vector<Parameter> all;
    for (auto& name : parameterNames(action, names)) {
      const StubType& type = action.parameters[all.size()].type;
      all.push_back({std::move(name), typeOf(type), type.kind == StubType::Kind::Value});
    }
    return all;
  }

  [[nodiscard]] std::string typeOf(const StubType& type) const {
    return textFor(program, type, {"int", "float", "bool", "str"},
                   [&](std::size_t variable) { return variables[variable]; });
  }

  /// `def fly(self, height: float, stop: Stop) -> FlyResult:`
  [[nodiscard]] std::string signature(std::size_t action) const {
    std::string text = fmt::format("def {}(self", functions[action]);
    for (const auto& parameter : parameters[action])
      text += fmt::format(", {}: {}", parameter.name, parameter.type);
    return text + fmt::format(", stop: Stop) -> {}:", results[action]);
  }

  /// The base class of the user's class: what the user omits or declares differently is a type
  /// error.
  [[nodiscard]] std::string base() const {
    std::string text = "\n\nclass Actions(abc.ABC):\n"
                       "    \"\"\"A method for each basic skill. One that is asked to stop lets "
                       "`stop.sleep` or `stop.check`\n    raise Stopped.\"\"\"\n\n"
                       "    platform: Platform  # set by platform_of\n";
    for (std::size_t i = 0; i < functions.size(); ++i) {
      text += fmt::format("\n    @abc.abstractmethod\n    {}\n", signature(i));
      const auto line = actionLine(program.actions[i]);
      text += line.empty() ? "        ...\n" : fmt::format("        # {}\n        ...\n", line);
    }
    if (!program.events.empty())
      text += "\n    def report(self, event: Event) -> None:\n"
              "        self.platform.report(event.value)\n";
    if (!program.interrupts.empty())
      text += "\n    def interrupt(self, skill: Skill) -> None:\n"
              "        self.platform.interrupt(skill.value)\n";
    return text;
  }

  [[nodiscard]] std::string factory() const {
    std::string text = "\n\ndef platform_of(actions: Actions) -> Platform:\n"
                       "    \"\"\"What performs the actions: `run` it.\"\"\"\n"
                       "    made = Platform()\n    actions.platform = made\n";
    for (std::size_t i = 0; i < functions.size(); ++i) {
      std::string given;
      std::string passed;
      for (const auto& parameter : parameters[i]) {
        given += parameter.name + ", ";
        passed += parameter.isValue ? fmt::format("{}({}), ", parameter.type, parameter.name)
                                    : parameter.name + ", ";
      }
      text += fmt::format("    made.action(\"{}\")(lambda {}stop: actions.{}({}stop))\n",
                          program.actions[i].skill, given, functions[i], passed);
    }
    return text + "    return made\n";
  }

  const StubProgram& program;
  StubNames names = StubNames::ofPython(); ///< of classes
  std::vector<std::string> variables;      ///< names of their classes
  std::vector<std::string> results;        ///< by action
  std::vector<std::string> functions;
  std::vector<std::vector<Parameter>> parameters;
};

constexpr std::string_view kPlatform =
    "{\n  \"kind\": \"process\",\n  \"command\": [\"python3\", \"robot.py\"]\n}\n";

} // namespace

std::vector<StubFile> pythonStubs(const StubProgram& program) {
  const PythonStubs stubs(program);
  return {stubs.generated(), stubs.users(), {"platform.json", std::string(kPlatform), true}};
}

} // namespace proskill::runtime
