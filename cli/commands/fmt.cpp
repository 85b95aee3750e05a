#include "cli/commands/commands.h"

#include "cli/output/unified_diff.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "disk/disk.h"
#include "disk/output.h"
#include "ide/snapshot/fiacre_file.h"
#include "syntax/format/format.h"
#include "syntax/text/utf8.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <iterator>
#include <memory>

namespace proskill::cli {

namespace {

namespace fs = std::filesystem;

struct FmtArguments {
  std::vector<std::string> files;
  bool check = false;
  bool diff = false;
};

std::expected<std::string, std::string> readFile(const std::string& file) {
  if (file != "-") return disk::DiskFileSystem().read(file);
  std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  if (std::cin.bad()) return std::unexpected("standard input cannot be read");
  return text;
}

/// Reports the parts that were not formatted.
void tellUntouched(const std::string& file, const syntax::Document& document) {
  for (auto range : syntax::unformattable(document)) {
    auto line = document.lines().position(range.begin).line + 1;
    std::cerr << (file == "-" ? "standard input" : syntax::printable(file)) << ':' << line
              << ": not formatted; run `proskill check` to see its errors\n";
  }
}

int writeBack(const std::string& file, const std::string& text) {
  if (file == "-") {
    auto failure = disk::writeOutput({}, text);
    return failure ? fail(*failure) : kDone;
  }
  auto failure = disk::writeFile(file, text);
  return failure ? fail(*failure) : kDone;
}

/// A text and its formatted form.
struct Layout {
  syntax::Document document;
  std::vector<syntax::TextEdit> edits;
};

Layout layOut(const std::string& file, std::string text) {
  auto document = syntax::Document::parse(std::move(text));
  auto edits = syntax::format(document);
  tellUntouched(file, document);
  if (edits.empty()) return {std::move(document), {}};
  const auto result = syntax::applyEdits(document.text(), edits);
  if (!syntax::sameTokens(document, syntax::Document::parse(result)))
    throw std::logic_error("formatting `" + file + "` would change more than white space");
  return {std::move(document), std::move(edits)};
}

/// Formats a Fiacre model. One with syntax errors is left unchanged.
Layout layOutFiacre(const std::string& file, std::string text) {
  auto edits = ide::formatFiacre(text);
  if (!edits)
    std::cerr << syntax::printable(file)
              << ": not formatted; run `proskill check` to see its errors\n";
  return {syntax::Document::parse(std::move(text)),
          edits.value_or(std::vector<syntax::TextEdit>{})};
}

int formatFile(const FmtArguments& arguments, const std::string& file) {
  auto text = readFile(file);
  if (!text) return fail("cannot read `" + file + "`: " + text.error());
  const auto [document, edits] =
      ide::isFiacre(file) ? layOutFiacre(file, std::move(*text)) : layOut(file, std::move(*text));
  if (arguments.diff) std::cout << forOutput(unifiedDiff(file, document, edits));
  if (arguments.check && !edits.empty() && !arguments.diff) std::cout << forOutput(file) << '\n';
  if (arguments.check || arguments.diff) return arguments.check && !edits.empty() ? kFound : kDone;
  if (edits.empty() && file != "-") return kDone;
  return writeBack(file, syntax::applyEdits(document.text(), edits));
}

int runFmt(const FmtArguments& arguments) {
  int code = kDone;
  for (const auto& file : arguments.files) code = std::max(code, formatFile(arguments, file));
  std::cout.flush();
  return std::cout ? code : fail("standard output cannot be written");
}

} // namespace

void addFmt(CLI::App& app, int& exitCode) {
  auto arguments = std::make_shared<FmtArguments>();
  auto* command = app.add_subcommand("fmt", "Format programs and models in Fiacre (.fcr)");
  command->add_option("file", arguments->files, "Files; `-` formats standard input")->required();
  show(command->add_flag("--check", arguments->check,
                         "Change nothing; list the files that would change"),
       group::kOutput);
  show(command->add_flag("--diff", arguments->diff, "Change nothing; print what would change"),
       group::kOutput);
  showBelow(*command, {"proskill fmt mission.proskill", "proskill fmt --check *.proskill"},
            {{kDone, "all files are formatted"},
             {kFound, "with --check: a file would change"},
             {kFailed, "the command line is wrong, or a file cannot be read or written"}});
  command->callback([arguments, &exitCode] { exitCode = runFmt(*arguments); });
}

} // namespace proskill::cli
