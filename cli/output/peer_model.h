#pragma once

#include "cli/terminal/paint.h"
#include "codegen/model.h"

#include <string>

namespace proskill::cli {

/// Other model checkers that get a model.
enum class Peer : std::uint8_t { Spin, TChecker };

/// Writes the model of a program, or a model in Fiacre, for another model checker. Prints what the
/// text does not say to standard error. \return the exit code
/// \param output empty: standard output
int writePeerModel(Peer peer, const std::string& file, const std::string& output,
                   codegen::Options options, ColourChoice colour);

} // namespace proskill::cli
