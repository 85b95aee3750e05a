#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill graph`: exits with 0 if the picture was drawn, 1 if the program has errors, 2 for
/// wrong usage or if the output cannot be written.
void addGraph(CLI::App& app, int& exitCode);

} // namespace proskill::cli
