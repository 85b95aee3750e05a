#pragma once

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

/// The content of `--help`. completions/generate.py makes the manual page and the shell completions
/// from the same declarations.
namespace proskill::cli {

/// Groups of options in the help.
namespace group {
inline constexpr const char* kSubject = "Selection";
inline constexpr const char* kOutput = "Output";
inline constexpr const char* kLimits = "Limits";
inline constexpr const char* kBackends = "Backends";
inline constexpr const char* kAdvanced = "Advanced";
} // namespace group

/// Puts an option into a group and names its value: FILE, DIRECTORY, or `a|b|c`.
CLI::Option* show(CLI::Option* option, const char* inGroup, const std::string& value = "");

/// The option `--main SKILL` of a subcommand.
void addMainSkill(CLI::App& command, std::string& mainSkill);

/// An exit code and its meaning.
struct ExitMeaning {
  int code;
  std::string meaning;
};

/// The text below the options: example commands and exit codes.
void showBelow(CLI::App& command, const std::vector<std::string>& examples,
               const std::vector<ExitMeaning>& exits);

/// Adds a subcommand that runs with an `Arguments` object of its own.
template <class Arguments>
CLI::App& addCommand(CLI::App& app, const std::string& name, const std::string& description,
                     void (*addOptions)(CLI::App&, Arguments&), int (*run)(const Arguments&),
                     int& exitCode) {
  auto arguments = std::make_shared<Arguments>();
  auto* command = app.add_subcommand(name, description);
  addOptions(*command, *arguments);
  command->callback([arguments, run, &exitCode] { exitCode = run(*arguments); });
  return *command;
}

/// Prints options in two columns and wraps the right one.
void useHelpFormat(CLI::App& app);

/// Adds the hidden command `help-data`, which prints the help of all commands as JSON.
void addHelpData(CLI::App& app, int& exitCode);

} // namespace proskill::cli
