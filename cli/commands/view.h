#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill view`: exits with 0 when the user ends it, 2 for wrong usage.
void addView(CLI::App& app, int& exitCode);

} // namespace proskill::cli
