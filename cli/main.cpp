// The `proskill` program. Each subcommand has a file of its own, such as `cli/commands/NAME.cpp`.
// Its function `addNAME`, declared in `commands.h` beside it, adds the subcommand with its options.
// A new subcommand is added there and to the list in main().

#include "cli/bridges/commands.h"
#include "cli/commands/commands.h"
#include "cli/execution/commands.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "cli/terminal/usage.h"

#include <CLI/CLI.hpp>

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
  return proskill::cli::usageMessage(*app, error);
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
  showBelow(app,
            {"proskill check mission.proskill", "proskill verify mission.proskill",
             "proskill run mission.proskill", "proskill verify --help"},
            {{kDone, "success"},
             {kFound, "the command found something: errors, violations, differences"},
             {kFailed, "the command line, a file or the program is wrong"},
             {kInconclusive, "a limit was reached before the answer"},
             {kDiffer, "two backends disagree"}});
  for (auto add : {addCheck, addConform, addDap, addEmit, addExplain, addFmt, addGraph, addHelpData,
                   addImport, addLsp, addPlan, addPlatformHost, addReplay, addRun, addStubs,
                   addVerify, addVerifyWorker, addView})
    add(app, exitCode);
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
