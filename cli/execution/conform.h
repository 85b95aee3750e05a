#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

void addConform(CLI::App& app, int& exitCode);

} // namespace proskill::cli
