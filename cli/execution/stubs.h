#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill stubs`: exits with 0 if the files were written, 2 if not.
void addStubs(CLI::App& app, int& exitCode);

} // namespace proskill::cli
