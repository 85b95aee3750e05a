#include "cli/output/checked_program.h"

#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "disk/disk.h"
#include "ide/snapshot/fiacre_file.h"
#include "report/run/mcap.h"
#include "report/text/render.h"
#include "report/text/source_place.h"
#include "syntax/text/utf8.h"

#include <algorithm>
#include <iostream>
#include <unistd.h>

namespace proskill::cli {

namespace {

/// Whether an error is that several skills could be the mission: it is at the first of them.
bool isUndecided(const analysis::Program& program, analysis::Location error) {
  const auto main = analysis::mainSkill(program);
  if (main.skill || main.candidates.size() < 2) return false;
  const auto* first = main.candidates[0];
  return error == first->at((*first)->name.range);
}

/// What a file is that is often named in the place of a program; empty otherwise.
std::string_view otherThanProgram(std::string_view text) {
  if (report::mcap::isMcap(text)) return "a recording in MCAP";
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || text[first] != '{') return "";
  return "a file of JSON, such as a recording or a report";
}

} // namespace

std::optional<analysis::Program> loadChecked(const std::string& root, ColourChoice colour) {
  if (ide::isFiacre(root)) {
    fail("`" + root +
         "` is a model in Fiacre, which only `check`, `verify`, `fmt`, `emit promela` and `emit "
         "tchecker` read");
    return std::nullopt;
  }
  const disk::DiskFileSystem disk;
  auto document = disk.document(root);
  if (!document) {
    fail("cannot read `" + root + "`: " + document.error());
    return std::nullopt;
  }
  if (const auto what = otherThanProgram(document->text()); !what.empty()) {
    fail("`" + root + "` is not a program, but " + std::string(what));
    return std::nullopt;
  }
  auto program = analysis::load(disk, root, std::move(*document));
  auto diagnostics = analysis::check(program);
  std::erase_if(diagnostics,
                [](const syntax::Diagnostic& it) { return it.severity == syntax::Severity::Hint; });
  render(std::cerr, program, diagnostics, report::Paint{wantsColour(colour, STDERR_FILENO)});
  const bool broken = std::ranges::any_of(diagnostics, [](const syntax::Diagnostic& it) {
    return it.severity == syntax::Severity::Error;
  });
  if (broken) return std::nullopt;
  return program;
}

int failGeneration(const analysis::Program& program, const codegen::GenerationError& error) {
  const report::SourcePlace at = report::SourcePlaces(program).begin(error.location);
  const auto path = program.files[error.location.file].path.generic_string();
  std::cerr << syntax::printable(path) << ':' << at.line << ':' << at.column
            << ": error: " << syntax::printable(error.message) << '\n';
  if (isUndecided(program, error.location))
    std::cerr << "  = help: choose one with `--main SKILL`\n";
  return kFailed;
}

int failUnsupported(const verify::Unsupported& error) {
  return fail("this model cannot be explored: " + error.message);
}

} // namespace proskill::cli
