#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill replay`: exit 0 where all runs are possible and end as expected, 1 where not, 2 usage.
void addReplay(CLI::App& app, int& exitCode);

} // namespace proskill::cli
