// The `proskill` program. Each subcommand has its own file, `cli/NAME.cpp`, and offers one
// function, `addNAME(CLI::App&, int& exitCode)`, which adds the subcommand with its options and
// leaves its result in `exitCode` when it has run. A new one is added in two places here: the
// include and the list in main().

#include "cli/check.h"
#include "cli/emit.h"
#include "cli/explain.h"
#include "cli/graph.h"
#include "cli/verify.h"

#include <CLI/CLI.hpp>

#include <exception>
#include <iostream>

namespace {

/// What sysexits.h calls EX_SOFTWARE: our own mistake, not the user's.
constexpr int kInternalError = 70;
constexpr int kUsage = 2;

} // namespace

int main(int argc, char** argv) {
  using namespace proskill::cli;
  int exitCode = 0;
  CLI::App app{"Language tools and verifier for ProSkill, a language for the skills of robots",
               "proskill"};
  app.set_version_flag("--version", "proskill " PROSKILL_VERSION);
  app.require_subcommand(1);
  app.failure_message(CLI::FailureMessage::simple);
  for (auto add : {addCheck, addEmit, addExplain, addGraph, addVerify}) add(app, exitCode);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kUsage;
  } catch (const std::exception& error) {
    std::cerr << "proskill: internal error: " << error.what() << '\n';
    return kInternalError;
  }
  return exitCode;
}
