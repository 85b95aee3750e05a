#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

/// What `--help` shows. The manual page and the completions of the shells are made from the same
/// declarations, by completions/generate.py.
namespace proskill::cli {

/// The groups that options stand in.
namespace group {
inline constexpr const char* kSubject = "What to look at";
inline constexpr const char* kOutput = "Output";
inline constexpr const char* kLimits = "Limits";
inline constexpr const char* kBackends = "Backends";
inline constexpr const char* kAdvanced = "Advanced";
} // namespace group

/// Puts an option into a group and says what its value is: FILE, DIRECTORY, or `a|b|c`.
CLI::Option* show(CLI::Option* option, const char* inGroup, const std::string& value = "");

/// An exit code, and when a command ends with it.
struct ExitMeaning {
  int code;
  std::string meaning;
};

/// What stands below the options: commands to try, and the exit codes.
void showBelow(CLI::App& command, const std::vector<std::string>& examples,
               const std::vector<ExitMeaning>& exits);

/// Options in two columns, of which the right one is wrapped.
void useHelpFormat(CLI::App& app);

/// Adds `help-data`, which is hidden: what `--help` shows of all commands, as JSON.
void addHelpData(CLI::App& app, int& exitCode);

} // namespace proskill::cli
