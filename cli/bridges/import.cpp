#include "cli/bridges/import.h"

#include "bridge/bt/import.h"
#include "cli/terminal/choice.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "disk/disk.h"
#include "disk/output.h"
#include "syntax/text/utf8.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

namespace proskill::cli {
namespace {

enum class Language : std::uint8_t { BehaviorTree };

struct ImportArguments {
  Language language = Language::BehaviorTree;
  std::string file;
  std::string leaves;
  std::string output;
};

/// The side file about leaves; without one, anything is allowed to them.
std::expected<bridge::bt::Leaves, std::string> readLeaves(const std::string& path) {
  if (path.empty()) return bridge::bt::Leaves();
  const auto bytes = disk::DiskFileSystem().read(path);
  if (!bytes) return std::unexpected("cannot read `" + path + "`: " + bytes.error());
  auto leaves = bridge::bt::Leaves::read(*bytes);
  if (!leaves) return std::unexpected(path + ": " + leaves.error());
  return leaves;
}

int report(const bridge::bt::Errors& errors) {
  for (const auto& [place, message] : errors)
    std::cerr << syntax::printable(place.file.generic_string()) << ':' << place.line << ':'
              << place.column << ": error: " << syntax::printable(message) << '\n';
  return kFailed;
}

int runImport(const ImportArguments& arguments) {
  const auto leaves = readLeaves(arguments.leaves);
  if (!leaves) return fail(leaves.error());
  const auto imported = bridge::bt::importTree(disk::DiskFileSystem(), arguments.file, *leaves);
  if (!imported) return report(imported.error());
  if (const auto failed = disk::writeOutput(arguments.output, imported->text)) return fail(*failed);
  for (const auto& line : imported->summary) std::cerr << syntax::printable(line) << '\n';
  return kDone;
}

} // namespace

void addImport(CLI::App& app, int& exitCode) {
  auto arguments = std::make_shared<ImportArguments>();
  auto* command = app.add_subcommand("import", "Translate a program of another language");
  addChoice<Language>(*command, "language", arguments->language, {{"bt", Language::BehaviorTree}},
                      "bt: XML of BehaviorTree.CPP v4")
      ->required();
  command->add_option("file", arguments->file, "File to import, with what it includes")->required();
  show(command->add_option("-o,--output", arguments->output,
                           "Write to this file instead of standard output"),
       group::kOutput, "FILE");
  show(command->add_option("--leaves", arguments->leaves,
                           "bt: durations and results of actions and conditions, as JSON"),
       group::kAdvanced, "FILE");
  showBelow(*command, {"proskill import bt patrol.xml --leaves leaves.json -o patrol.proskill"},
            {{kDone, "the program was written"},
             {kFailed, "the file has errors, or the command line or the output is wrong"}});
  command->callback([arguments, &exitCode] { exitCode = runImport(*arguments); });
}

} // namespace proskill::cli
