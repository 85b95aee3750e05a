#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill explain`: exits with 0, or 2 if the code does not exist.
void addExplain(CLI::App& app, int& exitCode);

} // namespace proskill::cli
