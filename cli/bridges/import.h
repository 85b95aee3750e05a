#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill import`: exits with 0 if the program was written, 2 if the file has errors or for
/// wrong usage.
void addImport(CLI::App& app, int& exitCode);

} // namespace proskill::cli
