#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill view`: exit 0 ended by the user, 2 usage.
void addView(CLI::App& app, int& exitCode);

} // namespace proskill::cli
