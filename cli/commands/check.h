#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill check`: exits with 0 if there are no errors or warnings (hints do not count), 1 if
/// there are some, 2 for wrong usage or an unreadable file.
void addCheck(CLI::App& app, int& exitCode);

} // namespace proskill::cli
