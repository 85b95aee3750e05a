#include "cli/execution/commands.h"

#include "host/host.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

namespace proskill::cli {

void addPlatformHost(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand("platform-host", "Perform actions for `proskill run`");
  command->group("");
  auto library = std::make_shared<std::string>();
  auto functions = std::make_shared<std::vector<std::string>>();
  command->add_option("library", *library, "The shared library")->required();
  command->add_option("functions", *functions, "SKILL=FUNCTION, where it has another name");
  command->callback([library, functions, &exitCode] {
    std::map<std::string, std::string> named;
    for (const auto& word : *functions)
      named[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
    exitCode = host::runLibrary(*library, named);
  });
}

} // namespace proskill::cli
