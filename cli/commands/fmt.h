#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill fmt`: exit 0 all is laid out now, or was; 1 with `--check`, where a file is not; 2
/// usage, or a file that cannot be read or written.
void addFmt(CLI::App& app, int& exitCode);

} // namespace proskill::cli
