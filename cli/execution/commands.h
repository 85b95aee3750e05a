#pragma once

namespace CLI {
class App;
}

/// The subcommands that execute programs. Each adds itself to the program, and sets the exit code
/// when it has run.
namespace proskill::cli {

/// `proskill run`: exits with 0 if the mission succeeded, 1 if it did not or something forbidden
/// happened, 2 for wrong usage, a program with errors or an incomplete recording, 3 if the run
/// ended before the mission.
void addRun(CLI::App& app, int& exitCode);

/// `proskill replay`: exits with 0 if all runs are possible and end as expected, 1 if not, 2 for
/// wrong usage.
void addReplay(CLI::App& app, int& exitCode);

/// `proskill conform`: exits with 0 if the recording is a run of the model, 1 if it is not, 2 for
/// wrong usage, 3 if this is not decided.
void addConform(CLI::App& app, int& exitCode);

/// `proskill stubs`: exits with 0 if the files were written, 2 if not.
void addStubs(CLI::App& app, int& exitCode);

/// `proskill platform-host`, which `--help` does not show: the process in which `proskill run` has
/// a shared library perform the actions.
void addPlatformHost(CLI::App& app, int& exitCode);

} // namespace proskill::cli
