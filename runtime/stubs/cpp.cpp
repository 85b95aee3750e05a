#include "runtime/stubs/library_stubs.h"

#include <fmt/format.h>

namespace proskill::runtime {

namespace {

/// Writes the stubs in C++.
class CppStubs {
public:
  explicit CppStubs(const StubProgram& of) : program(of) {
    names.take("FILE");
    names.take("DIR");
    for (const auto& variable : program.variables)
      variables.push_back(names.unique(upperCamel(variable.name)));
    for (const auto& action : program.actions)
      results.push_back(names.unique(upperCamel(action.skill) + "Result"));
    auto methods = names;
    for (const auto& action : program.actions)
      functions.push_back(methods.unique(functionName(action.skill)));
  }

  [[nodiscard]] StubFile header() const {
    auto text = fmt::format("// The actions of {}, as a class to derive from: robot.cpp does.\n"
                            "#ifndef ACTIONS_HPP\n#define ACTIONS_HPP\n\n"
                            "#include <cstdint>\n#include <memory>\n#include <string>\n\n"
                            "#include <proskill/platform.hpp>\n",
                            program.file);
    for (std::size_t i = 0; i < variables.size(); ++i)
      text += enumeration(variables[i], program.variables[i].values,
                          fmt::format("The values of `{}`.", program.variables[i].name));
    for (std::size_t i = 0; i < results.size(); ++i)
      text += enumeration(results[i], program.actions[i].results,
                          fmt::format("How `{}` ends.", program.actions[i].skill));
    if (!program.events.empty()) text += enumeration("Event", program.events, "What may happen.");
    if (!program.interrupts.empty())
      text += enumeration("Skill", program.interrupts, "What may be interrupted from outside.");
    return {"actions.hpp", withStubMark("//", text + base() + "\n#endif\n"), false};
  }

  [[nodiscard]] StubFile glue() const {
    std::string text = "#include \"actions.hpp\"\n\n#include <stdexcept>\n\nPROSKILL_LIBRARY;\n";
    text += kLife;
    if (!functions.empty()) text += kSuits;
    for (std::size_t i = 0; i < variables.size(); ++i) text += reader(i);
    for (std::size_t i = 0; i < functions.size(); ++i) text += caller(i);
    if (!program.events.empty())
      text += teller("report", "Event", "event", program.events, "proskill_report");
    if (!program.interrupts.empty())
      text += teller("interrupt", "Skill", "skill", program.interrupts, "proskill_interrupt");
    return {"actions.cpp", withStubMark("//", text), false};
  }

  [[nodiscard]] StubFile users() const {
    auto text = fmt::format("// Performs the actions of {}. This file is yours: `proskill stubs` "
                            "does not write it again.\n"
                            "// An action that is asked to stop lets run.sleep and run.check throw "
                            "proskill::Stopped.\n"
                            "#include \"actions.hpp\"\n\n#include <stdexcept>\n\n"
                            "namespace {{\n\nclass Robot final : public Actions {{\npublic:\n",
                            program.file);
    for (std::size_t i = 0; i < functions.size(); ++i)
      text += fmt::format("{}  {} override {{\n    throw std::logic_error(\"not written yet\");\n"
                          "  }}\n",
                          i == 0 ? "" : "\n", signature(i));
    return {"robot.cpp",
            text + "};\n\n} // namespace\n\nstd::unique_ptr<Actions> makeActions() { return "
                   "std::make_unique<Robot>(); }\n",
            true};
  }

private:
  static constexpr std::string_view kLife = R"(
static std::unique_ptr<Actions> actions;

PROSKILL_EXPORT const char *proskill_open() {
  static std::string why;
  try {
    actions = makeActions();
    return nullptr;
  } catch (const std::exception &error) {
    why = error.what();
    return why.c_str();
  }
}

PROSKILL_EXPORT void proskill_close() { actions.reset(); }
)";
  static constexpr std::string_view kSuits = R"(
// Throws where the arguments are not those of the program that this file was written for.
static void suits(const proskill_value *arguments, std::size_t count, std::size_t wanted) {
  if (count != wanted) throw std::logic_error("it has other arguments: run `proskill stubs` again");
  for (std::size_t i = 0; i < count; ++i)
    if (arguments[i].type == PROSKILL_NONE) throw std::logic_error("an argument has no value");
}
)";

  /// Members of an enumeration, one for each name.
  static std::vector<std::string> members(const std::vector<std::string>& words) {
    auto own = StubNames::ofC();
    std::vector<std::string> all;
    for (const auto& word : words) all.push_back(own.unique(upperCamel(word)));
    return all;
  }

  static std::string enumeration(const std::string& name, const std::vector<std::string>& words,
                                 const std::string& about) {
    return fmt::format("\n// {}\nenum class {} {{ {} }};\n", about, name,
                       fmt::join(members(words), ", "));
  }

  [[nodiscard]] std::string typeOf(const StubType& type) const {
    return textFor(program, type, {"std::int64_t ", "double ", "bool ", "const std::string &"},
                   [&](std::size_t variable) { return variables[variable] + " "; });
  }

  [[nodiscard]] std::string signature(std::size_t action) const {
    auto text = fmt::format("{} {}(const proskill::Run &run", results[action], functions[action]);
    const auto parameters = parameterNames(program.actions[action], names);
    for (std::size_t i = 0; i < parameters.size(); ++i)
      text += ", " + typeOf(program.actions[action].parameters[i].type) + parameters[i];
    return text + ")";
  }

  /// The base class of the user's class: what the user omits or declares differently does not
  /// compile.
  [[nodiscard]] std::string base() const {
    std::string text = "\nclass Actions {\npublic:\n  Actions() = default;\n"
                       "  Actions(const Actions &) = delete;\n"
                       "  Actions &operator=(const Actions &) = delete;\n"
                       "  virtual ~Actions() = default;\n";
    for (std::size_t i = 0; i < functions.size(); ++i) {
      const auto line = actionLine(program.actions[i]);
      text += line.empty() ? "\n" : "\n  // " + line + "\n";
      text += fmt::format("  virtual {} = 0;\n", signature(i));
    }
    if (!program.events.empty()) text += "\n  static void report(Event event);\n";
    if (!program.interrupts.empty()) text += "\n  static void interrupt(Skill skill);\n";
    return text + "};\n\n// Yours: it is called once, before the run begins.\n"
                  "std::unique_ptr<Actions> makeActions();\n";
  }

  /// Function that converts a name to a value. The last name needs no comparison.
  [[nodiscard]] std::string reader(std::size_t variable) const {
    const auto& name = variables[variable];
    const auto& words = program.variables[variable].values;
    const auto all = members(words);
    auto text = fmt::format("\nstatic {0} read{0}(const std::string &word) {{\n", name);
    for (std::size_t i = 0; i + 1 < words.size(); ++i)
      text += fmt::format("  if (word == \"{}\") return {}::{};\n", words[i], name, all[i]);
    return text + fmt::format("  (void)word;\n  return {}::{};\n}}\n", name, all.back());
  }

  [[nodiscard]] std::string caller(std::size_t action) const {
    const auto& of = program.actions[action];
    const auto readerOf = [&](std::size_t variable) { return "read" + variables[variable]; };
    auto text = fmt::format("\nPROSKILL_EXPORT const char *skill_{}(proskill_run run, const "
                            "proskill_value *arguments, std::size_t count) {{\n"
                            "  return proskill::perform(run, [&]() -> const char * {{\n"
                            "    suits(arguments, count, {});\n"
                            "    switch (actions->{}(proskill::Run(run)",
                            of.skill, of.parameters.size(), functions[action]);
    for (std::size_t i = 0; i < of.parameters.size(); ++i)
      text += ", " + argumentText(program, of.parameters[i].type, i, readerOf);
    text += ")) {\n";
    const auto all = members(of.results);
    for (std::size_t i = 0; i < of.results.size(); ++i)
      text +=
          fmt::format("    case {}::{}: return \"{}\";\n", results[action], all[i], of.results[i]);
    return text + "    }\n    return PROSKILL_STOPPED;\n  });\n}\n";
  }

  [[nodiscard]] static std::string teller(const std::string& name, const std::string& type,
                                          const std::string& parameter,
                                          const std::vector<std::string>& words,
                                          const std::string& call) {
    auto text = fmt::format("\nvoid Actions::{}({} {}) {{\n  switch ({}) {{\n", name, type,
                            parameter, parameter);
    const auto all = members(words);
    for (std::size_t i = 0; i < words.size(); ++i)
      text += fmt::format("  case {}::{}: {}(\"{}\"); break;\n", type, all[i], call, words[i]);
    return text + "  }\n}\n";
  }

  const StubProgram& program;
  StubNames names = StubNames::ofC(); ///< of types
  std::vector<std::string> variables; ///< names of their enumerations
  std::vector<std::string> results;   ///< by action
  std::vector<std::string> functions;
};

} // namespace

std::vector<StubFile> cppStubs(const StubProgram& program) {
  const CppStubs stubs(program);
  std::vector<StubFile> all{stubs.header(), stubs.glue(), stubs.users()};
  for (auto& file : libraryFiles("CXX", {"robot.cpp", "actions.cpp"}, "actions.hpp"))
    all.push_back(std::move(file));
  return all;
}

} // namespace proskill::runtime
