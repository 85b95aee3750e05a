#include "cli/bridges/commands.h"

#include "bridge/bt/import.h"
#include "bridge/gen/import.h"
#include "bridge/rl/import.h"
#include "cli/bridges/edits.h"
#include "cli/output/bridge_report.h"
#include "cli/terminal/choice.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "disk/disk.h"
#include "disk/output.h"
#include "syntax/text/utf8.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <system_error>
#include <utility>

namespace proskill::cli {
namespace {

enum class Language : std::uint8_t { BehaviorTree, Components, Skillsets };

struct ImportArguments {
  Language language = Language::BehaviorTree;
  std::string file;
  std::string leaves;
  std::string main;
  std::string output;
  bool force = false;
};

/// The side file about leaves; without one, anything is allowed to them.
std::expected<bridge::Leaves, bridge::Errors> readLeaves(const std::string& path) {
  if (path.empty()) return bridge::Leaves();
  const auto bytes = disk::DiskFileSystem().read(path);
  if (!bytes) return std::unexpected(bridge::Errors{{{path}, "cannot read it: " + bytes.error()}});
  return bridge::Leaves::read(*bytes, path);
}

/// The folder of the program, seen from where the imported file is seen.
std::filesystem::path folderOf(const ImportArguments& arguments) {
  const auto here = std::filesystem::current_path();
  const auto folder =
      disk::isStream(arguments.output) ? here : (here / arguments.output).parent_path();
  const bool isAbsolute = std::filesystem::path(arguments.file).is_absolute();
  return isAbsolute ? folder : folder.lexically_proximate(here);
}

std::expected<bridge::Imported, bridge::Errors> imported(const ImportArguments& arguments,
                                                         const bridge::Leaves& leaves) {
  const disk::DiskFileSystem files;
  const auto folder = folderOf(arguments);
  switch (arguments.language) {
  case Language::BehaviorTree:
    return bridge::bt::importTree(files, arguments.file, leaves, folder, arguments.main);
  case Language::Components:
    return bridge::gen::importComponents(files, arguments.file, leaves, folder);
  case Language::Skillsets: return bridge::rl::importSkillsets(files, arguments.file, folder);
  }
  std::unreachable();
}

/// Errors for what would be lost if the output were replaced.
bridge::Errors lossOf(const std::filesystem::path& output, const std::string& imported) {
  std::error_code missing;
  if (!std::filesystem::is_regular_file(output, missing)) return {};
  const auto existing = disk::DiskFileSystem().read(output);
  if (existing) return editsIn(*existing, imported, output);
  return {{{output},
           fmt::format("it is unknown whether this file was edited, since it cannot be "
                       "read: {}. Replace it by `--force`",
                       existing.error())}};
}

int runImport(const ImportArguments& arguments) {
  if (disk::replaces(arguments.output, arguments.file))
    return fail("`-o` names the file that is read");
  if (!arguments.leaves.empty() && arguments.language == Language::Skillsets)
    return fail("`--leaves` is about behavior trees and components");
  if (!arguments.main.empty() && arguments.language != Language::BehaviorTree)
    return fail("`--main` is about behavior trees");
  const auto leaves = readLeaves(arguments.leaves);
  if (!leaves) return reportErrors(leaves.error());
  const auto made = imported(arguments, *leaves);
  if (!made) return reportErrors(made.error());
  // may become a part of another file
  const bool isPrinted = disk::isStream(arguments.output);
  const bool isAllowed = arguments.force || isPrinted;
  const auto loss = isAllowed ? bridge::Errors() : lossOf(arguments.output, made->text);
  if (!loss.empty()) return reportErrors(loss);
  const auto text = isPrinted ? made->text : withDigests(made->text);
  if (const auto failed = disk::writeOutput(arguments.output, text)) return fail(*failed);
  for (const auto& line : made->summary) std::cerr << syntax::printable(line) << '\n';
  return kDone;
}

} // namespace

void addImport(CLI::App& app, int& exitCode) {
  auto arguments = std::make_shared<ImportArguments>();
  auto* command = app.add_subcommand("import", "Translate a program of another language");
  addChoice<Language>(
      *command, "language", arguments->language,
      {{"bt", Language::BehaviorTree}, {"gen", Language::Components}, {"rl", Language::Skillsets}},
      "bt: XML of BehaviorTree.CPP v4; gen: components of GenoM3; rl: skillsets of "
      "the robot language, and composites of skills (.rlc)")
      ->required();
  command->add_option("file", arguments->file, "File to import, with what it includes")->required();
  show(command->add_option("-o,--output", arguments->output,
                           "Write to this file instead of standard output"),
       group::kOutput, "FILE");
  show(command->add_flag("--force", arguments->force,
                         "Replace the output even if it was edited since it was imported"),
       group::kOutput);
  show(command->add_option(
           "--leaves", arguments->leaves,
           "bt, gen: durations and results of actions, conditions and services, as JSON"),
       group::kAdvanced, "FILE");
  show(command->add_option("--main", arguments->main,
                           "bt: tree to import (default: the `main_tree_to_execute`)"),
       group::kSubject, "TREE");
  showBelow(*command,
            {"proskill import bt patrol.xml --leaves leaves.json -o patrol.proskill",
             "proskill import gen maneuver.gen -o maneuver.proskill",
             "proskill import rl turtle.rl -o turtle.proskill"},
            {{kDone, "the program was written"},
             {kFailed, "the file has errors, or the command line or the output is wrong"}});
  command->callback([arguments, &exitCode] { exitCode = runImport(*arguments); });
}

} // namespace proskill::cli
