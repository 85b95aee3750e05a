#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

void addRun(CLI::App& app, int& exitCode);

} // namespace proskill::cli
