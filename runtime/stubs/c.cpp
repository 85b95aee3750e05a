#include "runtime/stubs/library_stubs.h"

#include <fmt/format.h>

namespace proskill::runtime {

namespace {

/// A C enumeration, and the name in the program for each of its members.
struct Enumeration {
  std::string type;
  std::vector<std::string> members;
  std::vector<std::string> words;
};

/// Writes the stubs in C.
class CStubs {
public:
  explicit CStubs(const StubProgram& of) : program(of) {
    for (const auto& action : program.actions) names.take("skill_" + action.skill);
    for (const auto& variable : program.variables) {
      values.push_back(enumeration(variable.name + "_value", variable.name, variable.values));
      readers.push_back(names.unique("read_" + values.back().type));
    }
    for (const auto& action : program.actions) {
      results.push_back(enumeration(action.skill + "_result", action.skill, action.results));
      stopped.push_back(names.unique(upperSnake(plainName(action.skill)) + "_WAS_STOPPED"));
      functions.push_back(names.unique("perform_" + action.skill));
    }
    events = enumeration("robot_event", "event", program.events);
    skills = enumeration("robot_skill", "skill", program.interrupts);
  }

  [[nodiscard]] StubFile header() const {
    auto text = fmt::format("// The actions of {}, as functions to write: robot.c has them.\n"
                            "#ifndef ACTIONS_H\n#define ACTIONS_H\n\n"
                            "#include <proskill/platform.h>\n",
                            program.file);
    for (std::size_t i = 0; i < values.size(); ++i)
      text += typeText(values[i], fmt::format("The values of `{}`.", program.variables[i].name));
    for (std::size_t i = 0; i < results.size(); ++i) {
      auto all = results[i];
      all.members.push_back(stopped[i]);
      text += typeText(all, fmt::format("How `{}` ends.", program.actions[i].skill));
    }
    for (std::size_t i = 0; i < functions.size(); ++i) {
      const auto line = actionLine(program.actions[i]);
      text += line.empty() ? "\n" : "\n// " + line + "\n";
      text += signature(i) + ";\n";
    }
    if (!program.events.empty())
      text += typeText(events, "What may happen.") +
              fmt::format("\nvoid report_event({} event);\n", events.type);
    if (!program.interrupts.empty())
      text += typeText(skills, "What may be interrupted from outside.") +
              fmt::format("\nvoid interrupt_skill({} skill);\n", skills.type);
    return {"actions.h", withStubMark("//", text + "\n#endif\n"), false};
  }

  [[nodiscard]] StubFile glue() const {
    std::string text = "#include \"actions.h\"\n\n#include <string.h>\n\nPROSKILL_LIBRARY;\n";
    if (!functions.empty()) text += kSuits;
    for (std::size_t i = 0; i < values.size(); ++i) text += reader(i);
    for (std::size_t i = 0; i < functions.size(); ++i) text += caller(i);
    if (!program.events.empty()) text += teller("report_event", events, "event", "proskill_report");
    if (!program.interrupts.empty())
      text += teller("interrupt_skill", skills, "skill", "proskill_interrupt");
    return {"actions.c", withStubMark("//", text), false};
  }

  [[nodiscard]] StubFile users() const {
    auto text = fmt::format("// Performs the actions of {}. This file is yours: `proskill stubs` "
                            "does not write it again.\n"
                            "// An action that is asked to stop lets proskill_wait return true.\n"
                            "#include \"actions.h\"\n",
                            program.file);
    for (std::size_t i = 0; i < functions.size(); ++i)
      text += fmt::format("\n{} {{\n  proskill_fail(run, \"not written yet\");\n  return {};\n}}\n",
                          signature(i), stopped[i]);
    return {"robot.c", text, true};
  }

private:
  static constexpr std::string_view kSuits = R"(
// Whether the arguments are those of the program that this file was written for.
static bool suits(proskill_run run, const proskill_value *arguments, size_t count, size_t wanted) {
  if (count != wanted) {
    proskill_fail(run, "it has other arguments: run `proskill stubs` again");
    return false;
  }
  for (size_t i = 0; i < count; ++i)
    if (arguments[i].type == PROSKILL_NONE) {
      proskill_fail(run, "an argument has no value");
      return false;
    }
  return true;
}
)";

  Enumeration enumeration(const std::string& type, const std::string& prefix,
                          const std::vector<std::string>& words) {
    Enumeration made{names.unique(plainName(type)), {}, words};
    for (const auto& word : words)
      made.members.push_back(
          names.unique(upperSnake(plainName(fmt::format("{}_{}", prefix, word)))));
    return made;
  }

  static std::string typeText(const Enumeration& of, const std::string& about) {
    return fmt::format("\n// {}\ntypedef enum {{\n  {}\n}} {};\n", about,
                       fmt::join(of.members, ",\n  "), of.type);
  }

  [[nodiscard]] std::string typeOf(const StubType& type) const {
    return textFor(program, type, {"int64_t ", "double ", "bool ", "const char *"},
                   [&](std::size_t variable) { return values[variable].type + " "; });
  }

  [[nodiscard]] std::string signature(std::size_t action) const {
    auto text = fmt::format("{} {}(proskill_run run", results[action].type, functions[action]);
    const auto parameters = parameterNames(program.actions[action], names);
    for (std::size_t i = 0; i < parameters.size(); ++i)
      text += ", " + typeOf(program.actions[action].parameters[i].type) + parameters[i];
    return text + ")";
  }

  /// Function that converts a name to a value. The last name needs no comparison.
  [[nodiscard]] std::string reader(std::size_t variable) const {
    const auto& of = values[variable];
    auto text = fmt::format("\nstatic {} {}(const char *word) {{\n", of.type, readers[variable]);
    for (std::size_t i = 0; i + 1 < of.words.size(); ++i)
      text +=
          fmt::format("  if (strcmp(word, \"{}\") == 0) return {};\n", of.words[i], of.members[i]);
    return text + fmt::format("  (void)word;\n  return {};\n}}\n", of.members.back());
  }

  [[nodiscard]] std::string caller(std::size_t action) const {
    const auto& of = program.actions[action];
    const auto readerOf = [&](std::size_t variable) { return readers[variable]; };
    auto text = fmt::format(
        "\nPROSKILL_EXPORT const char *skill_{}(proskill_run run, const proskill_value *arguments, "
        "size_t count);\n"
        "const char *skill_{}(proskill_run run, const proskill_value *arguments, size_t count) {{\n"
        "  if (!suits(run, arguments, count, {})) return PROSKILL_STOPPED;\n"
        "  switch ({}(run",
        of.skill, of.skill, of.parameters.size(), functions[action]);
    for (std::size_t i = 0; i < of.parameters.size(); ++i)
      text += ", " + argumentText(program, of.parameters[i].type, i, readerOf);
    text += ")) {\n";
    for (std::size_t i = 0; i < of.results.size(); ++i)
      text += fmt::format("  case {}: return \"{}\";\n", results[action].members[i], of.results[i]);
    return text + fmt::format("  case {}: break;\n  }}\n  return PROSKILL_STOPPED;\n}}\n",
                              stopped[action]);
  }

  [[nodiscard]] static std::string teller(const std::string& name, const Enumeration& of,
                                          const std::string& parameter, const std::string& call) {
    auto text =
        fmt::format("\nvoid {}({} {}) {{\n  switch ({}) {{\n", name, of.type, parameter, parameter);
    for (std::size_t i = 0; i < of.words.size(); ++i)
      text += fmt::format("  case {}: {}(\"{}\"); break;\n", of.members[i], call, of.words[i]);
    return text + "  }\n}\n";
  }

  const StubProgram& program;
  StubNames names = StubNames::ofC();
  std::vector<Enumeration> values;  ///< by variable
  std::vector<std::string> readers; ///< by variable
  std::vector<Enumeration> results; ///< by action
  std::vector<std::string> stopped;
  std::vector<std::string> functions;
  Enumeration events;
  Enumeration skills;
};

} // namespace

std::vector<StubFile> cStubs(const StubProgram& program) {
  const CStubs stubs(program);
  std::vector<StubFile> all{stubs.header(), stubs.glue(), stubs.users()};
  for (auto& file : libraryFiles("CC", {"robot.c", "actions.c"}, "actions.h"))
    all.push_back(std::move(file));
  return all;
}

} // namespace proskill::runtime
