#pragma once

namespace CLI {
class App;
}

/// The subcommands. Each adds itself to the program, and sets the exit code when it has run.
namespace proskill::cli {

/// `proskill check`: exits with 0 if there are no errors or warnings (hints do not count), 1 if
/// there are some, 2 for wrong usage or an unreadable file.
void addCheck(CLI::App& app, int& exitCode);

/// `proskill verify`: exits with 0 if all verdicts are good, 1 if some property is violated, 3 if
/// some are inconclusive because a limit was reached, 2 for wrong usage or a program with errors.
void addVerify(CLI::App& app, int& exitCode);

/// `proskill emit fiacre|tina|hfiacre`: exits with 0 if the model was written, 1 if the program has
/// errors, 2 for wrong usage or if the output cannot be written.
void addEmit(CLI::App& app, int& exitCode);

/// `proskill graph`: exits with 0 if the picture was drawn, 1 if the program has errors, 2 for
/// wrong usage or if the output cannot be written.
void addGraph(CLI::App& app, int& exitCode);

/// `proskill fmt`: exits with 0 if all files are formatted now; 1 with `--check` if a file is not;
/// 2 for wrong usage or a file that cannot be read or written.
void addFmt(CLI::App& app, int& exitCode);

/// `proskill explain`: exits with 0, or 2 if the code does not exist.
void addExplain(CLI::App& app, int& exitCode);

/// `proskill view`: exits with 0 when the user ends it, 2 for wrong usage.
void addView(CLI::App& app, int& exitCode);

/// `proskill lsp`: exits with 0 if the client sent `shutdown` first, 1 if it did not, 2 if the port
/// or the log file cannot be used.
void addLsp(CLI::App& app, int& exitCode);

/// `proskill dap`: exits with 0 if the client disconnected, 1 if the connection broke, 2 if the
/// port cannot be used.
void addDap(CLI::App& app, int& exitCode);

/// `proskill verify-worker`, hidden in `--help`: the process that verifies for `proskill lsp`.
void addVerifyWorker(CLI::App& app, int& exitCode);

} // namespace proskill::cli
