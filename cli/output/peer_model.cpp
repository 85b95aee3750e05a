#include "cli/output/peer_model.h"

#include "cli/output/checked_program.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "disk/disk.h"
#include "disk/output.h"
#include "ide/snapshot/fiacre_file.h"
#include "report/text/render.h"
#include "report/text/source_place.h"
#include "syntax/text/utf8.h"
#include "verify/export/export.h"

#include <fmt/format.h>

#include <iostream>
#include <unistd.h>

namespace proskill::cli {

namespace {

/// Says where in the program the part is that cannot be written.
int failAt(const analysis::Program& program, const codegen::Model& model,
           const verify::Unsupported& why) {
  if (why.origin == 0) return failUnsupported(why);
  const auto& origin = model.provenance.origins.at(why.origin);
  const auto at = report::SourcePlaces(program).begin({origin.file, {origin.begin, origin.end}});
  const auto path = program.files[origin.file].path.generic_string();
  std::cerr << syntax::printable(path) << ':' << at.line << ':' << at.column
            << ": error: " << syntax::printable(why.message) << '\n';
  return kFailed;
}

int write(Peer peer, const analysis::Program& program, const codegen::Model& model,
          const std::string& output) {
  std::vector<verify::Question> questions;
  std::vector<std::string> names;
  for (const auto& check : model.checks) {
    questions.push_back({check.property, check.fair, check.exempt, check.rests});
    names.push_back(check.name);
  }
  const auto made = peer == Peer::Spin
                        ? verify::exportPromela(model.fiacre, model.provenance, questions, names)
                        : verify::exportTChecker(model.fiacre, model.provenance, questions, names);
  if (!made) return failAt(program, model, made.error());
  if (const auto failed = disk::writeOutput(output, made->text)) return fail(*failed);
  for (const auto& note : made->notes) std::cerr << "note: " << syntax::printable(note) << '\n';
  return kDone;
}

int writeFiacre(Peer peer, const std::string& file, const std::string& output,
                ColourChoice colour) {
  auto text = disk::DiskFileSystem().read(file);
  if (!text) return fail(fmt::format("cannot read `{}`: {}", file, text.error()));
  const auto read = ide::readFiacre(file, std::move(*text));
  render(std::cerr, read.program, read.diagnostics,
         report::Paint{wantsColour(colour, STDERR_FILENO)});
  if (read.hasErrors()) return kFailed;
  if (!read.isModel())
    return fail(fmt::format("`{}` names no model: write the name of a component at its end", file));
  return write(peer, read.program, read.model, output);
}

} // namespace

int writePeerModel(Peer peer, const std::string& file, const std::string& output,
                   codegen::Options options, ColourChoice colour) {
  if (ide::isFiacre(file)) return writeFiacre(peer, file, output, colour);
  const auto program = loadChecked(file, colour);
  if (!program) return kFailed;
  const auto model = codegen::generate(*program, options);
  if (!model) return failGeneration(*program, model.error());
  return write(peer, *program, *model, output);
}

} // namespace proskill::cli
