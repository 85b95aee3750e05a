#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill fmt`: exits with 0 if all files are formatted now; 1 with `--check` if a file is not;
/// 2 for wrong usage or a file that cannot be read or written.
void addFmt(CLI::App& app, int& exitCode);

} // namespace proskill::cli
