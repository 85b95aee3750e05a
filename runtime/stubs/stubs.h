#pragma once

#include "analysis/program/program.h"
#include "codegen/model.h"

#include <expected>
#include <string>
#include <vector>

/// Source text for those who implement the actions of a program: a typed function for each.
namespace proskill::runtime {

/// Type of an argument of an action.
struct StubType {
  enum class Kind : std::uint8_t { Integer, Natural, Float, Boolean, String, Value };
  Kind kind = Kind::String;
  std::string variable; ///< Value: the variable
};

/// What a user has to implement for a basic skill.
struct StubAction {
  struct Parameter {
    std::string name; ///< of the parameter of `:input`, without `$`; empty: a literal
    StubType type;
  };
  std::string skill;
  std::string action; ///< `(navigate $x $y "office")`, as written; empty if there is none
  std::vector<Parameter> parameters;
  std::vector<std::string> results; ///< as the protocol names them
};

/// What stubs need to know of a program, in the order of its text.
struct StubProgram {
  struct Variable {
    std::string name;
    std::vector<std::string> values;
  };
  std::string file; ///< name of the root file, without directories
  std::vector<StubAction> actions;
  std::vector<Variable> variables; ///< those whose values are arguments
  std::vector<std::string> events;
  std::vector<std::string> interrupts; ///< skills that can be interrupted
};

/// \pre the program has no errors
[[nodiscard]] std::expected<StubProgram, codegen::GenerationError>
stubProgram(const analysis::Program& program, const std::string& mainSkill);

struct StubFile {
  std::string name;
  std::string text;
  bool isUsers = false; ///< for users to fill in: written only if there is no such file
};

/// Files of a platform in Python.
[[nodiscard]] std::vector<StubFile> pythonStubs(const StubProgram& program);
/// Files of a library in C or in C++ that performs the actions.
[[nodiscard]] std::vector<StubFile> cStubs(const StubProgram& program);
[[nodiscard]] std::vector<StubFile> cppStubs(const StubProgram& program);

/// Whether a generated file is unchanged: users have written nothing into it.
[[nodiscard]] bool isUnchangedStub(std::string_view text);

} // namespace proskill::runtime
