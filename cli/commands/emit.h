#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill emit fiacre|tina|hfiacre`: exits with 0 if the model was written, 1 if the program has
/// errors, 2 for wrong usage or if the output cannot be written.
void addEmit(CLI::App& app, int& exitCode);

} // namespace proskill::cli
