#pragma once

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

/// What `--help` shows. The manual page and the completions of the shells are made from the same
/// declarations, by completions/generate.py.
namespace proskill::cli {

/// The groups that options stand in.
namespace group {
inline constexpr const char* kSubject = "Selection";
inline constexpr const char* kOutput = "Output";
inline constexpr const char* kLimits = "Limits";
inline constexpr const char* kBackends = "Backends";
inline constexpr const char* kAdvanced = "Advanced";
} // namespace group

/// Puts an option into a group and says what its value is: FILE, DIRECTORY, or `a|b|c`.
CLI::Option* show(CLI::Option* option, const char* inGroup, const std::string& value = "");

/// The option `--main SKILL` of a subcommand.
void addMainSkill(CLI::App& command, std::string& mainSkill);

/// An exit code, and when a command ends with it.
struct ExitMeaning {
  int code;
  std::string meaning;
};

/// What stands below the options: commands to try, and the exit codes.
void showBelow(CLI::App& command, const std::vector<std::string>& examples,
               const std::vector<ExitMeaning>& exits);

/// A subcommand whose options go to `Arguments` of its own, with which it is run.
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

/// Options in two columns, of which the right one is wrapped.
void useHelpFormat(CLI::App& app);

/// Adds `help-data`, which is hidden: what `--help` shows of all commands, as JSON.
void addHelpData(CLI::App& app, int& exitCode);

} // namespace proskill::cli
