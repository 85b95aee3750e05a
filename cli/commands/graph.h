#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill graph`: exit 0 drawn, 1 a program with errors, 2 usage, or nowhere to write to.
void addGraph(CLI::App& app, int& exitCode);

} // namespace proskill::cli
