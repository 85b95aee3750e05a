#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill emit fiacre|tina|hfiacre`: exit 0 written, 1 a program with errors, 2 usage, or
/// nowhere to write to.
void addEmit(CLI::App& app, int& exitCode);

} // namespace proskill::cli
