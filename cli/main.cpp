// The `proskill` program. Each subcommand has a file of its own, `cli/commands/NAME.cpp` or
// `cli/execution/NAME.cpp`. Its function `addNAME(CLI::App&, int& exitCode)` adds the subcommand
// with its options; when the subcommand has run, its result is in `exitCode`. A new subcommand is
// added in two places here: the include and the list in main().

#include "cli/bridges/import.h"
#include "cli/commands/check.h"
#include "cli/commands/dap.h"
#include "cli/commands/emit.h"
#include "cli/commands/explain.h"
#include "cli/commands/fmt.h"
#include "cli/commands/graph.h"
#include "cli/commands/lsp.h"
#include "cli/commands/verify.h"
#include "cli/commands/verify_worker.h"
#include "cli/commands/view.h"
#include "cli/execution/conform.h"
#include "cli/execution/platform_host.h"
#include "cli/execution/replay.h"
#include "cli/execution/run.h"
#include "cli/execution/stubs.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "syntax/diagnostics/suggest.h"
#include "syntax/text/utf8.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <iostream>

#include <fcntl.h>

namespace {

/// Occupies the standard descriptors that are closed. Otherwise a file that is opened later could
/// get such a number, and receive output or be read as input.
void occupyStandardDescriptors() {
  for (int descriptor = 0; descriptor <= 2; ++descriptor)
    if (fcntl(descriptor, F_GETFD) == -1)
      (void)open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY);
}

/// Lost output makes a successful command fail.
int checkOutput(int exitCode) {
  std::cout.flush();
  return std::cout || exitCode != 0 ? exitCode
                                    : proskill::cli::fail("standard output cannot be written");
}

std::string failureMessage(const CLI::App* app, const CLI::Error& error) {
  const auto* command = app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  const std::string name = command == app ? "" : " " + command->get_name();
  const auto what = proskill::syntax::printable(error.what(), "\n\t");
  return "error: " + what + "\nrun `proskill" + name + " --help` for more\n";
}

std::vector<std::string> commandNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const auto* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

/// The first word, if it was meant as a command but is not one.
std::string unknownCommand(const CLI::App& app, int argc, char** argv) {
  const std::string word = argc > 1 ? argv[1] : "-";
  const auto names = commandNames(app);
  const bool known = std::ranges::find(names, word) != names.end();
  return word.starts_with('-') || known ? "" : word;
}

int failUnknownCommand(const CLI::App& app, const std::string& word) {
  const auto names = commandNames(app);
  const auto meant = proskill::syntax::nearest(word, names);
  std::string message = "there is no command `" + word + "`";
  if (!meant.empty()) message += "; did you mean `" + std::string(meant) + "`?";
  return proskill::cli::fail(message + "\nrun `proskill --help` for a list");
}

} // namespace

int main(int argc, char** argv) {
  using namespace proskill::cli;
  occupyStandardDescriptors();
  int exitCode = 0;
  CLI::App app{"Language tools and verifier for ProSkill, a language for the skills of robots",
               "proskill"};
  app.set_version_flag("--version", "proskill " PROSKILL_VERSION);
  app.require_subcommand(1);
  app.failure_message(failureMessage);
  useHelpFormat(app);
  app.footer("`proskill COMMAND --help` shows the options of a command, with examples.");
  for (auto add :
       {addCheck, addConform, addDap, addEmit, addExplain, addFmt, addGraph, addHelpData, addImport,
        addLsp, addPlatformHost, addReplay, addRun, addStubs, addVerify, addVerifyWorker, addView})
    add(app, exitCode);
  if (const auto word = unknownCommand(app, argc, argv); !word.empty())
    return failUnknownCommand(app, word);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return checkOutput(app.exit(error) == 0 ? 0 : kFailed);
  } catch (const std::bad_alloc&) {
    std::cerr << "error: out of memory; `--memory-limit` of `proskill verify` ends an exploration "
                 "before that, with what is decided by then\n";
    return kOutOfMemory;
  } catch (const std::exception& error) {
    std::cerr << "proskill: internal error: " << error.what() << '\n';
    return kInternalError;
  }
  return checkOutput(exitCode);
}
