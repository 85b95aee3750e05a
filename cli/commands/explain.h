#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill explain`: exit 0, or 2 where there is no such code.
void addExplain(CLI::App& app, int& exitCode);

} // namespace proskill::cli
