#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill stubs`: exit 0 written, 2 nothing was written.
void addStubs(CLI::App& app, int& exitCode);

} // namespace proskill::cli
